// What goes into the reference drive and what comes out.  Phases u, v, w are index 0, 1, 2.
//
// Doc: docs/theory.md   Test: tests/model/reference/
#pragma once

#include <array>

namespace steplock::reference {

struct Pins {
  std::array<bool, 3> comparator = {};  // terminal above the reference
  bool limit = false;                   // current above the threshold
  bool fault = false;
  std::array<bool, 3> hall = {};
};

// What the bridge does to the terminals, as the comparator logic has to know it.
struct Bridge {
  int step = 0;
  bool chop = false;  // the chopped gate is meant to be on
  bool operator==(const Bridge&) const = default;
};

struct Command {
  bool configured = true, run = false, reverse = false, brake_to_stop = false, clear_fault = false;
};

enum class State {
  kIdle,
  kDetectSpin,
  kBrake,
  kPreAlign,
  kAlign,
  kAccelerate,
  kPullIn,
  kRun,
  kSlowDown,
  kRetryDelay,
  kFault
};

enum class Reason {
  kNone,
  kFaultPin,
  kOverCurrent,
  kStepOut,
  kStall,
  kWrongLock,
  kNoLock,
  kCannotStop,
  kHallCode,
  kBlocked
};

// Index 2 k is phase k's high side, 2 k + 1 its low side.
using Gates = std::array<bool, 6>;

struct Output {
  Gates gates = {};
  State state = State::kIdle;
  Reason reason = Reason::kNone;
  bool locked = false;
  int step = 0;
  double frequency = 0;    // steps/s
  double step_phase = 0;   // turns of a step, at the time of the update
  double phase_error = 0;  // turns of a step, the last one
  double duty = 0;
  bool chop = false;
  bool commutate = false, crossing = false, missed = false;  // true in the update they happen in
  double crossing_phase = 0;                                 // turns of a step
  double freewheel = 0;                                      // turns of a step
};

}  // namespace steplock::reference
