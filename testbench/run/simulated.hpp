// What every run has to tell, whichever drive it is of: a Record begins with it.
//
// Test: tests/testbench/run_drive_test.cpp
#pragma once

#include <cstdint>
#include <optional>

#include "testbench/engine/lockstep.hpp"

namespace steplock {

struct Simulated {
  double peak_current = 0;           // A, of any phase
  std::uint64_t shoot_throughs = 0;  // as the plant saw them
  std::uint64_t clocks = 0;
  double simulated_s = 0, wall_s = 0, cpu_s = 0;
  double energy_residual = 0;        // of the energy supplied; the plant's own accuracy
  bool interrupted = false;
  std::optional<Lockstep> lockstep;  // if asked for
};

}  // namespace steplock
