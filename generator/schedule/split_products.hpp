// Products that fit a multiplier: a wider one becomes a sum of narrower ones.
//
//     a * b, a of 24 bits, 16 x 16 available
//         ->  ((a[23:15] * b) << 15) + a[14:0] * b     only the uppermost part has a sign
//
// A product fits when one factor, taken as a signed number of as few bits as it is known to need,
// has `width` bits at most and the other `second_width`.
//
// Test: tests/generator/schedule_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

bool split_products(Module& module, unsigned width, unsigned second_width);

}  // namespace hlsgen
