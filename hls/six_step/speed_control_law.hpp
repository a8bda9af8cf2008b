// Speed control, the law: one tick from the VCO's frequency to the on-time, as equations.
//
// SpeedControl does the same in at most 140 clocks with one multiplier, and is held to this bit for
// bit.  What falls, falls by a last bit more: the one's complement stands for the negative.
//
// Doc: docs/blocks/speed_control.md   Test: tests/hls/speed_control_law_test.cpp

#pragma once

#include "hls/six_step/speed_control.hpp"

namespace steplock {

struct SpeedControlLaw {
  using In = SpeedControl::In;  // `limited`: the current limit cut since the last tick of control
  using Sum = Int<21>;          // s5.15, of the duty
  using Limit = UInt<17>;       // u2.15

  // law
  Int<28> reference = 0;   // u0.32, turns per clock: the slewed target
  Int<34> integral = 0;    // u1.31, of the duty
  Duty duty = 0;           // u1.15
  Clocks on_clocks = 0;    // of a PWM period
  bool slips = false;      // more duty than the speed explains
  bool at_low = false;     // integral or duty wanted to be lower than they may
  bool at_high = false;    // or higher
  bool held = false;       // the current limit cut
  bool asks = false;       // that, or the duty is to rise
  bool descends = false;   // the reference went down, and no rotor has been found at the target
  bool resumes = false;    // it has: the next tick begins control once more

  void tick(const In& in) {
    const bool begins = in.mode == SpeedMode::kControl && resumes;
    const bool control = in.mode == SpeedMode::kControl && !begins;
    const bool far = slew(in, control);
    if (control) {
      slips = add(in.slip, times(in.frequency, in.config.loaded, in)) < Sum(duty);
      follow(in, far);
    } else {
      start(in, begins);
    }
    on_clocks = (duty * in.period).slice<28, 15>();
  }

 private:
  // PI: integral += ki e, without wind-up; duty = integral + kp e, both within their bounds, of which the last rules.
  void follow(const In& in, bool far) {
    const Int<27> e = wrap<Int<27>>(reference - in.frequency - 1);
    const Int<32> more = times(e, in.config.ki, in);
    const bool winds_up = more.negative() ? at_low : at_high || in.limited;
    if (!winds_up) integral = wrap<Int<34>>(integral + more);
    held = in.limited;
    asks = held || at_high || more >= kAsks;
    resumes = descends && !far && !more.negative();
    descends = !resumes && (descends || far);

    at_low = at_high = false;
    Sum sum = wrap<Sum>(integral >> 16);
    lower(sum, in.config.minimum);
    upper(sum, in.config.maximum);
    if (at_low || at_high) integral = Int<34>(sum) << 16;
    sum = add(wrap<Sum>(integral >> 16), times(e, in.config.kp, in));
    const Int<15> rise = held ? 0 : in.config.duty_slew;
    upper(sum, in.config.maximum);
    upper(sum, moved(yields(in) || in.masked_lead ? fall(in) : rise));
    lower(sum, moved(fall(in)));
    lower(sum, in.config.minimum);
    duty = wrap<Duty>(sum);
  }

  // The duty of the start sequence, alone, above the back-EMF's or less that, and the integral follows.  Where
  // control begins once more, it is the back-EMF's, but no less than before.
  void start(const In& in, bool begins) {
    Sum sum = in.fixed_duty;
    const auto bemf = wrap<Int<20>>(times(in.frequency, in.config.bemf, in) >> 12);
    if (in.mode != SpeedMode::kFixed) sum = wrap<Sum>(sum + (in.mode == SpeedMode::kFeedForwardBrake ? ~bemf : bemf));
    if (begins) lower(sum, duty);
    upper(sum, in.config.maximum);
    if (begins) lower(sum, moved(fall(in)));
    duty = sum.negative() ? Duty(0) : wrap<Duty>(sum);
    integral = Int<34>(sum) << 16;
    slips = descends = resumes = false;
  }

  // Freewheeling is about to hide crossings: the duty falls, twice as fast as else.
  bool yields(const In& in) const { return asks && in.freewheels; }
  Int<15> fall(const In& in) const {
    const Int<15> slew = in.config.duty_slew;
    return ~(yields(in) ? wrap<Int<15>>(slew << 1) : slew);
  }

  // Towards the target by at most the slew, upwards not while the current limit cuts.  True: on the
  // way down.
  bool slew(const In& in, bool control) {
    const bool below = reference < in.target, rises = below && !held, falls = !below;
    const Int<21> step = in.config.slew;
    reference = wrap<Int<28>>(reference + (rises ? step : falls ? ~step : Int<21>(0)));
    const bool passed = control && (reference < in.target ? falls : rises);
    if (!control) reference = in.frequency;
    if (passed) reference = in.target;
    return falls && !passed;
  }
  // end of law

  static constexpr int kAsks = 1 << 18;  // s.31, of one tick: 2^-13 of the duty

  static Int<32> times(Int<27> speed, UInt<16> gain, const In& in) {
    return wrap<Int<32>>((speed * gain) >> static_cast<int>(in.config.shift.raw()));
  }
  static Sum add(Sum a, Int<32> product) { return wrap<Sum>(a + wrap<Int<20>>(product >> 12)); }
  Limit moved(Int<15> by) const {
    const auto sum = duty + by;
    return sum.negative() ? Limit(0) : wrap<Limit>(sum);
  }
  void lower(Sum& sum, Limit least) {
    if (sum < least) sum = least, at_low = true;
  }
  void upper(Sum& sum, Limit most) {
    if (sum >= most) sum = most, at_high = true;
  }
};

}  // namespace steplock
