// A group of random blocks as both of its compiled forms, in step: C++ and Verilated print.
//
// The harness knows neither class: numbers cross as words, in the order of the members.  So each
// group is compiled without LLVM and GoogleTest, and the harness once.
//
// Test: tests/generator/random/random_test.cpp

#pragma once

#include "generator/port_words.hpp"

#include <memory>
#include <string>
#include <vector>

namespace hlsgen::test {

using Words = std::vector<steplock::ports::Word>;

class Forms {
 public:
  virtual ~Forms() = default;
  // One clock of both.  Gives what the C++ gave; `differing` becomes the first port at which the
  // print gave something else, or null.  `is_wrong` turns one bit of what the C++ gave before they
  // meet.
  virtual Words clock(const Words& in, bool is_wrong, const char*& differing) = 0;
};

std::unique_ptr<Forms> make_forms();
extern const char* const kGroupSource;  // what hlsgen read
extern const int kPace;  // clocks in which as much happens as in one of a block without a schedule

}  // namespace hlsgen::test
