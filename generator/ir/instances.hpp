// Calls of a child's tick -> the child's ports.
//
//     out = vco.tick(in);     ->     @vco.in.step = in.step; ...   out.phase = @vco.out.phase; ...
//
// Refuses a child that is ticked twice, under a condition, or never.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/refusal_test.cpp

#pragma once

#include "generator/ir/step.hpp"

namespace hlsgen {

// After the loops are gone; brings step.instances into the order of call.
void cut_instances(Step& step, const Blocks& blocks, Opaque& opaque);

// After optimisation: refuses a parent that wrote registers of a child; drops the witnesses.
void check_instances(Step& step, const Block& block);

}  // namespace hlsgen
