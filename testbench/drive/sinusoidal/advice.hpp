// What to change in the file of a sinusoidal drive, where the cause can be told from motor and record: after a run that failed, and
// after one whose rotor swings.
//
// Each line names the key and a value; the test follows each and runs again.
//
// Doc: docs/report.md   Test: tests/testbench/advice_test.cpp
#pragma once

#include <string>
#include <vector>

#include "testbench/drive/sinusoidal/run.hpp"

namespace steplock::sinusoidal {

std::vector<std::string> advice(const design::Settings&, const Result&, const Record&);

}  // namespace steplock::sinusoidal
