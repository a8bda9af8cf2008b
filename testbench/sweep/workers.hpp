// Does numbered tasks in several processes; each task's result is one line of text.
//
// Processes, not threads: nothing of the simulation needs to know that it is not alone, and one that
// dies takes no result with it.  Tasks are handed out one by one, in order.
//
// Doc: docs/sweep.md   Test: tests/testbench/workers_test.cpp
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace steplock {

struct Tasks {
  std::uint64_t count = 0;
  int jobs = 1;
  // In a worker: the result, at most 4000 bytes in one line, or nothing if go_on() became false.
  std::function<std::optional<std::string>(std::uint64_t task, const std::function<bool()>& go_on)> work;
  // Here, as results come: in no certain order.
  std::function<void(const std::string&)> take;
  // Here, some times a second; false stops the workers, which leave their present tasks undone.
  std::function<bool()> go_on;
};

// Throws std::runtime_error with what a worker threw, or if one dies; results so far were taken.
void do_in_processes(const Tasks&);

}  // namespace steplock
