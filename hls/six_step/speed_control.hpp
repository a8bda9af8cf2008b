// Speed control: from the VCO's frequency to the on-time of the PWM, once per tick.
//
//     reference  moves towards target by at most slew; not upwards while the current limit cuts
//     e          = reference - frequency
//     integral  += ki e >> shift        within [minimum, maximum]; frozen where it would wind up
//     duty       = integral + (kp e >> shift)       within maximum, then duty_slew, then minimum
//     on_clocks  = duty * period
//     slips      = duty > slip + (loaded frequency >> shift)    more than any right lock takes
//
// Outside speed control the duty is the start sequence's (kFixed), or that much above the one whose mean voltage equals the
// back-EMF (kFeedForwardDrive: the current stays the same while the rotor speeds up), or less that one (kFeedForwardBrake).
// Integral and reference follow, so that control begins without a jump, after a start as after catching a rotor.  It begins once
// more that way where a rotor has come down to a lower target: it coasts, and what the integral lost in vain meanwhile would
// take it far below.
//
// The current limit holds the duty where it is: what it cannot give would only look like a slip.  Where freewheeling takes
// 15/32 of a step or more and the duty is to rise (faster than its slew, or by 2^-13 a tick for the integral alone, or the limit
// cuts), it falls by twice its slew; where it hid the crossing of a leading rotor (`masked_lead`), by its slew until one shows: more
// current would hide them all and lose the loop.
//
// One product at a time, one addition to it, then one bound after the other by one comparator.
//
//     latency      at most 140 clocks after the tick, with shift 15; a tick that comes earlier is
//                  ignored
//     registers    about 320 bits     multipliers  none (one serial)
//
// Law: hls/six_step/speed_control_law.hpp   Doc: docs/blocks/speed_control.md   Test: tests/hls/speed_control_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/one_hot.hpp"
#include "hls/numeric/serial_multiplier.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

enum class SpeedMode : std::uint8_t { kFixed, kFeedForwardDrive, kControl, kFeedForwardBrake };

class SpeedControl {
 public:
  struct In {
    bool tick = false;                   // starts one update
    SpeedMode mode = SpeedMode::kFixed;  // where the duty comes from
    Duty fixed_duty = 0;                 // u1.15, for all but kControl
    Frequency frequency = 0;             // u0.32, VCO turns per clock
    Frequency target = 0;                // u0.32, VCO turns per clock
    bool limited = false;                // strobe: the current limit cut the pulse
    bool masked_lead = false;            // freewheeling just hid the crossing of a rotor that leads
    bool freewheels = false;             // freewheeling took 15/32 of the last step, or more
    Clocks period = 0;                   // clocks per PWM period
    Duty slip = 0;                       // u1.15, above what speed and commutation take
    SpeedConfig config;
  };

  struct Out {
    Duty duty = 0;         // u1.15
    Clocks on_clocks = 0;  // clocks of on-time per period
    bool slips = false;    // in speed control: more than slip above what the speed takes
  };

  Out tick(const In& in) {
    const Out out{.duty = duty_, .on_clocks = on_clocks_, .slips = slips_};
    const bool control = control_;
    const bool of_duty = at_.holds(Stage::kOnClocks);
    const bool multiplies = of_error_ || of_duty || at_.holds(Stage::kBemf);
    const auto product = multiplier_.tick({.start = starts_,
                                           .a = multiplicand(in.frequency),
                                           .b = factor(in),
                                           .shift = of_duty ? UInt<4>(0) : in.config.shift});
    const bool integrated = at_.holds(Stage::kIntegral) && product.done;
    // A cut counts until an integral has seen it.
    const bool limited = limited_;
    limited_ = in.limited || (limited_ && !integrated && control);
    if (integrated) {
      held_ = limited;
      resumes_ = control && descends_ && !far_ && !wrap<Int<32>>(product.product).negative();
    }
    // A clock after the product, from its flip-flops.
    if (at_.holds(Stage::kAdd)) asks_ = held_ || at_high_ || (!addend_.negative() && addend_.slice<32, 18>() != 0);

    descend(in, control);  // before slew() takes `passes_`
    slew(in, control);
    work(in, wrap<Int<32>>(product.product), product.done, limited);
    choose(product.done, product.ends);
    whole_ = at_.holds_one_of(Stage::kAdd, Stage::kProportional);
    alone_ = in.mode == SpeedMode::kFixed || at_.holds(Stage::kAdd);
    less_ = in.mode == SpeedMode::kFeedForwardBrake;
    control_ = in.mode == SpeedMode::kControl && !presets_;
    of_error_ = at_.holds_one_of(Stage::kSlip, Stage::kWholeHigh) || (of_error_ && !product.done);
    starts_ = at_.holds_one_of(Stage::kReach, Stage::kSlip, Stage::kWholeHigh, Stage::kDuty);
    const bool idle = at_.holds(Stage::kIdle);
    if (idle ? in.tick : !multiplies || product.done) {
      at_ = !control && at_.holds(Stage::kBemf)   ? Stages(Stage::kUp)
            : !control && !presets_ && at_.holds(Stage::kUp) ? Stages(Stage::kDuty)
                                                  : at_.next();
    }
    return out;
  }

