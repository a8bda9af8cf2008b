// Which register keeps what, and which factor goes where.
//
// Values whose times do not meet share a register: in the order of their beginning, each goes into
// the one that fits it best (left edge).  A choice in front of a register costs some two thirds of a
// logic cell per bit, a register of its own up to one.  A product's factors are exchanged where that
// saves a source of the multiplier's.
//
// Test: tests/generator/schedule_test.cpp

#pragma once

#include "generator/schedule/keep.hpp"

namespace hlsgen::scheduling {

struct Shared {
  unsigned width = 0;
  std::vector<NodeId> values;  // in the order of time
};

struct Binding {
  std::vector<Shared> registers;
  std::vector<unsigned> place;   // per kept node: its register
  std::vector<bool> exchanged;   // per product
};

// `needs` are the bits of each product's two factors.
Binding bind(const Operations& operations, const Order& order, const Keeping& keeping,
             const std::vector<std::pair<unsigned, unsigned>>& needs);

}  // namespace hlsgen::scheduling
