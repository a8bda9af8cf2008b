// PWM generator: on-time in clocks to a pulse, and the drive's slow time base.
//
//     on while  lead <= position < lead + on_clocks
//     lead = 0, or floor((period - on_clocks) / 2) if centred
//
// All words of a period are taken together in the last clock of the one before, so no pulse is made of
// two settings.  Two ends are exact: 0 is never on, `period` or more is on without a gap from period to
// period.  An on-time below `minimum` becomes none, then an off-time below it becomes none.
//
// Three down-counters and no position: what is left of the period, of the lead and of the pulse.  A
// counter that stops at its own borrow needs neither a comparator nor a copy of what it began with.
//
//     latency      2 clocks from the last clock of a period to the first output of the next one;
//                  all outputs are registers
//     period 0     off; the words are looked at in each clock
//     registers    55 bits     multipliers  none
//
// Doc: docs/blocks/pwm_generator.md   Test: tests/hls/pwm_generator_test.cpp
// Proof: tests/proofs/pwm_generator.sv

#pragma once

#include "hls/bridge/bridge.hpp"
#include "hls/numeric/bits.hpp"

namespace steplock {

class PwmGenerator {
 public:
  struct In {
    Clocks on_clocks = 0;      // clocks of on-time; the period or more is 100 %
    Clocks period = 0;         // clocks
    Clocks minimum = 0;        // clocks
    bool centred = false;      // pulse in the middle of the period
    UInt<8> tick_periods = 1;  // periods per tick; 0 counts as 1
  };

  struct Out {
    bool on = false;     // the pulse
    bool start = false;  // first clock of a period
    bool tick = false;   // first clock of every `tick_periods`-th period
  };

  Out tick(const In& in) {
    const Out out{.on = on_, .start = start_, .tick = tick_};

    const bool ending = (left_ >> 1) == 0;  // the period's last clock, or no period at all
    const bool idle = ending && !left_.bit(0);
    const auto shorter_lead = lead_ - 1;
    const auto shorter_pulse = pulse_ - 1;
    const bool rise = waiting_ && shorter_lead.negative();
    // In its first clock a period does not go on with the pulse of the one before.
    const bool counting = rise || (on_ && !first_);

    const bool begins = first_ && !idle;
    const bool ticks = (periods_ >> 1) == 0;
    on_ = !idle && (always_ || (counting && !shorter_pulse.negative()));
    start_ = begins;
    tick_ = begins && ticks;
    if (begins) periods_ = ticks ? in.tick_periods : wrap<UInt<8>>(periods_ - 1);

    first_ = ending;
    // In the end only its last bit is left, if any.  Loading by the adder keeps its carry chain in one piece where
    // the period is a constant: flip-flops of constants that differ would want other resets, and other tiles.
    left_ = wrap<Clocks>((left_ & ~Clocks(ending)) + (ending ? in.period : Clocks::max()));
    if (ending) {
      const auto rest = in.period - in.on_clocks;
      pulse_ = in.on_clocks;
      lead_ = in.centred ? wrap<UInt<13>>(rest >> 1) : UInt<13>(0);
      waiting_ = in.on_clocks >= in.minimum;
      always_ = in.on_clocks >= in.minimum && rest < in.minimum;
    } else {
      if (counting) pulse_ = wrap<Clocks>(shorter_pulse);
      if (waiting_ && !rise) lead_ = wrap<UInt<13>>(shorter_lead);
      if (rise) waiting_ = false;
    }
    return out;
  }

  // Quiet clocks (docs/theory.md): until this block does more than count, and that many at once.
  std::uint64_t quiet() const {
    std::uint64_t clocks = left_ < 2 ? 0 : left_.raw() - 2;
    if (waiting_ && lead_ < clocks) clocks = lead_.raw();
    if (on_ && pulse_ < clocks) clocks = pulse_.raw();
    return clocks;
  }
  void skip(std::uint64_t clocks) {
    left_ = Clocks::of(left_.raw() - clocks);
    if (waiting_) lead_ = UInt<13>::of(lead_.raw() - clocks);
    if (on_) pulse_ = Clocks::of(pulse_.raw() - clocks);
  }
  bool operator==(const PwmGenerator&) const = default;

 private:
  Clocks left_ = 0;       // clocks of the period, with this one
  UInt<13> lead_ = 0;     // clocks to the pulse
  Clocks pulse_ = 0;      // clocks of the pulse
  UInt<8> periods_ = 0;   // periods to the next tick
  bool first_ = false;    // this is the first clock of the period
  bool waiting_ = false;  // the pulse is still to come
  bool always_ = false;   // 100 %
  bool on_ = false;       // the pulse, one clock later
  bool start_ = false;    // as first_, in step with on_
  bool tick_ = false;     // as first_, in every `tick_periods`-th period
};

}  // namespace steplock
