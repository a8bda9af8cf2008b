// Flip-flops that take asynchronous pins, found by their shape.
//
//     first <= pin_i;  second <= first;      and nothing but `second` reads `first`
//
// Both registers of such a pair are marked for the vendors' tools, which then keep them, put them
// side by side, and make no shift register of them.  A pair that merely delays an input is marked
// as well, which costs it nothing.  Yosys knows none of the marks, and so removes a pair that no
// one reads.
//
// Doc: docs/generator.md   Test: tests/generator/clocked_print_test.cpp
#pragma once

#include <vector>

#include "generator/netlist.hpp"

namespace hlsgen {

// One per register.
std::vector<bool> find_synchronisers(const Module& module);

// The attributes of Vivado, of Synplify and Lattice's own synthesis, and of Quartus.
inline constexpr const char* kSynchroniserMarks =
    "(* ASYNC_REG = \"TRUE\", syn_preserve = 1,\n"
    "     altera_attribute = \"-name SYNCHRONIZER_IDENTIFICATION FORCED\" *)";

}  // namespace hlsgen
