// What the bench sees of a sinusoidal drive, whichever engine plays it: the counterpart of
// testbench/drive/six_step/watch.hpp.
//
//     bits     0-5    6-9    10-13   14       15
//     signal   gates  state  reason  sample   locked
//
// `sample` is a strobe of one clock: at its clock the ADCs hold what the plant shows.
//
// Test: tests/testbench/sinusoidal_run_test.cpp
#pragma once

#include <cstdint>

#include "model/plant/plant.hpp"
#include "model/reference/sinusoidal/signals.hpp"
#include "testbench/engine/host_command.hpp"

namespace steplock::sinusoidal {

using State = reference::sinusoidal::State;
using Reason = reference::sinusoidal::Reason;

struct Watch {
  enum Place { kState = 6, kReason = 10, kSample = 14, kLocked = 15 };
  static constexpr std::uint32_t kGateMask = 0x3f;
  static constexpr std::uint32_t kStrobeMask = 1u << kSample;

  std::uint32_t bits = 0;
  bool operator==(const Watch&) const = default;

  std::uint32_t gate_bits() const { return bits & kGateMask; }
  plant::Gates gates() const {
    return {.uh = bit(0), .ul = bit(1), .vh = bit(2), .vl = bit(3), .wh = bit(4), .wl = bit(5)};
  }
  State state() const { return static_cast<State>(bits >> kState & 15); }
  Reason reason() const { return static_cast<Reason>(bits >> kReason & 15); }
  // There are no commutation steps: a scenario's pin faults, which wait for one, never come.
  int step() const { return 0; }
  bool sample() const { return bit(kSample); }
  bool locked() const { return bit(kLocked); }

 private:
  bool bit(int i) const { return (bits >> i & 1) != 0; }
};

// In units of people: degrees and rpm (mechanical), amperes as the peak of a phase.
struct View {
  bool estimating = false;
  double angle_deg = 0;  // electrical, of the N pole from winding u, at the last sample taken in
  double speed_rpm = 0, reference_rpm = 0;
  double i_gamma = 0, i_delta = 0, i_wanted = 0;
  double pilot_deg = 0, pilot_saliency = 0, pilot_polarity = 0;
};

const char* name_of(State);
const char* name_of(Reason);
inline const char* state_name(Watch watch) { return name_of(watch.state()); }

}  // namespace steplock::sinusoidal
