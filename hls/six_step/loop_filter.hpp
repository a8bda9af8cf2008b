// Loop filter: from phase error to VCO frequency, with the three parts of a lag-lead filter.
//
//     e' = error + delay * frequency               the sampling's constant delay, taken back
//     p  = e' * s                                  s = frequency (per step) or `scale` (per second)
//     x += ki p          within [minimum, maximum] integrator; stops while the output is at a limit
//     v  = x + kp p                                zero
//     y += pole (v - y)  within [0, maximum]       pole; frequency = y
//
// This is F(s) = (s R C2 + 1) / (s^2 R C1 C2 + s (C1 + C2)), Eq. (1) of Amano 2003, discretised: on
// every tick with constant s (coefficients per second, as in the paper), or on every update with s the
// frequency itself, so that the loop's bandwidth is a constant part of the stepping rate.
//
// Following sectors (a rotor to be caught, or Hall sensors) x takes e * frequency whole or a quarter
// of it, and goes out directly: with error = 1 - turns this is Newton's iteration for 1 / interval.
//
//     x, v, y      u0.40: eight bits more than Frequency, so that small gains still integrate
//     latency      28 clocks per product: about 145 from update to frequency; an update that comes
//                  while busy is passed over
//     registers    about 225 bits     multipliers  none (one serial)
//
// Doc: docs/blocks/loop_filter.md   Test: tests/hls/loop_filter_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/serial_multiplier.hpp"
#include "hls/six_step/words.hpp"

namespace steplock {

// kStop: frequency 0.  kRamp: it grows by `ramp` per tick.  kTrack: the PLL is closed.  kCatch, kHall:
// it follows the intervals between changes of sector.
enum class Loop : std::uint8_t { kStop, kRamp, kTrack, kCatch, kHall };

class LoopFilter {
 public:
  struct In {
    Loop loop = Loop::kStop;
    PhaseError error = 0;          // s0.16, turns of one step; held between updates
    bool update = false;           // strobe: the error is new
    bool tick = false;             // strobe: time base of ramp and per-second form
    UInt<20> ramp = 0;             // u0.32, VCO turns per clock, per tick
    Bandwidth bandwidth = Bandwidth::kPerStep;
    UInt<10> delay = 0;            // clocks / 2^divide
    UInt<16> ki = 0;               // u2.14
    UInt<16> kp = 0;               // u2.14
    UInt<16> pole = 0;             // u1.15
    Frequency scale = 0;           // u0.32, stands for the frequency in the per-second form
    Frequency minimum = 0;         // u0.32, VCO turns per clock
    Frequency maximum = 0;         // u0.32, VCO turns per clock
    Frequency hand_over = 0;       // u0.32, VCO turns per clock
  };

  struct Out {
    Frequency frequency = 0;  // u0.32, VCO turns per clock
    bool fast = false;        // frequency >= hand_over
    bool busy = false;        // an update is being worked on
  };

  Out tick(const In& in) {
    const Out out{.frequency = frequency(),
                  .fast = frequency() >= in.hand_over,
                  .busy = stage_ != Stage::kIdle};
    const bool start = multiplies() && !started_;
    const auto product = multiplier_.tick(
        {.start = start, .a = stage_ == Stage::kPole ? subtract_y() : work_, .b = factor(in)});
    if (in.loop == Loop::kStop) {
      x_ = 0;
      y_ = 0;
      at_top_ = at_bottom_ = started_ = false;
      stage_ = Stage::kIdle;
    } else if (stage_ == Stage::kIdle) {
      begin(in);
    } else if (!multiplies()) {
      bound(in);
    } else {
      started_ = !product.done;
      if (product.done) take(in, product.product);
    }
    return out;
  }

  // Nothing to work on: a tick without a strobe changes nothing (docs/theory.md, quiet clocks).
  bool idle() const { return stage_ == Stage::kIdle; }
  bool operator==(const LoopFilter&) const = default;

 private:
  using Work = Int<37>;  // s-3.40: |x|, |v| and |v - y| stay below 2^-4
  enum class Stage : std::uint8_t {
    kIdle, kDelay, kScale, kIntegral, kBoundX, kProportional, kPole, kBoundY
  };

