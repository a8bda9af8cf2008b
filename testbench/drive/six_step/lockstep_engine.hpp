// The blocks of the six-step drive and their RTL side by side.
//
// Test: tests/testbench/engine_test.cpp
#pragma once

#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/rtl_engine.hpp"
#include "testbench/engine/lockstep_of.hpp"

namespace steplock {

using LockstepEngine = LockstepOf<FixedEngine, RtlEngine>;

}  // namespace steplock
