// A block's step function, free of loops and memory -> a module of the netlist.
//
// Starts at what is stored to outputs, next values and instance inputs and follows operands, so
// that only what matters is converted, in an order that the source alone decides.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include "generator/ir/step.hpp"

namespace hlsgen {

// Refuses what depends on a value that nobody has written.
Module convert(const Step& step, const Block& block, const Opaque& opaque);

}  // namespace hlsgen