  // Quiet clocks (docs/theory.md): without a strobe, until a product is complete, and that many at once.
  std::uint64_t quiet() const {
    return at_.holds(Stage::kIdle) ? ~std::uint64_t{0} : !starts_ ? multiplier_.quiet() : 0;
  }
  void skip(Frequency frequency, std::uint64_t clocks) {
    if (!at_.holds(Stage::kIdle)) multiplier_.skip(multiplicand(frequency), clocks);
  }
  bool operator==(const SpeedControl&) const = default;

 private:
  // Reference, then product by product; bounds stand behind what they bound.
  enum class Stage : std::uint8_t {
    kIdle, kSlew, kReach, kBemf, kSlip, kIntegral, kAdd, kWhole, kWholeLow, kWholeHigh,
    kProportional, kHigh, kUp, kDown, kLow, kDuty, kOnClocks
  };
  using Stages = OneHot<Stage, 17>;
  using Limit = UInt<17>;
  using Work = Int<21>;  // s5.15: kp e alone may be 16 times the full duty

  // Reference - frequency, but for its last bit: the one's complement saves the duty another adder.
  Int<27> multiplicand(Frequency frequency) const {
    const bool of_duty = at_.holds(Stage::kOnClocks);
    const Int<27> speed = frequency;
    return wrap<Int<27>>((of_error_ ? wrap<Int<27>>(reference_)
                          : of_duty  ? Int<27>(duty_)
                                     : Int<27>(0)) +
                         (of_error_ ? ~speed
                          : of_duty  ? Int<27>(0)
                                     : speed));
  }

  UInt<16> factor(const In& in) const {
    return at_.holds(Stage::kBemf)
               ? (control_ ? in.config.loaded : in.config.bemf)
           : at_.holds(Stage::kIntegral)     ? in.config.ki
           : at_.holds(Stage::kProportional) ? in.config.kp
                                             : UInt<16>(in.period);
  }

  void slew(const In& in, bool control) {
    const bool lower = !at_least(offset(reference_), UInt<28>(not_target_));
    // Downwards one last bit more, the one's complement: what passes the target is caught two clocks later.
    const Int<21> slew = in.config.slew;
    const Int<21> moved = (rises_ ? slew : Int<21>(0)) | (falls_ ? Int<21>(~slew) : Int<21>(0));
    if (at_.holds(Stage::kSlew)) {
      reference_ = wrap<Int<28>>(reference_ + moved);
    } else if (at_.holds(Stage::kReach) && !control) {
      reference_ = in.frequency;
    } else if (passes_) {
      reference_ = wrap<Frequency>(~not_target_);
    }
    passes_ = at_.holds(Stage::kReach) && control && (lower ? falls_ : rises_);
    if (at_.holds(Stage::kIdle)) {
      rises_ = lower && !held_;
      falls_ = !lower;
    }
    not_target_ = ~UInt<27>(in.target);
  }

  Work sum(const In& in, Int<32> product) const {
    const Work base = whole_ ? wrap<Work>(integral_ >> 16) : Work(control_ ? in.slip : in.fixed_duty);
    const Int<20> part = alone_ ? Int<20>(0) : wrap<Int<20>>(product >> 12);
    return wrap<Work>(base + (less_ ? ~part : part));
  }

  // Everything behind the reference: the product of this stage when it is complete, or its bound.
  void work(const In& in, Int<32> product, bool done, bool limited) {
    const bool control = control_;
    const Limit limit = wrap<Limit>(~not_limit_);
    const bool below = !at_least(offset(work_), UInt<21>(not_limit_) | UInt<21>(0xE0000));
    const bool at_high = at_high_ || (high_was_ && !below_);
    const Work last = work_;
    const Work total = sum(in, product);
    // The integral takes its product in the clock after, and a bound in two: cleared in one, added to in the next.
    // Its carry chain stays in one piece that way, and the sum goes straight into its register.
    if (clears_) {
      integral_ = 0;
    } else if (adds_) {
      integral_ = wrap<Int<34>>(integral_ + addend_);
    }
    const bool winds_up = product.negative() ? at_low_ : at_high_ || limited;
    if (done || clears_) addend_ = clears_ ? Int<34>(last) << 16 : Int<34>(product);
    adds_ = clears_ || (done && at_.holds(Stage::kIntegral) && !winds_up);
    clears_ = (at_.holds(Stage::kProportional) && starts_ && (at_low_ || at_high)) ||
              (at_.holds(Stage::kDuty) && !control);
    if (below ? low_ : high_) work_ = sums_ ? total : Work(limit);
    if (at_.holds(Stage::kSlip)) slips_ = below;
    if (at_.holds(Stage::kDuty)) {
      duty_ = last.negative() ? Duty(0) : wrap<Duty>(last);
      if (!control) slips_ = false;
    }
    if (done && at_.holds(Stage::kOnClocks)) on_clocks_ = product.slice<28, 15>();
    at_low_ = !at_.holds(Stage::kWhole) && (at_low_ || (low_was_ && below_));
    at_high_ = !at_.holds(Stage::kWhole) && at_high;
    below_ = below;
    not_limit_ = ~bound(in);
    move(in);
  }

