// What a run leaves behind: samples of plant and drive, the drive's changes of state, and totals.
//
// Totals run from the start, so that the mean or rms value over any span is a difference of two
// samples divided by its length.  Angles in rad, times in s, everything else as the name says.
//
// Doc: docs/report.md   Test: tests/testbench/run_drive_test.cpp
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "testbench/drive/six_step/watch.hpp"
#include "testbench/run/simulated.hpp"

namespace steplock {

struct Totals {
  double current_squared = 0;       // A^2 s, mean of the three phases
  double commutation_deg = 0;       // sum over judged commutations of the error, electrical
  double commutation_squared = 0;
  std::uint64_t commutations = 0;
  double phase_error_squared = 0;   // deg^2, of the phase detector, at each commutation
};

struct Sample {
  double time = 0;
  plant::State plant;
  DriveView drive;
  Watch watch;
  double load_nm = 0;
  double commutation_error_deg = 0;  // of the last commutation, from the true angle
  Totals totals;
};

struct StateChange {
  double time = 0;
  State state = State::kIdle;
  Reason reason = Reason::kNone;
};

struct Record : Simulated {
  std::vector<Sample> overview;  // equally spaced over the whole run
  std::vector<Sample> lock;      // fine, from hand-over to a little after lock
  std::vector<Sample> steady;    // fine, the last turns before the first disturbance
  std::vector<StateChange> changes;
  std::uint64_t step_outs = 0;   // as the plant saw them
};

}  // namespace steplock
