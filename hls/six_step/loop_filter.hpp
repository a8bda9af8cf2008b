// Loop filter: from phase error to VCO frequency, with the three parts of a lag-lead filter.
//
//     e' = error + delay * frequency               the sampling's constant delay, taken back
//     p  = e' * s                                  s = frequency (per step) or `scale` (per second)
//     x += ki p          integrator                stops while the output stands at a limit
//     v  = x + kp p      zero
//     y += alpha (v - y)  pole                     within [minimum, maximum]; frequency = y
//
// This is F(s) = (s R C2 + 1) / (s^2 R C1 C2 + s (C1 + C2)), Eq. (1) of Amano 2003, discretised: on
// every tick with constant s (coefficients per second, as in the paper), or on every update with s
// the frequency itself, so that the loop's bandwidth is a constant part of the stepping rate.
//
// Following sectors (a rotor to be caught, or Hall sensors) x takes e * frequency whole or a
// quarter of it, and goes out directly: with error = 1 - turns this is Newton's iteration for 1 /
// interval.  A ramp is the same with a constant error, quartered `backoff` times, and `ramp` for s.
//
//     x, v, y      u0.36: four bits more than Frequency, so that small gains still integrate
//     s            its upper 22 bits: a gain needs no more; alpha: its upper 15
//     latency      24 clocks per product: about 150 from update to frequency; an update that comes
//                  while busy is ignored
//     registers    about 310 bits     multipliers  none (one serial)
//
// Law: hls/six_step/loop_filter_law.hpp   Doc: docs/blocks/loop_filter.md   Test: tests/hls/loop_filter_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/one_hot.hpp"
#include "hls/numeric/serial_multiplier.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

// kStop: frequency 0.  kRamp: it grows by `ramp` per tick.  kTrack: the PLL is closed.  kCatchSpin, kHall,
// kFollow: it follows the intervals between changes of sector; kFollow from hand_over on, which a slower
// rotor's misses halve sooner than a faster one's intervals could raise it from the minimum.
enum class Loop : std::uint8_t { kStop, kRamp, kTrack, kCatchSpin, kHall, kFollow };

class LoopFilter {
 public:
  struct In {
    Loop loop = Loop::kStop;
    PhaseError error = 0;          // s0.16, turns of one step; held between updates
    bool update = false;           // strobe: the error is new
    bool tick = false;             // strobe: time base of ramp and per-second form
    UInt<20> ramp = 0;             // u0.32, VCO turns per clock, per tick
    UInt<2> backoff = 0;           // the ramp is quartered so often
    Bandwidth bandwidth = Bandwidth::kPerStep;
    UInt<10> delay = 0;            // clocks / 2^divide
    UInt<16> ki = 0;               // u2.14
    UInt<16> kp = 0;               // u2.14
    UInt<16> alpha = 0;            // u1.15
    Frequency scale = 0;           // u0.32, stands for the frequency in the per-second form
    Frequency minimum = 0;         // u0.32, VCO turns per clock
    Frequency maximum = 0;         // u0.32, VCO turns per clock
    Frequency hand_over = 0;       // u0.32, VCO turns per clock
    Frequency stall = 0;           // u0.32, VCO turns per clock
  };

  struct Out {
    Frequency frequency = 0;  // u0.32, VCO turns per clock
    bool fast = false;        // frequency >= hand_over
    bool slow = false;        // frequency < stall
    bool busy = false;        // an update is being worked on
  };

