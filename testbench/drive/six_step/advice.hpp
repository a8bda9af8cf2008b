// What to change in the file of a six-step drive after a run that failed, where the cause can be told from motor and record.
//
// Each line names the key and a value that the run passes with; the test follows each and runs again.
//
// Doc: docs/report.md   Test: tests/testbench/advice_test.cpp
#pragma once

#include <string>
#include <vector>

#include "testbench/drive/six_step/summary.hpp"

namespace steplock {

// None if the run passed, or where nothing is known.
std::vector<std::string> advice(const design::Settings&, const Summary&, const Record&);

}  // namespace steplock
