// The first lines of a sweep's page: its title, with what it was printed, which test holds it, and who chose the seed.
//
// Doc: docs/sweep.md   Test: tests/testbench/beyond_goals_test.cpp
#pragma once

#include <fmt/format.h>

#include <string>

#include "testbench/sweep/setup.hpp"

namespace steplock {

// `command` printed it where the seed follows from what is judged, else `steplock sweep` with the arguments `sweep`.
inline std::string page_head(const SweepSetup& setup, const char* title, const char* command, const char* sweep,
                             const char* page, const char* test) {
  const std::string outside = setup.kind.outside > 0 ? fmt::format(" --outside {:g}", setup.kind.outside) : "";
  std::string t = fmt::format("# {}\n\nPrinted by ", title);
  t += setup.judged.empty() ? fmt::format("`steplock sweep {} --runs {} --seed {}{} --page {}`", sweep, setup.runs,
                                          setup.kind.seed, outside, page)
                            : fmt::format("`{} {}`", command, setup.runs);
  t += fmt::format("; the test `{}` repeats its first runs and fails when they are not the page's.\n\n", test);
  if (!setup.judged.empty()) {
    t += fmt::format("Nobody chose the seed, {}: it follows from a digest ({}) of what is judged ([blocks, design, drive files and "
                     "judge](sweep.md#the-published-page)), so that nothing was tuned on these motors.\n\n",
                     setup.kind.seed, setup.judged.substr(0, 16));
  }
  return t;
}

}  // namespace steplock
