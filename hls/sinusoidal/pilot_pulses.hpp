// Pilot pulses: the position of a salient rotor at standstill, Matsui 1996, (21)-(26) and Table II.
//
// A pulse connects one winding to the dc voltage against the two others, or the reverse.  With
// direction a (0, 120, 240 degrees, the reverse 180 further) and the N pole at theta it moves the
// current by
//
//     i = e^(ja) (I_o + Delta I_o e^(2j (theta - a)))      along a that is (22)
//     sum of e^(ja) i over all six = 6 Delta I_o e^(2j theta), without I_o, and without what iron
//                                    that saturates adds: that is odd in theta
//     (24)-(26)   2 theta is where that sum, seen from it, is not across: 12 steps of halving
//     polarity    two long pulses along the direction nearest to theta, one each way: the greater
//                 strengthened the magnet, and theta points there
//
// Everything is turned and measured by CurrentControl, whose Park stands still then: in `angle`,
// `a`, `b`, out `i_gamma`, `i_delta`.  A sum is kept as its parts along windings u (`a`, in even
// rounds) and v (`b`, in odd ones), which is what Clarke takes.  Pulses are whole PWM periods,
// chopped; the current is what the ADCs hold at the first strobe after them.  The next pulse,
// and `found`, wait until two samples in a row were below `decayed`.  A reverse follows each pulse
// and takes back what it turned; model/design bounds what is left.
//
//     angle         u0.24, of the N pole from winding u once `found`; 0 after `rest`
//     a, b          s0.15 of the current, modulo: within a round they may pass the full scale
//     latency       1 clock; all outputs follow from registers
//     registers     86 bits     multipliers  none
//
// Law: hls/sinusoidal/pilot_pulses_law.hpp   Doc: docs/blocks/pilot_pulses.md   Test: tests/hls/pilot_pulses_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/sinusoidal/config.hpp"

namespace steplock {

class PilotPulses {
 public:
  struct In {
    bool rest = false;      // all from its begin
    bool enable = false;    // pulses are wanted
    bool period = false;    // a PWM period begins
    bool taken = false;     // a sample has been taken
    bool sampled = false;   // it has been worked through
    bool over = false;      // a current in it is beyond its limit: with `waiting`, `decayed`
    Int<16> i_gamma = 0;    // s0.15, of that sample or of `a` and `b`, seen from `angle`
    bool backward = false;  // i_delta of the same is negative
    PilotConfig config;
  };

  struct Out {
    bool pulse = false;    // gates are wanted: the legs below chopped, the others low
    bool high_u = false;
    bool high_v = false;
    bool high_w = false;
    bool waiting = false;  // gates are off, and the current has to decay
    bool search = false;   // `a` and `b` are to be turned by `angle`
    Int<16> a = 0;         // s0.15
    Int<16> b = 0;         // s0.15
    Angle angle = 0;       // u0.24
    bool found = false;    // it is the rotor's
    SinusoidalReason failed = SinusoidalReason::kNone;
  };

  Out tick(const In& in) {
    const PilotConfig& config = in.config;
    const bool shorts = phase_ == Phase::kShort;
    const bool idle = !pulsing_ && !peak_ && !due_;
    const Out out{.pulse = pulsing_,
                  .high_u = (winding_ == 0) != reversed_,
                  .high_v = (winding_ == 1) != reversed_,
                  .high_w = (winding_ == 2) != reversed_,
                  .waiting = in.enable && idle,
                  .search = phase_ == Phase::kSearch,
                  .a = a_,
                  .b = b_,
                  .angle = seen_from(),
                  .found = phase_ == Phase::kFound,
                  .failed = failed_};
    if (in.rest) {
      *this = PilotPulses();
      return out;
    }
    if (!in.enable) return out;

    if (in.sampled && due_) {
      a_ = wrap<Int<16>>(a_ + in.i_gamma);
      shorts ? next_short(config) : next_long();
    } else if (in.sampled && phase_ == Phase::kSearch) {
      search(in);
    } else if (phase_ == Phase::kJudge && ready_) {
      judge(config);
    } else if (in.sampled && idle) {
      ready_ = quiet_ && !in.over;
      quiet_ = !in.over;
    }
    follow(in, shorts);
    return out;
  }

 private:
  enum class Phase : std::uint8_t { kShort, kSearch, kLong, kJudge, kFound };
  static constexpr int kSteps = 12;

