// A number cut to fewer bits that stops at its ends, found in the choices that it was made of.
//
//     x < -128 ? -128 : 127 < x ? 127 : x[7:0]     ->  clamp x to 8 bits
//
// The choices are followed down to constants and bits of one number; its conditions divide the
// integers into stretches, and each stretch is looked at: whatever form the conditions have, what is
// found is a clamp for every integer that the number can be.  Conditions may ask what the number was
// made of instead, through sums with constants and products with positive ones: x * 3 < 0 for x < 0.
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include <functional>
#include <optional>

#include "generator/machine/program.hpp"
#include "generator/passes/known_bits.hpp"

namespace hlsgen::machine {

struct Clamp {
  NodeId of = kNone;
  bool of_signed = true;
  unsigned shift = 0;  // before
  unsigned width = 0;
  bool is_signed = true;
};

class Clamps {
 public:
  using RangeOf = std::function<Range(NodeId)>;  // of a node as a signed integer

  Clamps(const Module& sample, const std::vector<Known>& known, RangeOf range)
      : m_(sample), known_(known), range_(std::move(range)) {}
  std::optional<Clamp> find(NodeId choice) const;

 private:
  const Module& m_;
  const std::vector<Known>& known_;
  RangeOf range_;
};

}  // namespace hlsgen::machine
