#include "testbench/run/check.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace steplock {
namespace {

std::string short_text() {
  std::ifstream in(STEPLOCK_TESTS "/short.toml");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

int line_with(const std::string& text, const std::string& what) {
  const std::size_t at = text.find(what);
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
}

std::string refusal(const std::string& text) {
  try {
    check_drive_file(parse_drive_file(text, "x.toml"));
  } catch (const BadInput& e) {
    return e.what();
  }
  return "accepted";
}

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = short_text();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos);
  return text.replace(at, from.size(), to);
}

TEST(Check, TheDriveOfTheTestsIsSound) { EXPECT_EQ(refusal(short_text()), "accepted"); }

TEST(Check, AContradictoryScenarioIsRefusedAtItsLine) {
  const std::string text = replaced("load_off_s = 0.52", "load_off_s = 0.1");
  EXPECT_EQ(refusal(text),
            "x.toml:" + std::to_string(line_with(text, "load_off_s")) +
                ": scenario.load_off_s is 0.1 s; must come after load_step_s, 0.4 s");
}

// Each key is in range; together they make no motor, which only the plant can tell.
TEST(Check, WhatThePlantRefusesIsTracedToTheKeyOfTheFile) {
  const std::string text = replaced("flux_vs = 6.37e-3", "flux_vs = 6.37e-3\nmutual_h = 0.3e-3");
  const std::string lines = refusal(text);
  EXPECT_EQ(lines.find("x.toml:"), 0u) << lines;
  EXPECT_NE(lines, "accepted");
}

TEST(Check, EveryDriveOfTheProjectIsSound) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(STEPLOCK_DRIVES)) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_NO_THROW(open_drive_file(entry.path().string())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 7);  // the paper's motor and six real ones
}

}  // namespace
}  // namespace steplock
