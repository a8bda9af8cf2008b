// Bits that only move.
//
//     x[7:0] of x[15:4]           =>  x[11:4]
//     {a, b}[7:2]                 =>  {a[..], b[..]}
//     zext(zext x), sext(zext x)  =>  zext x
//     {0, x}                      =>  zext x
//     {sign of x, x}              =>  sext x
//     {x[7:4], x[3:0]}            =>  x
//     (a & b)[7:4], read once     =>  a[7:4] & b[7:4]      likewise | ^ ~ and mux
//
// Test: tests/generator/backend_pass_test.cpp

#pragma once

#include "generator/netlist.hpp"

namespace hlsgen {

bool simplify_wiring(Module& module);

}  // namespace hlsgen
