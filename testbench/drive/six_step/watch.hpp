// What the bench sees of a six-step drive, whichever engine plays it.
//
// Watch is looked at on every clock and so is one packed word that changes when something happened;
// DriveView is read when it did, in physical units.
//
//     bits     0-5    6-8   9-12   13-16   17        18      19
//     signal   gates  step  state  reason  crossing  missed  locked
//
// Test: tests/testbench/engine_test.cpp
#pragma once

#include <cstdint>

#include "hls/six_step/config.hpp"
#include "model/plant/plant.hpp"
#include "testbench/engine/host_command.hpp"

namespace steplock {

struct Watch {
  enum Place { kStep = 6, kState = 9, kReason = 13, kCrossing = 17, kMissed = 18, kLocked = 19 };
  static constexpr std::uint32_t kGateMask = 0x3f;
  static constexpr std::uint32_t kStrobeMask = 1u << kCrossing | 1u << kMissed;

  std::uint32_t bits = 0;
  bool operator==(const Watch&) const = default;

  std::uint32_t gate_bits() const { return bits & kGateMask; }
  plant::Gates gates() const {
    return {.uh = bit(0), .ul = bit(1), .vh = bit(2), .vl = bit(3), .wh = bit(4), .wl = bit(5)};
  }
  int step() const { return static_cast<int>(bits >> kStep & 7); }
  State state() const { return static_cast<State>(bits >> kState & 15); }
  Reason reason() const { return static_cast<Reason>(bits >> kReason & 15); }
  bool crossing() const { return bit(kCrossing); }
  bool missed() const { return bit(kMissed); }
  bool locked() const { return bit(kLocked); }

 private:
  bool bit(int i) const { return (bits >> i & 1) != 0; }
};

struct DriveView {
  double steps_per_second = 0;  // of commutation; never negative
  double duty = 0;              // 0 .. 1
  double phase_error_deg = 0;   // electrical; positive: the rotor leads
  double step_phase_deg = 0;    // 0 .. 60, where the VCO stands in the step
  int crossings = 0, missed = 0, freewheel_long = 0, limit_hits = 0, retries = 0;
};

const char* name_of(State);
const char* name_of(Reason);
inline const char* state_name(Watch watch) { return name_of(watch.state()); }

}  // namespace steplock
