// A number cut to fewer bits that stops at its ends, found in the choices that it was made of.
//
//     x < -128 ? -128 : 127 < x ? 127 : x[7:0]     ->  clamp x to 8 bits
//
// The choices are followed down to constants and bits of one number; its conditions divide the
// integers into stretches, and each stretch is looked at: whatever form the conditions have, what is
// found is a clamp for every integer.
//
// Test: tests/generator/machine_test.cpp

#pragma once

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
  Clamps(const Module& sample, const std::vector<Known>& known) : m_(sample), known_(known) {}
  std::optional<Clamp> find(NodeId choice) const;

 private:
  const Module& m_;
  const std::vector<Known>& known_;
};

}  // namespace hlsgen::machine
