// What is kept in registers, and from when until when.
//
// A value that is read in a later step than it comes in has to be kept, or its operands have to be,
// and it is there again whenever they are: logic costs nothing a second time.  All are kept at
// first; then each is left to its operands as long as that needs fewer bits, and as long as the
// delays allow it.
//
//     e = i_set - i      operands held      nothing is kept
//     p = a * b >> 14    32 bits, then 18   the 18 are kept
//
// A register of the block takes its next value as soon as it is there, when nobody reads the old
// one any more ("early"); all others, and the outputs, take theirs in the last step.
//
// Test: tests/generator/schedule_test.cpp

#pragma once

#include "generator/schedule/order.hpp"

#include <llvm/ADT/BitVector.h>

namespace hlsgen::scheduling {

// How a reader gets at a value.
enum class Way : std::uint8_t { kDirect, kKept };

struct Keeping {
  std::vector<bool> kept;        // per node: in a register of its own, or in an early one
  std::vector<unsigned> from;    // the step at whose end the register takes it
  std::vector<unsigned> until;   // the last step that reads it
  std::vector<llvm::BitVector> times;  // per node: the steps in which its operands are read
  std::vector<bool> early;       // per register of the block
  std::vector<NodeId> early_of;  // per node: early register + 1 that keeps it, or 0
  unsigned longest = 0;          // delay between two registers, in quarters of a level

  Way way(NodeId operand, unsigned step) const {
    return kept[operand] && step > from[operand] ? Way::kKept : Way::kDirect;
  }
};

Keeping keep(const Operations& operations, const Order& order);

}  // namespace hlsgen::scheduling
