// Loop filter: from phase error to VCO frequency, with the three parts of a lag-lead filter.
//
//     e' = error + delay * frequency               the sampling's constant delay, taken back
//     p  = e' * s                                  s = frequency (per step) or `scale` (per second)
//     x += ki p          integrator                stops while the output stands at a limit
//     v  = x + kp p      zero
//     y += pole (v - y)  pole                      within [minimum, maximum]; frequency = y
//
// This is F(s) = (s R C2 + 1) / (s^2 R C1 C2 + s (C1 + C2)), Eq. (1) of Amano 2003, discretised: on
// every tick with constant s (coefficients per second, as in the paper), or on every update with s
// the frequency itself, so that the loop's bandwidth is a constant part of the stepping rate.
//
// Following sectors (a rotor to be caught, or Hall sensors) x takes e * frequency whole or a
// quarter of it, and goes out directly: with error = 1 - turns this is Newton's iteration for 1 /
// interval.  A ramp is the same with a constant error, quartered `gentle` times, and `ramp` for s.
//
//     x, v, y      u0.36: four bits more than Frequency, so that small gains still integrate
//     s            its upper 22 bits: a gain needs no more; pole: its upper 15
//     latency      24 clocks per product: about 150 from update to frequency; an update that comes
//                  while busy is passed over
//     registers    about 195 bits     multipliers  none (one serial)
//
// Doc: docs/blocks/loop_filter.md   Test: tests/hls/loop_filter_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/serial_multiplier.hpp"
#include "hls/six_step/words.hpp"

namespace steplock {

// kStop: frequency 0.  kRamp: it grows by `ramp` per tick.  kTrack: the PLL is closed.  kCatch,
// kHall: it follows the intervals between changes of sector.
enum class Loop : std::uint8_t { kStop, kRamp, kTrack, kCatch, kHall };

class LoopFilter {
 public:
  struct In {
    Loop loop = Loop::kStop;
    PhaseError error = 0;          // s0.16, turns of one step; held between updates
    bool update = false;           // strobe: the error is new
    bool tick = false;             // strobe: time base of ramp and per-second form
    UInt<20> ramp = 0;             // u0.32, VCO turns per clock, per tick
    UInt<2> gentle = 0;            // the ramp is quartered so often
    Bandwidth bandwidth = Bandwidth::kPerStep;
    UInt<10> delay = 0;            // clocks / 2^divide
    UInt<16> ki = 0;               // u2.14
    UInt<16> kp = 0;               // u2.14
    UInt<16> pole = 0;             // u1.15
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
                  .fast = fast_,
                  .slow = slow_,
                  .busy = stage_ != Stage::kIdle};
    const bool multiplies = stage_ >= Stage::kDelay && stage_ <= Stage::kKeep;
    const auto product = multiplier_.tick({.start = multiplies && !started_,
                                           .a = multiplicand(),
                                           .b = factor(in)});
    const Frequency limit = bound(in);
    const bool below = wrap<Int<30>>(work_ >> 4) < limit;
    if (in.loop == Loop::kStop) {
      x_ = 0;
      y_ = 0;
      fast_ = slow_ = at_top_ = at_bottom_ = started_ = false;
      stage_ = Stage::kIdle;
    } else if (multiplies) {
      started_ = !product.done;
      if (product.done) add(in, product.product);
    } else {
      finish(in, limit, below);
    }
    return out;
  }

  // Quiet clocks (docs/theory.md): without a strobe, until a product is complete, and that many at once.
  std::uint64_t quiet() const {
    return stage_ == Stage::kIdle ? ~std::uint64_t{0} : started_ ? multiplier_.quiet() : 0;
  }
  void skip(std::uint64_t clocks) {
    if (stage_ != Stage::kIdle) multiplier_.skip(multiplicand(), clocks);
  }
  bool operator==(const LoopFilter&) const = default;

 private:
  using Work = Int<34>;  // s-2.36: e', p, x and v stay below 2^-3
  // Six products, each added to something; then the bounds; kOut shows the result.
  enum class Stage : std::uint8_t {
    kIdle, kDelay, kScale, kIntegral, kProportional, kPole, kKeep, kLow, kHigh, kSlow, kOut
  };

  Work multiplicand() const {
    return stage_ == Stage::kDelay || stage_ == Stage::kKeep ? Work(y_) : work_;
  }