  // Whether the next clock takes a sum, or compares with a bound and takes that.
  void choose(bool done, bool ends) {
    low_was_ = low_ && !sums_;
    high_was_ = high_ && !sums_;
    sums_ = at_.holds(Stage::kAdd) || (ends && at_.holds_one_of(Stage::kBemf, Stage::kProportional));
    low_ = sums_ || at_.holds_one_of(Stage::kWhole, Stage::kDown) || (control_ && at_.holds(Stage::kUp)) ||
           (presets_ && done && at_.holds(Stage::kBemf));
    high_ = sums_ || at_.holds_one_of(Stage::kWholeLow, Stage::kHigh) || (done && at_.holds(Stage::kProportional)) ||
            (presets_ && at_.holds(Stage::kUp)) || (!control_ && !presets_ && done && at_.holds(Stage::kBemf));
  }

  // After an update that found the rotor no longer above a target that was lower, the next one takes the back-EMF's duty, if it is
  // more, beside the sequence's, which is none in these states.
  void descend(const In& in, bool control) {
    if (at_.holds(Stage::kBemf) && starts_) far_ = falls_ && !passes_;
    if (at_.holds(Stage::kDuty)) descends_ = control && !resumes_ && (descends_ || far_);
    if (at_.holds(Stage::kDuty) && !control) resumes_ = false;
    if (at_.holds(Stage::kIdle)) presets_ = resumes_ && in.mode == SpeedMode::kControl;
  }

  // What the stage behind this one compares with.
  Limit bound(const In& in) const {
    const bool control = control_;
    if (at_.holds(Stage::kWhole) || (control && at_.holds(Stage::kDown))) return in.config.minimum;
    if (at_.holds_one_of(Stage::kWholeLow, Stage::kProportional) ||
        (!control && (presets_ ? at_.holds(Stage::kUp) : at_.holds(Stage::kBemf)))) {
      return in.config.maximum;
    }
    return at_.holds_one_of(Stage::kHigh, Stage::kUp, Stage::kDown) ? moved_ : Limit(duty_);
  }

  // The duty's slew, ready one stage before bound() wants it; or two of them.  Downwards one last bit more: the
  // one's complement.
  void move(const In& in) {
    const bool rises = at_.holds(Stage::kProportional);
    const bool falls = !rises || yields_;
    const Int<14> slew = fast_ ? Int<14>(in.config.duty_slew) << 1 : Int<14>(in.config.duty_slew);
    const Int<14> none = 0;
    const auto moved = duty_ + (falls ? ~slew : held_ ? none : slew);
    moved_ = moved.negative() ? Limit(0) : wrap<Limit>(moved);
    fast_ = asks_ && in.freewheels;
    yields_ = in.masked_lead || fast_;
  }

  SerialMultiplier<27, 16> multiplier_;
  Stages at_ = Stage::kIdle;
  bool of_error_ = false;   // the product is the error's: kIntegral or kProportional
  bool starts_ = false;     // this is the first clock of a product
  bool control_ = false;    // the mode is kControl
  bool whole_ = false;      // the sum to come is the integral
  bool alone_ = false;      // and without a product
  bool less_ = false;       // or less the product
  Work work_ = 0;           // duty on its way
  bool clears_ = false;     // the integral is cleared, before it takes the work
  bool adds_ = false;       // it takes the addend
  Int<34> addend_ = 0;      // the product, or the work
  Limit moved_ = 0;         // the duty, one slew further
  Limit not_limit_ = 0;     // complement of what this stage compares with
  Int<28> reference_ = 0;   // u0.32, the slewed target
  UInt<27> not_target_ = UInt<27>::max();  // complement of the target, a clock ago
  bool passes_ = false;     // the reference passed it
  bool falls_ = false;      // it goes down: a flip-flop of its own, for want of time to ask !rises_
  bool rises_ = false;      // the reference went up
  Int<34> integral_ = 0;    // u1.31: the duty and 16 bits more
  Duty duty_ = 0;
  Clocks on_clocks_ = 0;
  bool slips_ = false;
  bool limited_ = false;    // the current limit cut a pulse since the last integral
  bool held_ = false;       // it had done so before that one
  bool asks_ = false;       // that, or the last duty wanted to be higher than it might, or this one is to rise
  bool far_ = false;        // the reference goes down and has not reached the target
  bool descends_ = false;   // it did, and the rotor has not been found at it
  bool resumes_ = false;    // it has
  bool presets_ = false;    // this update begins control once more
  bool yields_ = false;     // the duty falls for want of crossings: a flip-flop before the adder
  bool fast_ = false;       // before they are hidden, and faster than its slew
  bool sums_ = false;       // this clock takes a sum
  bool low_ = false;        // it takes something where the work is below the bound
  bool high_ = false;       // it does where it is not
  bool low_was_ = false;    // a bound in the last clock, that is
  bool high_was_ = false;
  bool below_ = false;      // which found less
  bool at_high_ = false;    // integral or duty wanted to be higher than they may
  bool at_low_ = false;     // or lower
};

}  // namespace steplock
