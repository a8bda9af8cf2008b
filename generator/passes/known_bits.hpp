// What is known about every value before the module runs: bits that are always 0 or 1, and how many
// of the top bits are copies of the sign.
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

#include <llvm/Support/KnownBits.h>

#include <vector>

namespace hlsgen {

struct Known {
  llvm::KnownBits bits;
  unsigned sign_copies = 1;  // the sign itself included

  unsigned unsigned_width() const {  // bits that can be set, at least one
    return std::max(1u, bits.getBitWidth() - bits.countMinLeadingZeros());
  }
  unsigned signed_width() const { return bits.getBitWidth() - sign_copies + 1; }
};

std::vector<Known> known_bits(const Module& module);

}  // namespace hlsgen