  Out tick(const In& in) {
    const Out out{.frequency = y_.slice<29, 4>(),
                  .fast = shown_ ? !below_ : fast_,
                  .slow = slow_,
                  .busy = !at_.holds(Stage::kIdle)};
    const bool bounds = at_.holds_one_of(Stage::kLow, Stage::kHigh, Stage::kSlow, Stage::kOut);
    const auto product = multiplier_.tick({.start = starts_,
                                           .a = multiplicand(),
                                           .b = factor(in)});
    const bool track = loop_ == Loop::kTrack;
    const bool ticks = loop_ == Loop::kRamp || (track && in.bandwidth == Bandwidth::kPerSecond);
    const bool below = !at_least(offset(wrap<Int<30>>(work_ >> 4)), UInt<30>(not_limit_));
    work(in, product.product, product.done);
    bound(in, below);
    const bool begins = ticks ? in.tick : in.update;
    const bool goes = at_.holds(Stage::kIdle) ? begins : bounds || product.done;
    starts_ = goes || at_.holds(Stage::kIdle);  // and over and over with 0, where there is nothing to multiply
    if (goes) {
      at_ = at_.holds(Stage::kIntegral) && !track ? Stages(Stage::kLow) : at_.next();
    }
    if (loop_ == Loop::kStop) {
      y_ = 0;
      fast_ = slow_ = shown_ = at_top_ = at_bottom_ = false;
      starts_ = true;
      at_ = Stage::kIdle;
    }
    loop_ = in.loop;
    return out;
  }

  // Quiet clocks (docs/theory.md): without a strobe, until a product is complete, and that many at once.
  std::uint64_t quiet() const {
    return at_.holds(Stage::kIdle) ? ~std::uint64_t{0} : !starts_ ? multiplier_.quiet() : 0;
  }
  void skip(std::uint64_t clocks) {
    if (!at_.holds(Stage::kIdle)) multiplier_.skip(multiplicand(), clocks);
  }
  bool operator==(const LoopFilter&) const = default;

 private:
  using Work = Int<34>;  // s-2.36: e', p, x and v stay below 2^-3
  // Six products, each added to something; then the bounds; kOut shows the result.
  enum class Stage : std::uint8_t {
    kIdle, kDelay, kScale, kIntegral, kProportional, kPole, kKeep, kLow, kHigh, kSlow, kOut
  };
  using Stages = OneHot<Stage, 11>;

  Work multiplicand() const {
    return at_.holds_one_of(Stage::kDelay, Stage::kKeep) ? Work(y_) : work_;
  }

  UInt<22> factor(const In& in) const {
    const bool track = loop_ == Loop::kTrack;
    const UInt<15> alpha = in.alpha.slice<15, 1>();
    if (at_.holds(Stage::kDelay)) return track ? in.delay : UInt<10>(0);
    if (at_.holds(Stage::kScale)) {
      return loop_ == Loop::kRamp ? UInt<22>(in.ramp)
             : track && in.bandwidth == Bandwidth::kPerSecond ? in.scale.slice<25, 4>()
                                                              : y_.slice<29, 8>();
    }
    if (at_.holds(Stage::kIntegral)) {
      return track ? in.ki : smooth(in) ? UInt<16>(0x1000) : UInt<16>(0x4000);
    }
    if (at_.holds(Stage::kProportional)) return in.kp;
    if (at_.holds(Stage::kPole)) return alpha;
    return at_.holds(Stage::kKeep) ? wrap<UInt<15>>(UInt<15>(0x4000) - alpha) : UInt<15>(0);
  }

  // Hall sensors stand a few degrees off: small errors count for a quarter, large ones are real.
  bool smooth(const In& in) const {
    return loop_ == Loop::kHall && in.error < 0x4000 && in.error >= -0x4000;
  }

