// Divide-by-N: VCO turns to commutation steps, N = 6 * 2^divide.
//
//     step_phase = (turns of the VCO in this step + VCO phase) / 2^divide
//     step       counts up forward, down in reverse, modulo 6
//
// Step and step phase belong to the same instant: both change in the clock of `commutate`.  Between
// the VCO's registers and this block's outputs lie a few gates and no adder; a parent registers
// them.
//
//     latency      none: step and step phase follow the VCO's outputs in the same clock
//     registers    6 bits     multipliers  none
//
// Doc: docs/blocks/divide_by_n.md   Test: tests/hls/divide_by_n_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

using Step = UInt<3>;  // 0 to 5; see docs/theory.md for the patterns

// The neighbour in the direction of rotation, bit by bit: an adder would begin and end a carry chain.
constexpr Step next_step(Step step, bool reverse) {
  const bool low = step.bit(0), middle = step.bit(1), high = step.bit(2);
  const bool three_or_four = (middle && low) || (high && !low);
  const bool to_middle = reverse ? three_or_four : middle != low && !high;
  const bool to_high = reverse ? (high ? low : !middle && !low) : three_or_four;
  return UInt<3>(to_high) << 2 | UInt<3>(to_middle) << 1 | UInt<3>(!low);
}

class DivideByN {
 public:
  struct In {
    bool pulse = false;    // the VCO completed a turn
    Phase phase = 0;       // u0.16, VCO turns
    UInt<2> divide = 0;    // N = 6 * 2^divide
    bool reverse = false;  // step counts down
    bool hold = false;     // turns do not move the step: a sensor will
    bool load = false;     // takes `step`, from the middle or the beginning; wins over a pulse
    Step step = 0;         // 0 to 5
    bool half = false;     // load the middle of the step (the VCO: half a turn if divide is 0)
  };

  struct Out {
    Step step = 0;           // 0 to 5
    Phase phase = 0;         // u0.16, turns of one step
    bool commutate = false;  // one clock, the first of a new step
    bool elapsed = false;    // one clock: a step's worth of VCO turns is over, even if held
    Step turned = 0;         // the step, but for a load in this clock: ready before it
    bool operator==(const Out&) const = default;
  };

  Out tick(const In& in) {
    const UInt<3> last = in.divide == 3 ? 7 : in.divide == 2 ? 3 : in.divide == 1 ? 1 : 0;
    const bool elapsed = !in.load && in.pulse && sub_ >= last;
    const Step turned = in.pulse && sub_ >= last && !in.hold ? next_step(step_, in.reverse) : step_;
    if (in.load) {
      step_ = in.step;
      sub_ = in.half ? wrap<UInt<3>>((last + 1) >> 1) : UInt<3>(0);
    } else if (in.pulse) {
      step_ = turned;
      sub_ = elapsed ? UInt<3>(0) : wrap<UInt<3>>(sub_ + 1);
    }
    return {.step = step_,
            .phase = step_phase(in.phase, in.divide),
            .commutate = in.load || (elapsed && !in.hold),
            .elapsed = elapsed,
            .turned = turned};
  }

  // The divided VCO signal: high in the first half electrical turn.
  static bool turn(Step step) { return step < 3; }

  // Turns of the step at a phase of the VCO.
  Phase step_phase(Phase phase, UInt<2> divide) const {
    return wrap<Phase>(((UInt<19>(sub_) << 16) | phase) >> int(divide.raw()));
  }

  bool operator==(const DivideByN&) const = default;

 private:
  UInt<3> sub_ = 0;  // VCO turns into the step
  Step step_ = 0;
};

}  // namespace steplock
