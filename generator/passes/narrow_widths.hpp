// Every operator as narrow as its result is read or can be.
//
//     (zext a + zext b)[7:0]            =>  a + b in 8 bits
//     sext(a, 32) * sext(b, 32)         =>  sext(a * b in |a| + |b| bits)
//     zext(a, 32) == zext(b, 32)        =>  a == b
//     x & 32'h00ff                      =>  zext(x[7:0])
//     sext of what is never negative    =>  zext
//     a value of which all bits are known or do not matter    =>  a constant
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

bool narrow_widths(Module& module);

}  // namespace hlsgen
