// Speed control: from the VCO's frequency to the on-time of the PWM, once per tick.
//
//     reference  moves towards target by at most slew
//     e          = reference - frequency
//     integral  += ki e >> shift        within [minimum, maximum]; frozen where it would wind up
//     duty       = integral + (kp e >> shift)       within [minimum, maximum] and duty_slew
//     on_clocks  = duty * period
//     slips      = duty > slip + (loaded frequency >> shift)    more than any right lock takes
//
// Outside speed control the duty is the start sequence's (kFixed), or that much above the one whose
// mean voltage equals the back-EMF (kAboveBemf: the current stays the same while the rotor speeds
// up). Integral and reference follow, so that control begins without a jump, after a start as after
// catching a rotor.
//
// Where the freewheeling of so much current took half a step and hid the crossing of a rotor that hurries
// on, the duty falls by its slew until a crossing shows: more current would hide them all and lose the loop.
//
// One product at a time, one addition to it, then one bound after the other by one comparator.
//
//     latency      at most 140 clocks after the tick, with shift 15; a tick that comes earlier is
//                  passed over
//     registers    about 240 bits     multipliers  none (one serial)
//
// Doc: docs/blocks/speed_control.md   Test: tests/hls/speed_control_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/serial_multiplier.hpp"
#include "hls/six_step/words.hpp"

namespace steplock {

enum class SpeedMode : std::uint8_t { kFixed, kAboveBemf, kControl };

class SpeedControl {
 public:
  struct In {
    bool tick = false;                   // starts one update
    SpeedMode mode = SpeedMode::kFixed;  // where the duty comes from
    Duty fixed_duty = 0;                 // u1.15, for kFixed and kAboveBemf
    Frequency frequency = 0;             // u0.32, VCO turns per clock
    Frequency target = 0;                // u0.32, VCO turns per clock
    bool limited = false;                // strobe: the current limit cut the pulse
    bool hurries = false;                // freewheeling just hid the crossing of a rotor that leads
    Clocks period = 0;                   // clocks per PWM period
    Duty slip = 0;                       // u1.15, above what speed and commutation take
    SpeedWords words;
  };

  struct Out {
    Duty duty = 0;         // u1.15
    Clocks on_clocks = 0;  // clocks of on-time per period
    bool slips = false;    // in speed control: more than slip above what the speed takes
  };

  Out tick(const In& in) {
    const Out out{.duty = duty_, .on_clocks = on_clocks_, .slips = slips_};
    const bool of_error = stage_ == Stage::kIntegral || stage_ == Stage::kProportional;
    const bool of_duty = stage_ == Stage::kOnClocks;
    const bool multiplies = of_error || of_duty || stage_ == Stage::kBemf;
    const auto product = multiplier_.tick({.start = multiplies && !started_,
                                           .a = multiplicand(in.frequency),
                                           .b = factor(in),
                                           .shift = of_duty ? UInt<4>(0) : in.words.shift});
    const bool integrated = stage_ == Stage::kIntegral && product.done;
    if (multiplies) {
      started_ = !product.done;
      if (product.done) add(in, wrap<Int<32>>(product.product));
    } else {
      advance(in);
    }
    // A cut counts until an integral has seen it.
    limited_ = in.limited || (limited_ && !integrated && in.mode == SpeedMode::kControl);
    return out;
  }

  // Quiet clocks (docs/theory.md): without a strobe, until a product is complete, and that many at once.
  std::uint64_t quiet() const {
    return stage_ == Stage::kIdle ? ~std::uint64_t{0} : started_ ? multiplier_.quiet() : 0;
  }
  void skip(Frequency frequency, std::uint64_t clocks) {
    if (stage_ != Stage::kIdle) multiplier_.skip(multiplicand(frequency), clocks);
  }
  bool operator==(const SpeedControl&) const = default;

 private:
  // Reference, then product by product; bounds stand behind what they bound.
  enum class Stage : std::uint8_t {
    kIdle, kSlew, kReach, kBemf, kSlip, kIntegral, kWhole, kWholeLow, kWholeHigh, kKeep,
    kProportional, kLow, kHigh, kUp, kDown, kDuty, kOnClocks
  };
  using Work = Int<21>;  // s5.15: kp e alone may be 16 times the full duty

  static Stage next(Stage stage) {
    if (stage >= Stage::kOnClocks) return Stage::kIdle;
    return static_cast<Stage>(static_cast<int>(stage) + 1);
  }

  // Reference - frequency, but for its last bit: the one's complement saves the duty another adder.
  Int<27> multiplicand(Frequency frequency) const {
    const bool of_error = stage_ == Stage::kIntegral || stage_ == Stage::kProportional;
    const bool of_duty = stage_ == Stage::kOnClocks;
    const Int<27> speed = frequency;
    return wrap<Int<27>>((of_error  ? wrap<Int<27>>(reference_)
                          : of_duty ? Int<27>(duty_)
                                    : Int<27>(0)) +
                         (of_error  ? ~speed
                          : of_duty ? Int<27>(0)
                                    : speed));
  }

