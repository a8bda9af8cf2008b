// Replays a list of gate events into a plant and samples it on a fixed grid, so that others can
// check the plant against their own circuit simulator.
//
// Events hold until the next one (zero-order hold); before the first one all gates are off.
// Samples lie at 0, dt, 2 dt, ... up to and including `duration` (within half a dt).  A sample on
// an event's instant shows the circuit after the event.
//
// Doc: docs/plant.md   Test: tests/model/plant/replay_test.cpp
#pragma once

#include <functional>
#include <span>

#include "model/plant/plant.hpp"

namespace steplock::plant {

struct GateEvent {
  double time = 0;  // s, not falling from one event to the next
  Gates gates = {};
  double load_torque = 0;  // N m, opposing, >= 0
};

struct Sample {
  double time;         // s
  double iu, iv, iw;   // A, into the motor
  double vu, vv, vw;   // V, terminals against ground
  double speed_rad_s;  // mechanical
  double angle_rad;    // mechanical rotor angle, unwrapped
  double neutral_v;    // star point
  double bus_v;        // at the bridge
  double source_a;     // out of the source
  double torque_nm;    // electromagnetic
};

// Throws std::invalid_argument on unordered or negative times, dt <= 0 or duration < 0.
void replay(const Parameters&, const InitialState&, std::span<const GateEvent>, double dt,
            double duration, const std::function<void(const Sample&)>& take);

}  // namespace steplock::plant
