// The blocks of the sinusoidal drive and their RTL side by side, with the ADCs of both.
//
// Test: tests/testbench/sinusoidal_engines_test.cpp
#pragma once

#include "testbench/engine/lockstep_engine.hpp"
#include "testbench/sinusoidal/rtl_engine.hpp"

namespace steplock::sinusoidal {

using LockstepEngine = LockstepOf<FixedEngine, RtlEngine>;

}  // namespace steplock::sinusoidal
