// Quantities as drive files write them: a number and its unit, "188 uH", "2.7e-3 kg m^2", "50 %".
//
//     unit    = factor { ["*" | "/" | " "] factor }        "/" divides the one factor behind it
//     factor  = [SI prefix] base ["^" [-] digits]
//     base    = m g s A V ohm H F Wb N W J Hz rpm rad deg turn min %
//
// An angle counts as a dimension of its own, so "50 Hz" (turns per second), "3000 rpm" and
// "314 rad/s" are the same kind of thing with the right factors, while "1/s" is not.  Where an
// angle is divided by (V s/rad, N m s/rad) it may be left out, as data sheets do.
//
// Doc: docs/drive_file.md   Test: tests/testbench/quantity_test.cpp
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace steplock {

struct Unit {
  double factor = 1;                 // into SI with radians
  std::array<int, 5> exponent = {};  // of m, kg, s, A, rad

  // Whether a value in `given` may stand where this unit is asked for.
  bool accepts(const Unit& given) const;
};

struct Quantity {
  double value = 0;   // in SI
  std::string unit;   // as written
  Unit dimension;
};

std::optional<Unit> parse_unit(std::string_view text);         // "" is the number 1
std::optional<Quantity> parse_quantity(std::string_view text);  // nothing if it is no quantity

}  // namespace steplock
