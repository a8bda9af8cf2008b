// Runs the scenario of a six-step drive's file with one of the engines, from gates off to the last event.
//
// Doc: docs/steplock.md   Test: tests/testbench/run_drive_test.cpp
#pragma once

#include "testbench/drive/six_step/recorder.hpp"
#include "testbench/run/drive_loop.hpp"

namespace steplock {

// The settings must be sound (check_drive_file()).
Record run_drive(const design::Settings&, const RunOptions&);

template <class Engine>
Record run_with(Engine& engine, const design::Settings& s, const RunOptions& options) {
  return run_recorded<Engine, Recorder>(engine, s, options);
}

}  // namespace steplock
