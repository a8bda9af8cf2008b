// What the datapath does to integers, whatever node they come from.
//
//     cut       bits from one place on, as a number with or without a sign
//     raised    a power of 2 times as much: by the multiplier, or doubled
//     times     a product; a factor that is too wide for the multiplier is taken in two parts
//     both      x & y, x & ~y, ~x & ~y and their opposites, as one sum each but for the first's opposite
//
// Ranges say what has to be cut, and which factors fit.
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/machine/program.hpp"

namespace hlsgen::machine {

class Integers {
 protected:
  ValueId cut(ValueId value, unsigned low, unsigned to, bool is_signed);
  // Modulo 2^to.
  ValueId raised(ValueId value, unsigned by, unsigned to, bool is_signed);
  // In the format of `i`.
  ValueId times(ValueId x, ValueId y, Instruction i);
  // Of bits: both, where `falls` the opposite of one, or the opposite of that.
  ValueId both(const ValueId of[2], const bool falls[2], bool turned, Instruction i);
  ValueId opposite(ValueId bit, Instruction i);

  Program p_;

 private:
  bool fits(ValueId v, unsigned bits) const { return p_.values[v].range.bits() <= bits; }
};

}  // namespace hlsgen::machine
