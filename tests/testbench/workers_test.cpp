// Tasks in other processes.
#include "testbench/sweep/workers.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <set>
#include <stdexcept>

namespace steplock {
namespace {

// Does the tasks and returns what came back.
std::multiset<std::string> results(Tasks tasks) {
  std::multiset<std::string> lines;
  tasks.take = [&](const std::string& line) { lines.insert(line); };
  if (!tasks.go_on) tasks.go_on = [] { return true; };
  do_in_processes(tasks);
  return lines;
}

TEST(Workers, EveryTaskIsDoneOnceHoweverManyDoThem) {
  for (const int jobs : {1, 2, 5}) {
    const auto lines = results({.count = 300, .jobs = jobs, .work = [](std::uint64_t k, const auto&) {
                                  return std::optional(std::to_string(k) + std::string(1000, 'x'));
                                }, .take = {}, .go_on = {}});
    EXPECT_EQ(lines.size(), 300u);
    EXPECT_EQ(std::set<std::string>(lines.begin(), lines.end()).size(), 300u);
    for (const auto& line : lines) EXPECT_EQ(line.size(), std::to_string(std::stoi(line)).size() + 1000);
  }
}

TEST(Workers, NoTaskIsNoResult) {
  EXPECT_TRUE(results({.count = 0, .jobs = 2, .work = {}, .take = {}, .go_on = {}}).empty());
}

TEST(Workers, WhatAWorkerThrowsArrives) {
  const auto work = [](std::uint64_t k, const auto&) -> std::optional<std::string> {
    if (k == 5) throw std::runtime_error("no more of this");
    return "done";
  };
  try {
    results({.count = 50, .jobs = 2, .work = work, .take = {}, .go_on = {}});
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "no more of this");
  }
}

TEST(Workers, ADeadWorkerIsReported) {
  const auto work = [](std::uint64_t, const auto&) -> std::optional<std::string> {
    raise(SIGKILL);
    return "";
  };
  EXPECT_THROW(results({.count = 2, .jobs = 1, .work = work, .take = {}, .go_on = {}}), std::runtime_error);
}

TEST(Workers, StoppingLeavesTasksUndoneAndKeepsResults) {
  int taken = 0;
  Tasks tasks{.count = 1000000, .jobs = 2, .work = [](std::uint64_t, const auto& go_on) {
                usleep(2000);
                return go_on() ? std::optional<std::string>("done") : std::nullopt;
              }, .take = [&](const std::string&) { ++taken; }, .go_on = [&] { return taken < 20; }};
  do_in_processes(tasks);
  EXPECT_GE(taken, 20);
  EXPECT_LT(taken, 1000);
}

}  // namespace
}  // namespace steplock