  UInt<16> factor(const In& in) const {
    switch (stage_) {
      case Stage::kBemf:
        return in.mode == SpeedMode::kControl ? in.words.loaded : in.words.bemf;
      case Stage::kIntegral: return in.words.ki;
      case Stage::kProportional: return in.words.kp;
      default: return in.period;
    }
  }

  Work sum(const In& in, Int<32> product) const {
    const bool whole = stage_ == Stage::kWhole || stage_ == Stage::kProportional;
    const bool control = in.mode == SpeedMode::kControl;
    const Work base = whole     ? wrap<Work>(integral_ >> 16)
                      : control ? Work(in.slip)
                                : Work(in.fixed_duty);
    const bool alone = in.mode == SpeedMode::kFixed || stage_ == Stage::kWhole;
    return wrap<Work>(base + (alone ? Int<20>(0) : wrap<Int<20>>(product >> 12)));
  }

  void add(const In& in, Int<32> product) {
    if (stage_ == Stage::kIntegral) {
      const bool winds_up = product.negative() ? at_low_ : at_high_ || limited_;
      if (!winds_up) integral_ = wrap<Int<34>>(integral_ + product);
    } else if (stage_ == Stage::kOnClocks) {
      on_clocks_ = product.slice<28, 15>();
    } else {
      work_ = sum(in, product);
    }
    const bool control = in.mode == SpeedMode::kControl;
    stage_ = stage_ == Stage::kBemf && !control ? Stage::kHigh : next(stage_);
  }

  void advance(const In& in) {
    const bool control = in.mode == SpeedMode::kControl;
    const Int<18> limit = bound(in);
    const bool below = work_ < limit;
    const bool too_low =
        (stage_ == Stage::kWholeLow || stage_ == Stage::kLow || stage_ == Stage::kDown) && below;
    const bool too_high =
        (stage_ == Stage::kWholeHigh || stage_ == Stage::kHigh || stage_ == Stage::kUp) && !below;
    const Work work = work_;
    if (stage_ == Stage::kWhole) {
      work_ = sum(in, 0);
    } else if (too_low || too_high) {
      work_ = limit;
    }

    const Frequency goal = control ? in.target : in.frequency;
    // What kSlew decides kReach adds: a comparison and an addition in one clock would be the longest path.
    const Int<28> moved = wrap<Int<28>>(reference_ + work);
    const bool lower = moved < goal;
    switch (stage_) {
      case Stage::kIdle:
        if (in.tick) stage_ = Stage::kSlew;
        return;
      case Stage::kSlew:
        // Downwards one last bit more, the one's complement: kReach catches whatever passes the goal.
        rises_ = lower;
        work_ = lower ? Work(in.words.slew) : ~Work(in.words.slew);
        break;
      case Stage::kReach:
        reference_ = !control || lower != rises_ ? Int<28>(goal) : moved;
        break;
      case Stage::kSlip: slips_ = below; break;
      case Stage::kWhole: at_low_ = at_high_ = false; break;
      case Stage::kKeep:
        if (at_low_ || at_high_) integral_ = Int<34>(work) << 16;
        break;
      case Stage::kDuty:
        duty_ = wrap<Duty>(work);
        work_ = 0;  // until kSlew
        if (!control) {
          integral_ = Int<34>(work) << 16;
          slips_ = false;
        }
        break;
      default: break;
    }
    at_low_ = at_low_ || too_low;
    at_high_ = at_high_ || too_high;
    stage_ = stage_ == Stage::kHigh && !control ? Stage::kDuty : next(stage_);
  }

  Int<18> bound(const In& in) const {
    switch (stage_) {
      case Stage::kWholeLow:
      case Stage::kLow: return in.words.minimum;
      case Stage::kWholeHigh:
      case Stage::kHigh: return in.words.maximum;
      default: {
        // Downwards one last bit more: the one's complement.
        const bool up = stage_ == Stage::kUp && !in.hurries;
        const bool down = stage_ == Stage::kUp || stage_ == Stage::kDown;
        const Int<18> slew = up     ? Int<18>(in.words.duty_slew)
                             : down ? ~Int<18>(in.words.duty_slew)
                                    : Int<18>(0);
        return wrap<Int<18>>(duty_ + slew);
      }
    }
  }

  SerialMultiplier<27, 16> multiplier_;
  Stage stage_ = Stage::kIdle;
  bool started_ = false;    // the stage's product is under way
  Work work_ = 0;           // duty on its way; 0 while idle; from kSlew to kReach the slew
  Int<28> reference_ = 0;   // u0.32, the slewed target
  bool rises_ = false;      // the reference went up
  Int<34> integral_ = 0;    // u1.31: the duty and 16 bits more
  Duty duty_ = 0;
  Clocks on_clocks_ = 0;
  bool slips_ = false;
  bool limited_ = false;    // the current limit cut a pulse since the last integral
  bool at_high_ = false;    // integral or duty wanted to be higher than they may
  bool at_low_ = false;     // or lower
};

}  // namespace steplock
