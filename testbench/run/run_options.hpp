// How a run is asked for, of either drive: by which engine, from which angle, and who looks on.
//
// Test: tests/testbench/run_drive_test.cpp
#pragma once

#include <functional>
#include <stdexcept>

#include "model/plant/plant.hpp"

namespace steplock {

class TraceWriter;

// Thrown where the user stopped something of which a part would be of no use.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

enum class EngineKind { kRtl, kFixed, kFloat };
const char* name_of(EngineKind);

struct RunOptions {
  EngineKind engine = EngineKind::kRtl;
  double angle_deg = 0;          // electrical, of the rotor at t = 0
  TraceWriter* trace = nullptr;
  bool lockstep = false;         // kRtl: its blocks beside it, every output on every clock
  // Called some ten times a second with the fraction done; false stops the run, which then holds
  // what was simulated so far.
  std::function<bool(double done)> progress = {};
  // Called every 32,768 clocks: motor, and the name of the drive's state.
  std::function<void(const plant::State&, const char* state)> watch = {};
};

}  // namespace steplock
