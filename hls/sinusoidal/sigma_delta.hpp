// Sigma-delta front end: three modulators of AMC1306 class to the codes of two currents and the dc voltage.
//
//     mclk     the modulators' clock, 2 half clocks a bit; a bit is taken as it stood at the rising edge,
//              one period after the edge that drove it
//     window   begins `delay` bits after the sample strobe and lasts 3 M bits, M = 2^Log2
//     codes    the sinc3 mean around the window's middle, delay + (3 M - 3) / 2 bits after the strobe
//
// With delay = 0 that middle, the instant of the codes, is (3 M - 3) / 2 bits after the strobe.  With
// delay = bits of a PWM period - (3 M - 3) / 2 it is the next strobe itself, and the ripple of a
// symmetric pattern cancels; the codes come half a window later either way.  Strobe and bits are not
// in step: the instant moves by up to one bit.
//
//     window's end to valid    4 clocks; strobe to valid: delay + 3 M bits, up to one more, and 5 clocks
//     registers                31 bits and three filters     multipliers  none
//
// Doc: docs/blocks/sigma_delta.md   Test: tests/hls/sigma_delta_test.cpp

#pragma once

#include "hls/sinusoidal/current_sense.hpp"
#include "hls/sinusoidal/sinc3.hpp"

namespace steplock {

struct SigmaDeltaConfig {
  UInt<6> half = 0;    // clocks of half an mclk period; 0: off
  UInt<16> delay = 0;  // bits from the strobe to the window
};

template <int Log2 = 6>
class SigmaDelta {
  static_assert(Log2 >= 5, "a code has twelve bits");
  static constexpr int kBits = 3 * Log2;

 public:
  // One bit of each modulator.
  struct Streams {
    bool u = false;
    bool v = false;
    bool dc = false;
  };

  struct In {
    bool sample = false;  // strobe
    Streams data;         // pins
    SigmaDeltaConfig config;
  };

  struct Out {
    bool mclk = false;    // pin
    CurrentSense::Codes codes;
    bool missed = false;  // one clock: a window was cut or not begun when the next one was due
  };

  Out tick(const In& in) {
    const bool takes = rises_.bit(1);
    const bool starts = waits_ && left_ == 0;
    const auto u = u_.tick({.start = starts, .valid = takes, .bit = second_.u});
    const auto v = v_.tick({.start = starts, .valid = takes, .bit = second_.v});
    const auto dc = dc_.tick({.start = starts, .valid = takes, .bit = second_.dc});
    const Out out{.mclk = mclk_,
                  .codes = {.valid = u.done, .u = current(u.value), .v = current(v.value),
                            .dc = voltage(dc.value)},
                  .missed = missed_};
    missed_ = (starts && u.busy) || (in.sample && waits_ && !starts);

    if (in.sample) {
      waits_ = true;
      left_ = in.config.delay;
    } else if (starts) {
      waits_ = false;
    } else if (waits_ && takes) {
      left_ = wrap<UInt<16>>(left_ - 1);
    }

    second_ = first_;
    first_ = in.data;
    const bool turns = in.config.half != 0 && clocks_ == 0;
    rises_ = wrap<UInt<2>>(rises_ << 1) | UInt<2>(turns && !mclk_ ? 1 : 0);
    if (turns) mclk_ = !mclk_;
    clocks_ = clocks_ == 0 ? wrap<UInt<6>>(in.config.half - 1) : wrap<UInt<6>>(clocks_ - 1);
    return out;
  }

 private:
  // s0.(kBits - 1), rounded to s0.11; and its positive half to u0.12.
  static Int<12> current(Int<kBits> value) {
    return saturate<Int<12>>((value + Int<kBits>(1 << (kBits - 13))) >> (kBits - 12));
  }
  static UInt<12> voltage(Int<kBits> value) {
    return saturate<UInt<12>>((value + Int<kBits>(1 << (kBits - 14))) >> (kBits - 13));
  }

  Sinc3<Log2> u_;
  Sinc3<Log2> v_;
  Sinc3<Log2> dc_;

  Streams first_;        // synchroniser
  Streams second_;
  bool mclk_ = false;
  UInt<6> clocks_ = 0;   // left of this half period, without this one
  UInt<2> rises_ = 0;    // mclk rose in the last clocks
  bool waits_ = false;   // for the window
  UInt<16> left_ = 0;    // bits to it
  bool missed_ = false;
};

}  // namespace steplock