  // A product's turn to be added, all with 14 bits to drop: e' has 22 fraction bits, the rest 36.
  // A bound that is passed is taken in the clock after it was compared with.
  void work(const In& in, Int<56> product, bool done) {
    const bool track = loop_ == Loop::kTrack;
    // Nothing stands behind the adder: a bound comes as what is added to, the product being 0 by then.
    const Work sum = wrap<Work>(base_ + wrap<Work>(product >> 14));
    const bool too_low = at_.holds(Stage::kHigh) && below_;
    const bool too_high = at_.holds(Stage::kSlow) && !below_;
    // A product takes longer than a clock, and a bound waits for one: there is time to fetch what they need.
    if (at_.holds(Stage::kIdle)) {
      base_ = Work(loop_ == Loop::kRamp ? ramp_error(in.backoff) : in.error) << 6;
    } else if (!at_.holds(Stage::kDelay)) {
      base_ = at_.holds_one_of(Stage::kIntegral, Stage::kProportional) ? x_
              : at_.holds(Stage::kKeep)                                ? work_
              : at_.holds(Stage::kLow)  ? wrap<Work>(UInt<30>(least(in)) << 4)
              : at_.holds(Stage::kHigh) ? wrap<Work>(UInt<30>(in.maximum) << 4)
                                        : Work(0);
    }
    if (at_.holds(Stage::kOut)) y_ = wrap<UInt<30>>(work_);
    const bool integrates = at_.holds(Stage::kIntegral) && track;
    const bool winds_up = work_.negative() ? at_bottom_ : at_top_;
    // The integrator takes its product in the clock after; where the loop is not closed, the result: cleared in one
    // clock, added to in the next.
    if (clears_) {
      x_ = 0;
    } else if (adds_) {
      x_ = wrap<Work>(x_ + addend_);
    }
    const bool follows = at_.holds(Stage::kOut) && !track;
    if (done || follows) addend_ = follows ? work_ : wrap<Work>(product >> 14);
    adds_ = follows_ || (done && integrates && !winds_up);
    clears_ = loop_ == Loop::kStop || follows;
    follows_ = follows;
    if ((done && !integrates) || too_low || too_high) work_ = sum;
  }

  // 1/16 of a turn stands for the whole ramp.
  static PhaseError ramp_error(UInt<2> backoff) {
    return backoff == 0 ? PhaseError(0x1000)
           : backoff == 1 ? PhaseError(0x400)
           : backoff == 2 ? PhaseError(0x100)
                         : PhaseError(0x40);
  }

  // A ramp begins at standstill.
  Frequency least(const In& in) const {
    return loop_ == Loop::kRamp ? Frequency(0) : loop_ == Loop::kFollow && fresh_ ? in.hand_over : in.minimum;
  }

  // What a stage compares with is chosen in the one before.
  void bound(const In& in, bool below) {
    if (at_.holds(Stage::kHigh)) at_bottom_ = below_;
    if (at_.holds(Stage::kSlow)) at_top_ = !below_;
    if (at_.holds(Stage::kOut)) slow_ = below_;
    fresh_ = loop_ == Loop::kStop || (fresh_ && !at_.holds(Stage::kOut));
    if (shown_) fast_ = !below_;
    shown_ = at_.holds(Stage::kOut);
    below_ = below;
    const Frequency limit = at_.holds_one_of(Stage::kIntegral, Stage::kKeep) ? least(in)
             : at_.holds(Stage::kLow)                         ? in.maximum
             : at_.holds(Stage::kHigh)                        ? in.stall
                                                              : in.hand_over;
    not_limit_ = ~UInt<29>(limit);
  }

  SerialMultiplier<34, 22> multiplier_;
  Stages at_ = Stage::kIdle;
  bool starts_ = true;      // this is the first clock of a product, or there is none
  Work base_ = 0;           // what the product is added to, or comes instead
  Loop loop_ = Loop::kStop; // a clock ago
  Work work_ = 0;           // e', p, v, and the next y
  Work x_ = 0;              // s-2.36, the integrator
  Work addend_ = 0;         // the product, or the result
  bool adds_ = false;       // the integrator takes it
  bool clears_ = false;     // it is cleared
  bool follows_ = false;    // to take the result
  UInt<30> y_ = 0;          // u0.36, behind the pole
  UInt<29> not_limit_ = 0;  // complement of what this stage compares with
  bool fast_ = false;
  bool slow_ = false;
  bool below_ = false;      // the last clock's comparison: less
  bool shown_ = false;      // y is new, and whether it is fast still in below_
  bool fresh_ = true;       // nothing was measured since kStop
  bool at_top_ = false;     // the output stands at a limit
  bool at_bottom_ = false;
};

}  // namespace steplock
