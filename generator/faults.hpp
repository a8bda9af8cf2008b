// What ends hlsgen without an exception, an abort of LLVM's or a broken pointer, ends in one line too:
//
//     hlsgen: internal error: hls/x.cpp: LLVM: out of registers, while reading the C++; please report it with this source
//
// and with the exit code 2 of its own faults.  No file has been written then: they all are at the end.
//
// Test: tests/generator/frontend/faults_test.cpp
#pragma once

#include <string>

namespace hlsgen {

// From here on.
void name_faults(const std::string& source);

// What is being done, as part of that line: "reading the C++".
void working_on(const std::string& what);

}  // namespace hlsgen
