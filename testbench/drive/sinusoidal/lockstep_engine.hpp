// The blocks of the sinusoidal drive and their RTL side by side, with the ADCs of both.
//
// Test: tests/testbench/sinusoidal_engines_test.cpp
#pragma once

#include "testbench/drive/sinusoidal/rtl_engine.hpp"
#include "testbench/engine/lockstep_of.hpp"

namespace steplock::sinusoidal {

using LockstepEngine = LockstepOf<FixedEngine, RtlEngine>;

}  // namespace steplock::sinusoidal
