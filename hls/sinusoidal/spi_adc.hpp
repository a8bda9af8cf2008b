// SPI ADC front end: a 12-bit ADC of AD7928 class to the codes of two currents and the dc voltage.
//
//     sample   conversion of u at once, then v and dc: three frames of 16 bits, cs_n up between them
//     frame    reads the result of the present channel while it writes the address of the next one,
//              so that u is already selected when the next sample comes
//     wake     two frames of ones and one with u's address: after reset, after `half` was 0, and after
//              a wrong answer
//
// Every answer has to begin with a zero and the address of its channel: an ADC that lost its
// place, or a line that does not move, gives an error instead of a current.  The ADC holds its
// input when cs_n falls.  Per frame: 33 half + quiet clocks.
//
//     `sample` to cs_n, which holds u    1 clock; v and dc one and two frames later
//     `sample` to valid                  98 half + 2 quiet + 4 clocks
//     pin to code                        miso as it stood at the falling edge of sclk, one period after
//                                        the edge that drove it; two flip-flops
//     registers    73 bits     multipliers  none
//
// Doc: docs/blocks/spi_adc.md   Test: tests/hls/spi_adc_test.cpp

#pragma once

#include "hls/sinusoidal/current_sense.hpp"

namespace steplock {

struct SpiAdcConfig {
  UInt<6> half = 0;    // clocks of half an sclk period; 0: off
  UInt<8> quiet = 0;   // clocks of cs_n high between frames; less than 4 counts as 4
  UInt<3> u = 0;       // channel of the current of phase u
  UInt<3> v = 0;       // channel of the current of phase v
  UInt<3> dc = 0;      // channel of the dc voltage
  bool twice = false;  // the range is twice the reference, not once
};

class SpiAdc {
 public:
  struct In {
    bool sample = false;  // strobe: hold now
    bool miso = false;    // pin, from the ADC's DOUT
    SpiAdcConfig config;    // stand still while not off
  };

  struct Out {
    bool cs_n = true;     // pin
    bool sclk = true;     // pin, to SCLK; high between frames
    bool mosi = false;    // pin, to DIN
    CurrentSense::Codes codes;
    bool ready = false;   // a sample would be taken now
    bool missed = false;  // one clock: `sample` came while not ready, and has no codes
    bool error = false;   // one clock: a wrong answer; the sample has no codes
  };

  Out tick(const In& in) {
    const SpiAdcConfig& config = in.config;
    const bool over = left_ == 0;
    const bool rests = !selected_ && over && config.half != 0;
    const Out out{.cs_n = !selected_,
                  .sclk = sclk_,
                  .mosi = mosi_,
                  .codes = {.valid = valid_, .u = u_, .v = v_, .dc = answer_.slice<11, 0>()},
                  .ready = rests && frame_ == Frame::kU,
                  .missed = missed_,
                  .error = error_};
    missed_ = in.sample && !out.ready;

    judge(config);
    // As the pin stood at the falling edge, two clocks later.
    whole_ = falls_.bit(1) && half_ == 31;
    if (falls_.bit(1)) answer_ = (answer_ << 1) | UInt<16>(second_ ? 1 : 0);
    second_ = first_;
    first_ = in.miso;

    bool falls = false;
    if (rests) {
      if (frame_ != Frame::kU || in.sample) {
        selected_ = true;
        half_ = 0;
        mosi_ = true;  // the first bit of every frame
        left_ = wrap<UInt<8>>((UInt<8>(config.half) << 1) - 1);  // the first bit takes as long as all
      }
    } else if (!over) {
      left_ = wrap<UInt<8>>(left_ - 1);
    } else if (selected_) {
      falls = half_ != 31 && !half_.bit(0);
      sclk_ = !falls;
      if (half_ == 31) {
        selected_ = false;
        left_ = config.quiet < 4 ? UInt<8>(3) : wrap<UInt<8>>(config.quiet - 1);
      } else {
        half_ = wrap<UInt<5>>(half_ + 1);
        if (!falls) mosi_ = written(half_.slice<4, 1>(), config);
        left_ = wrap<UInt<8>>(config.half - 1);
      }
    } else {
      frame_ = Frame::kWake;  // off
    }
    falls_ = wrap<UInt<2>>(falls_ << 1) | UInt<2>(falls ? 1 : 0);
    return out;
  }

 private:
  enum class Frame : std::uint8_t { kWake, kWakeAgain, kSelect, kU, kV, kDc };

  // What to do with a frame's answer, once it is whole; before the next one begins.
  void judge(const SpiAdcConfig& config) {
    const bool right = answer_.slice<15, 12>() == UInt<4>(channel(frame_, config));
    const bool counts = frame_ == Frame::kU || frame_ == Frame::kV || frame_ == Frame::kDc;
    // Straight binary to two's complement: the upper bit turns round.
    const auto current = Int<12>::of((answer_.slice<11, 0>() ^ UInt<12>(2048)).raw());
    if (whole_ && frame_ == Frame::kU) u_ = current;
    if (whole_ && frame_ == Frame::kV) v_ = current;
    valid_ = whole_ && frame_ == Frame::kDc && right;
    error_ = whole_ && counts && !right;
    if (whole_) frame_ = error_ ? Frame::kWake : after(frame_);
  }

  static UInt<3> channel(Frame frame, const SpiAdcConfig& config) {
    switch (frame) {
      case Frame::kU: return config.u;
      case Frame::kV: return config.v;
      default: return config.dc;
    }
  }
  static Frame after(Frame frame) {
    switch (frame) {
      case Frame::kWake: return Frame::kWakeAgain;
      case Frame::kWakeAgain: return Frame::kSelect;
      case Frame::kSelect: return Frame::kU;
      case Frame::kU: return Frame::kV;
      case Frame::kV: return Frame::kDc;
      default: return Frame::kU;
    }
  }

  // Control register, first bit first: write, no sequence, -, address, normal power, no shadow, -,
  // range, straight binary.
  bool written(UInt<4> bit, const SpiAdcConfig& config) const {
    if (frame_ == Frame::kWake || frame_ == Frame::kWakeAgain) return true;
    const UInt<3> address = channel(after(frame_), config);
    switch (bit.raw()) {
      case 0: return true;
      case 3: return address.bit(2);
      case 4: return address.bit(1);
      case 5: return address.bit(0);
      case 6: return true;
      case 7: return true;
      case 10: return !config.twice;
      case 11: return true;
      default: return false;
    }
  }

  Frame frame_ = Frame::kWake;  // the present one, or the next
  bool selected_ = false;       // within a frame
  UInt<5> half_ = 0;            // half periods of sclk since cs_n fell
  UInt<8> left_ = 0;            // clocks of this half, or to the next frame, without this one
  bool sclk_ = true;
  bool mosi_ = false;
  bool first_ = false;          // synchroniser
  bool second_ = false;
  UInt<2> falls_ = 0;           // sclk fell in the last clocks
  bool whole_ = false;          // one clock: the answer has all its bits
  UInt<16> answer_ = 0;
  Int<12> u_ = 0;               // s0.11
  Int<12> v_ = 0;               // s0.11
  bool valid_ = false;
  bool missed_ = false;
  bool error_ = false;
};

}  // namespace steplock