  // The axis from which the current is looked at.  In short rounds that of `a` or `b` less the
  // pulse's direction, in long ones the first pulse's direction: thirds and halves of a turn.
  Angle seen_from() const {
    const bool odd = round_.bit(0), shorts = phase_ == Phase::kShort;
    const bool settled = phase_ == Phase::kFound || phase_ == Phase::kJudge;
    const Angle twice = Angle(angle_.template slice<kSteps - 1, 0>()) << (24 - kSteps);
    if (phase_ == Phase::kSearch) return twice;
    if (settled) return Angle(angle_) << (23 - kSteps);
    const bool one = shorts ? winding_ == (odd ? 0 : 2) : winding_ == 1;
    const bool two = shorts ? winding_ == (odd ? 2 : 1) : winding_ == 2;
    const bool half = reversed_ != (!shorts && odd);
    const UInt<16> third = one ? UInt<16>(0x5555) : two ? UInt<16>(0xaaaa) : UInt<16>(0);
    return Angle(third ^ (half ? UInt<16>(0x8000) : UInt<16>(0))) << 8;
  }

  // The clock's part: what a pulse or its end does at the begin of a period.
  void follow(const In& in, bool shorts) {
    if (in.sampled) due_ = false;
    if (in.taken && peak_) {
      peak_ = false;
      due_ = true;
    }
    if (!in.period) return;
    if (peak_) failed_ = SinusoidalReason::kLostSample;
    if (!pulsing_) {
      pulsing_ = ready_ && phase_ != Phase::kFound && failed_ == SinusoidalReason::kNone;
      left_ = shorts ? in.config.short_periods : in.config.long_periods;
      if (ready_) quiet_ = false;
      ready_ = false;
    } else if ((left_ >> 1) == 0) {
      pulsing_ = false;
      peak_ = true;
    } else {
      left_ = wrap<UInt<6>>(left_ - 1);
    }
  }

  // u, u reversed, v, v reversed, w, w reversed, so many times.
  void next_short(const PilotConfig& config) {
    const bool turn = reversed_ && winding_ == 2;
    if (reversed_) winding_ = turn ? UInt<2>(0) : wrap<UInt<2>>(winding_ + 1);
    reversed_ = !reversed_;
    if (!turn) return;
    round_ = wrap<UInt<5>>(round_ + 1);
    const Int<16> sum = a_;  // of this round's part; the other's turn
    a_ = b_;
    b_ = sum;
    if (round_ == config.rounds) {
      phase_ = Phase::kSearch;
      angle_ = 1 << (kSteps - 1);
      step_ = 1 << (kSteps - 1);
    }
  }

  // `angle_` holds what is sure, and the bit in question.
  void search(const In& in) {
    const auto sure = in.backward ? angle_ ^ step_ : UInt<13>(angle_);
    angle_ = sure | (step_ >> 1);
    step_ = step_ >> 1;
    if (step_ != 0) return;
    if (in.i_gamma < in.config.saliency) failed_ = SinusoidalReason::kNoSaliency;
    phase_ = Phase::kLong;
    a_ = 0;
    round_ = 0;
    // theta / 11.25 degrees; at 33.75, 90 and 146.25 the next direction takes over.
    const auto place = angle_.template slice<kSteps - 1, kSteps - 4>();
    winding_ = place < 3 || place >= 13 ? 0 : place < 8 ? 2 : 1;
    reversed_ = (place >= 3 && place < 8) || place >= 13;
  }

  void next_long() {
    if (round_ == 1) phase_ = Phase::kJudge;
    reversed_ = !reversed_;
    round_ = 1;
  }

  void judge(const PilotConfig& config) {
    const bool along = (config.polarity - a_).negative(), against = (config.polarity + a_).negative();
    if (against) angle_ = angle_ | (1 << kSteps);
    if (along || against) {
      phase_ = Phase::kFound;
    } else {
      failed_ = SinusoidalReason::kNoPolarity;
    }
  }

  Phase phase_ = Phase::kShort;
  SinusoidalReason failed_ = SinusoidalReason::kNone;
  Int<16> a_ = 0;             // s0.15, modulo
  Int<16> b_ = 0;             // s0.15, modulo
  UInt<kSteps + 1> angle_ = 0;  // u0.13, half a turn is the polarity
  UInt<kSteps> step_ = 0;     // the bit of it in question
  UInt<5> round_ = 0;         // of short pulses; of the long ones, the second
  UInt<2> winding_ = 0;       // u, v, w
  bool reversed_ = false;
  UInt<6> left_ = 0;          // periods of the pulse
  bool pulsing_ = false;
  bool peak_ = false;         // its end's sample is to be taken
  bool due_ = false;          // and to be worked through
  bool quiet_ = false;        // the last sample showed no current
  bool ready_ = false;        // nor did the one before
};

}  // namespace steplock
