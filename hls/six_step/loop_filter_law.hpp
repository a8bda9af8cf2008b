// Loop filter, the law: one update from phase error to VCO frequency, as equations.
//
// LoopFilter does the same in about 150 clocks with one multiplier, and is held to this bit for
// bit.  All values have 36 fraction bits but e', which has 22; a product drops 14 of them.
//
// Doc: docs/blocks/loop_filter.md   Test: tests/hls/loop_filter_law_test.cpp

#pragma once

#include "hls/six_step/loop_filter.hpp"

namespace steplock {

struct LoopFilterLaw {
  using In = LoopFilter::In;
  using Value = Int<34>;  // s-2.36

  // law
  Value x = 0;             // turns per clock: the integrator
  UInt<30> y = 0;          // turns per clock: behind the pole
  bool at_bottom = false;  // the output stands at a limit
  bool at_top = false;
  bool slow = false;       // y is below `stall`
  bool fast = false;       // y is `hand_over` or more
  bool fresh = true;       // nothing was measured since kStop

  Frequency frequency() const { return y.slice<29, 4>(); }

  void stop() { *this = LoopFilterLaw{}; }

  void update(const In& in) {
    const bool track = in.loop == Loop::kTrack;
    const UInt<10> delay = track ? in.delay : UInt<10>(0);
    const Value e = sum(error(in), times(y, delay));                 // e' = error + delay y
    const Value p = times(e, s(in));                                 // p  = e' s
    if (!track) {
      bound(sum(x, times(p, gain(in))), in);                         // Newton, or a ramp
      x = y;
      return;
    }
    const bool winds_up = p.negative() ? at_bottom : at_top;
    if (!winds_up) x = sum(x, times(p, in.ki));                      // x += ki p
    const Value v = sum(x, times(p, in.kp));                         // v  = x + kp p
    bound(sum(times(v, alpha(in)), times(y, rest(in))), in);          // y += alpha (v - y)
  }

 private:
  static constexpr UInt<15> kOne = 0x4000;

  // Turns of a step; 1/16 of one stands for the whole ramp.
  static Value error(const In& in) {
    const PhaseError ramp = 0x1000 >> 2 * static_cast<int>(in.backoff.raw());
    return Value(in.loop == Loop::kRamp ? ramp : in.error) << 6;
  }
  // Turns per clock, 22 bits of it: each form's own.
  UInt<22> s(const In& in) const {
    if (in.loop == Loop::kRamp) return in.ramp;
    const bool per_second = in.loop == Loop::kTrack && in.bandwidth == Bandwidth::kPerSecond;
    return per_second ? in.scale.slice<25, 4>() : y.slice<29, 8>();
  }
  // Hall sensors stand a few degrees off: an error below a quarter of a step counts for a quarter.
  static UInt<15> gain(const In& in) {
    const bool small = in.error >= -0x4000 && in.error < 0x4000;
    return in.loop == Loop::kHall && small ? UInt<15>(0x1000) : kOne;
  }
  static UInt<15> alpha(const In& in) { return in.alpha.slice<15, 1>(); }
  static UInt<15> rest(const In& in) { return wrap<UInt<15>>(kOne - alpha(in)); }

  // A ramp begins at standstill, a rotor that is followed at hand-over.
  Frequency least(const In& in) const {
    if (in.loop == Loop::kRamp) return 0;
    return in.loop == Loop::kFollow && fresh ? in.hand_over : in.minimum;
  }
  void bound(Value v, const In& in) {
    at_bottom = v >> 4 < Value(least(in));
    at_top = v >> 4 >= Value(in.maximum);
    if (at_bottom) v = Value(least(in)) << 4;
    slow = v >> 4 < Value(in.stall);
    if (at_top) v = Value(in.maximum) << 4;
    fast = v >> 4 >= Value(in.hand_over);
    y = wrap<UInt<30>>(v);
    fresh = false;
  }
  // end of law

  static Value sum(Value a, Value b) { return wrap<Value>(a + b); }
  template <int W>
  static Value times(Value a, UInt<W> b) { return wrap<Value>((a * b) >> 14); }
};

}  // namespace steplock
