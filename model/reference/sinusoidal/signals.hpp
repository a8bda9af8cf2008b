// What goes into the sinusoidal reference drive and what comes out.
//
// Doc: docs/sinusoidal.md   Test: tests/model/reference/sinusoidal/
#pragma once

#include <optional>

#include "model/reference/signals.hpp"
#include "model/reference/sinusoidal/vector.hpp"

namespace steplock::reference::sinusoidal {

struct Reading {
  Phases current = {};  // A, as the ADCs say
  double v_dc = 0;      // V
};

struct Pins {
  std::optional<Reading> reading;  // a sample that has just been converted
  bool fault = false;
};

enum class State {
  kIdle,
  kCalibrate,  // gates off: the ADCs' offsets
  kPilot,      // pulses: where does the rotor stand
  kPattern,    // a held pattern turns it where it should stand
  kStarting,   // the loop is closed, not yet trusted
  kRun,
  kSlowDown,
  kBrake,
  kRetryDelay,
  kFault
};

enum class Reason {
  kNone,
  kFaultPin,
  kOverCurrent,
  kLostSample,
  kSaturated,
  kTooSlow,
  kEmf,
  kNoLock,
  kNoDecay,
  kNoSaliency,
  kNoPolarity
};

struct Output {
  Gates gates = {};
  State state = State::kIdle;
  Reason reason = Reason::kNone;
  bool sample = false;     // true in the update at whose instant currents and voltage are to be taken
  bool locked = false;     // the estimate is claimed to be right
  bool estimating = false;
  double angle = 0;        // rad, theta_c at the last sample: of the N pole from winding u
  double speed = 0;        // rad/s, smoothed as the speed regulator sees it
  double reference = 0;    // rad/s, slewed set speed
  Vector current;          // A, gamma and delta
  double wanted = 0;       // A, i_delta*
  double emf = 0;          // V
  Phases duty = {};
  double pilot_angle = 0, pilot_saliency = 0, pilot_polarity = 0;  // of the last pilot pulses
};

}  // namespace steplock::reference::sinusoidal