  Frequency frequency() const { return y_.slice<33, 8>(); }
  Work subtract_y() const { return wrap<Work>(work_ - y_); }
  bool multiplies() const {
    return stage_ != Stage::kIdle && stage_ != Stage::kBoundX && stage_ != Stage::kBoundY;
  }

  UInt<26> factor(const In& in) const {
    const bool track = in.loop == Loop::kTrack;
    switch (stage_) {
      case Stage::kDelay: return track ? in.delay : UInt<10>(0);
      case Stage::kScale: return track && in.bandwidth == Bandwidth::kPerSecond ? in.scale : frequency();
      case Stage::kIntegral: return track ? in.ki : in.loop == Loop::kHall ? UInt<16>(0x1000) : UInt<16>(0x4000);
      case Stage::kProportional: return in.kp;
      default: return in.pole;
    }
  }

  void begin(const In& in) {
    const bool ramp = in.loop == Loop::kRamp;
    const bool per_second = in.loop == Loop::kTrack && in.bandwidth == Bandwidth::kPerSecond;
    if (!(ramp || per_second ? in.tick : in.update)) return;
    work_ = ramp ? wrap<Work>(UInt<36>(in.ramp) << 8) : Work(frequency());
    stage_ = ramp ? Stage::kIntegral : Stage::kDelay;
  }

  void take(const In& in, Int<63> product) {
    switch (stage_) {
      case Stage::kDelay:  // u0.32 of turns
        work_ = saturate<PhaseError>(in.error + wrap<Int<21>>(product >> 16));
        stage_ = Stage::kScale;
        break;
      case Stage::kScale:  // s0.48
        work_ = wrap<Work>(product >> 8);
        stage_ = Stage::kIntegral;
        break;
      case Stage::kIntegral: {
        const bool winds_up = work_.negative() ? at_bottom_ : at_top_;
        if (!winds_up) x_ = wrap<Work>(x_ + wrap<Work>(product >> 14));
        stage_ = Stage::kBoundX;
        break;
      }
      case Stage::kProportional:
        work_ = wrap<Work>(x_ + wrap<Work>(product >> 14));
        stage_ = Stage::kPole;
        break;
      default:
        work_ = wrap<Work>(y_ + wrap<Work>(product >> 15));
        stage_ = Stage::kBoundY;
        break;
    }
  }

  // A ramp begins at standstill.  What turns slower than half the hand-over speed is not caught: the
  // errors against this frequency are never small.
  static Frequency lowest(const In& in) {
    return in.loop == Loop::kRamp    ? Frequency(0)
           : in.loop == Loop::kCatch ? in.hand_over >> 1
                                     : in.minimum;
  }

  void bound(const In& in) {
    if (stage_ == Stage::kBoundX) {
      const Work low = wrap<Work>(UInt<36>(lowest(in)) << 8);
      const Work high = wrap<Work>(UInt<36>(in.maximum) << 8);
      const Work x = x_ < low ? low : x_ > high ? high : x_;
      x_ = x;
      if (in.loop != Loop::kTrack) work_ = x;
      stage_ = in.loop == Loop::kTrack ? Stage::kProportional : Stage::kBoundY;
    } else {
      const Work high = wrap<Work>(UInt<36>(in.maximum) << 8);
      at_bottom_ = work_.negative();
      at_top_ = work_ > high;
      y_ = wrap<UInt<34>>(at_bottom_ ? Work(0) : at_top_ ? high : work_);
      stage_ = Stage::kIdle;
    }
  }

  SerialMultiplier<37, 26> multiplier_;
  Stage stage_ = Stage::kIdle;
  bool started_ = false;    // the stage's product is under way
  Work work_ = 0;           // frequency, then e', p, v and the next y
  Work x_ = 0;              // u0.40, the integrator
  UInt<34> y_ = 0;          // u0.40, behind the pole
  bool at_top_ = false;     // the output stands at a limit
  bool at_bottom_ = false;
};

}  // namespace steplock