  UInt<22> factor(const In& in) const {
    const bool track = in.loop == Loop::kTrack;
    const UInt<15> pole = in.pole.slice<15, 1>();
    switch (stage_) {
      case Stage::kDelay: return track ? in.delay : UInt<10>(0);
      case Stage::kScale:
        return in.loop == Loop::kRamp ? UInt<22>(in.ramp)
               : track && in.bandwidth == Bandwidth::kPerSecond ? in.scale.slice<25, 4>()
                                                                : y_.slice<29, 8>();
      case Stage::kIntegral:
        return track ? in.ki : smooth(in) ? UInt<16>(0x1000) : UInt<16>(0x4000);
      case Stage::kProportional: return in.kp;
      case Stage::kPole: return pole;
      default: return wrap<UInt<15>>(UInt<15>(0x4000) - pole);
    }
  }

  // Hall sensors stand a few degrees off: small errors count for a quarter, large ones are real.
  static bool smooth(const In& in) {
    return in.loop == Loop::kHall && in.error < 0x4000 && in.error >= -0x4000;
  }

  // A product's turn to be added, all with 14 bits to drop: e' has 22 fraction bits, the rest 36.
  void add(const In& in, Int<56> product) {
    const bool ramp = in.loop == Loop::kRamp;
    const PhaseError error = ramp ? ramp_error(in.gentle) : in.error;
    const Work base = stage_ == Stage::kDelay ? wrap<Work>(Work(error) << 6)
                      : stage_ == Stage::kIntegral || stage_ == Stage::kProportional ? x_
                      : stage_ == Stage::kKeep ? work_
                                               : Work(0);
    const Work sum = wrap<Work>(base + wrap<Work>(product >> 14));
    const bool integral = stage_ == Stage::kIntegral;
    const bool track = in.loop == Loop::kTrack;
    const bool winds_up = work_.negative() ? at_bottom_ : at_top_;
    if (integral && track) {
      if (!winds_up) x_ = sum;
    } else {
      work_ = sum;
    }
    stage_ = integral && !track ? Stage::kLow : next(stage_);
  }

  // 1/16 of a turn stands for the whole ramp.
  static PhaseError ramp_error(UInt<2> gentle) {
    return gentle == 0 ? PhaseError(0x1000)
           : gentle == 1 ? PhaseError(0x400)
           : gentle == 2 ? PhaseError(0x100)
                         : PhaseError(0x40);
  }

  static Stage next(Stage stage) { return static_cast<Stage>(static_cast<int>(stage) + 1); }

  // A ramp begins at standstill.
  Frequency bound(const In& in) const {
    switch (stage_) {
      case Stage::kLow: return in.loop == Loop::kRamp ? Frequency(0) : in.minimum;
      case Stage::kHigh: return in.maximum;
      case Stage::kSlow: return in.stall;
      default: return in.hand_over;
    }
  }

  void finish(const In& in, Frequency limit, bool below) {
    const bool ticks = in.loop == Loop::kRamp ||
                       (in.loop == Loop::kTrack && in.bandwidth == Bandwidth::kPerSecond);
    const bool outside = (stage_ == Stage::kLow && below) || (stage_ == Stage::kHigh && !below);
    if (outside) work_ = wrap<Work>(UInt<30>(limit) << 4);
    switch (stage_) {
      case Stage::kIdle:
        if (ticks ? in.tick : in.update) stage_ = Stage::kDelay;
        break;
      case Stage::kLow:
        at_bottom_ = outside;
        stage_ = Stage::kHigh;
        break;
      case Stage::kHigh:
        at_top_ = outside;
        stage_ = Stage::kSlow;
        break;
      case Stage::kSlow:
        slow_ = below;
        stage_ = Stage::kOut;
        break;
      default:
        y_ = wrap<UInt<30>>(work_);
        if (in.loop != Loop::kTrack) x_ = work_;
        fast_ = !below;
        stage_ = Stage::kIdle;
        break;
    }
  }

  SerialMultiplier<34, 22> multiplier_;
  Stage stage_ = Stage::kIdle;
  bool started_ = false;    // the stage's product is under way
  Work work_ = 0;           // e', p, v, and the next y
  Work x_ = 0;              // s-2.36, the integrator
  UInt<30> y_ = 0;          // u0.36, behind the pole
  bool fast_ = false;
  bool slow_ = false;
  bool at_top_ = false;     // the output stands at a limit
  bool at_bottom_ = false;
};

}  // namespace steplock
