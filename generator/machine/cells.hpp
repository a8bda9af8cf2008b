// Which number has which cell of the memory.
//
//     two for each register    its value, its reset value
//     one for each constant
//     the rest, reused         what an instruction made, from its writing to its last reading
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/machine/order.hpp"

namespace hlsgen::machine {

// `writers` are the instructions that make the registers' next values, `last_read` the clocks in which
// values are read from the memory for the last time, or 0.  Gives `order` its cells.
void give_cells(const Program& p, const std::vector<unsigned>& writers,
                const std::vector<unsigned>& last_read, Order& order);

}  // namespace hlsgen::machine
