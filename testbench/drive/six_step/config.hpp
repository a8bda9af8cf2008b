// The configuration of a six-step drive as the blocks take it (testbench/engine/config_by_name.hpp).
//
// Test: tests/testbench/engine_test.cpp
#pragma once

#include "hls/six_step/config.hpp"
#include "model/design/config.hpp"

namespace steplock {

SixStepConfig hls_config(const design::Config&);

}  // namespace steplock
