// How small a change of each coefficient of the reference shows, update by update: the sensitivity of law_errors.hpp, in what a run
// and the corners gave the blocks.
//
// Doc: docs/coefficients.md   Test: tests/testbench/law_errors_test.cpp
#pragma once

#include <string>
#include <vector>

#include "testbench/compare/law_errors.hpp"

namespace steplock {

struct Sensitivity {
  std::string name, unit;        // as the register words are named
  double value = 0;              // what the word stands for
  double asked = 0;              // the change that has to be noticed
  double least = 0;              // of those that are, the least to a tenth of it; 0: not even a hundred times what is asked
  bool noticed() const { return least > 0 && least <= asked; }
};

// What was told to the blocks, and beside it all that the reference is given.
struct Told {
  LawInputs run, corners;
  design::Parameters parameters;  // for which the words stand
  double clock_hz = 0;
};
Told told_of(const design::Settings&, double angle_deg, const std::function<bool(double done)>& progress = {});

// Asked for: a percent of each coefficient of detector, loop filter and speed control, 100 ns of a delay, a last place of a phase.
std::vector<Sensitivity> sensitivities(const Told&);

struct CoefficientsOf {
  std::string drive;
  std::vector<LawError> errors;          // in run and corners, with the words' own coefficients
  std::vector<Sensitivity> coefficients;
  // The law is as the block, the reference within its bounds, and every change that is asked for beyond them.
  bool passed() const;
};
CoefficientsOf coefficients_of(const std::string& drive, const Told&);

// The page, in Markdown.
std::string coefficients_page(const std::vector<CoefficientsOf>&);

}  // namespace steplock
