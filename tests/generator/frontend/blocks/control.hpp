// Test blocks: states, branches, early returns, loops with early exits.

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock::test {

enum class Phase6 : std::uint8_t { kIdle, kAlign, kRamp, kRun, kBrake = 6 };

class StateMachine {
 public:
  struct In {
    bool start = false, stop = false, fault = false;
    UInt<5> dwell = 0;
    Phase6 wish = Phase6::kIdle;
    template <class F>
    void each(F f) { f(start), f(stop), f(fault), f(dwell), f(wish); }
  };
  struct Out {
    Phase6 phase = Phase6::kIdle;
    UInt<6> step = 0;
    bool gates = false;
    int latched = 0;
    template <class F>
    void each(F f) { f(phase), f(step), f(gates), f(latched); }
  };

  Out tick(const In& in) {
    Out out;
    out.step = step();
    out.gates = phase_ == Phase6::kRamp || phase_ == Phase6::kRun;
    out.latched = latched_;
    out.phase = phase_;
    if (in.fault) {
      latched_ = latched_ < 3 ? latched_ + 1 : -4;
      phase_ = Phase6::kIdle;
      return out;
    }
    if (timer_ != 0) {
      timer_ = wrap<UInt<5>>(timer_ - 1);
      if (!in.stop) return out;
    }
    advance(in);
    return out;
  }

 private:
  void advance(const In& in) {
    timer_ = in.dwell;
    switch (phase_) {
      case Phase6::kIdle:
        if (in.start) phase_ = Phase6::kAlign;
        else phase_ = in.wish;
        break;
      case Phase6::kAlign: phase_ = in.stop ? Phase6::kIdle : Phase6::kRamp; break;
      case Phase6::kRamp:
      case Phase6::kRun:
        if (in.stop) {
          phase_ = Phase6::kBrake;
          return;
        }
        phase_ = Phase6::kRun;
        break;
      default: phase_ = Phase6::kIdle;
    }
  }

  UInt<6> step() const {
    switch (timer_.raw() & 7) {
      case 0: return 0b100001;
      case 1: return 0b100100;
      case 2: return 0b000110;
      case 3: return 0b010010;
      case 4: return 0b011000;
      case 5: return 0b001001;
      default: return 0;
    }
  }

  Phase6 phase_ = Phase6::kIdle;
  UInt<5> timer_ = 9;
  int latched_ = -1;
};

// Its register of an enumeration never leaves its six values, which takes a proof over the clock.
enum class Sector : std::uint8_t { k0, k1, k2, k3, k4, k5 };

class SectorCounter {
 public:
  struct In {
    bool forward = false, backward = false;
    template <class F>
    void each(F f) { f(forward), f(backward); }
  };
  struct Out {
    Sector sector = Sector::k0;
    template <class F>
    void each(F f) { f(sector); }
  };
  Out tick(const In& in) {
    const auto now = static_cast<unsigned>(sector_);
    if (in.forward) sector_ = static_cast<Sector>(now == 5 ? 0 : now + 1);
    if (in.backward && !in.forward) sector_ = static_cast<Sector>(now == 0 ? 5 : now - 1);
    return {sector_};
  }

 private:
  Sector sector_ = Sector::k2;
};

// Loops: bounds from templates and outer loops, break, continue, while, do, nested.
template <int N>
class Loops {
 public:
  struct In {
    UInt<N> word = 0;
    std::uint8_t limit = 0;
    template <class F>
    void each(F f) { f(word), f(limit); }
  };
  struct Out {
    UInt<8> ones = 0, leading = 0, first = 0, triangle = 0, shifted = 0, gray = 0;
    template <class F>
    void each(F f) { f(ones), f(leading), f(first), f(triangle), f(shifted), f(gray); }
  };

  Out tick(const In& in) {
    Out out;
    for (int i = 0; i < N; ++i) out.ones = wrap<UInt<8>>(out.ones + UInt<1>(in.word.bit(i)));
    for (int i = N - 1; i >= 0; --i) {
      if (in.word.bit(i)) break;
      out.leading = wrap<UInt<8>>(out.leading + 1);
    }
    UInt<N> rest = in.word;
    while (rest != 0) {
      rest = rest >> 1;
      out.first = wrap<UInt<8>>(out.first + 1);
    }
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j <= i; ++j) {
        if (j == 1) continue;
        if (in.word.bit((i + j) % N)) out.triangle = wrap<UInt<8>>(out.triangle + (i * 4 + j));
      }
    }
    int count = 0;
    do {
      out.shifted = wrap<UInt<8>>((out.shifted << 1) + count);
    } while (++count < 5 && count < in.limit);
    for (UInt<4> i = 0; i < 8; i = wrap<UInt<4>>(i + 1)) {
      if (in.limit & (1U << i.raw())) out.gray = out.gray ^ UInt<8>(i);
    }
    total_ = wrap<UInt<8>>(total_ + out.ones);
    out.ones = total_;
    return out;
  }

 private:
  UInt<8> total_ = 0;
};

}  // namespace steplock::test
