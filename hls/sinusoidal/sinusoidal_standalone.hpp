// The sinusoidal drive without a host: its words stand still, pins run it, and an ADC of the
// AD7928's class gives it currents and dc voltage.
//
//     run      high starts, low stops: by braking if `brake_to_stop`, else all six gates off; a start
//              that is given up brakes
//     reverse  direction of rotation; a change while running slows down, brakes, and starts again
//     speed    (speed + 1) / 4 of the set speed, but never less than 35/32 of the lock speed
//
// A switch bounces: what the pins say is taken every 256 PWM periods (13 ms at 20 kHz), where a period
// begins, so that no sample sees two speeds; but for the end of `run`, which counts at once.  A latched
// fault is re-armed by taking `run` away: again and again until its cause is gone.
//
// What a sample gives acts in the next period if its on-times come before that begins, else one later;
// and it has to be through by then, because the arithmetic reads what that period moves on.
//
//     `sample` to the hold of u         2 clocks; v and dc one and two frames of SpiAdc later
//     `sample` to codes                 98 half + 2 quiet + 5 clocks
//     codes to new on-times             229 clocks
//     `sample` to the end of it         `clocks_of_a_sample`: a period has to be as long
//     fault pin to all six gates off    3 clocks, as without this block around it
//     `run` low to the drive            2 clocks, all gates off another 2 when it coasts
//     registers    21 bits beyond those of drive and ADC     multipliers  none
//
// Doc: docs/blocks/sinusoidal_standalone.md   Test: tests/hls/sinusoidal_standalone_test.cpp

#pragma once

#include "hls/sinusoidal/sinusoidal_control.hpp"
#include "hls/sinusoidal/sinusoidal_top.hpp"
#include "hls/sinusoidal/spi_adc.hpp"

namespace steplock {

class SinusoidalStandalone {
 public:
  struct Pins {
    bool fault = false;  // active high
    bool miso = false;   // from the ADC's DOUT
  };

  struct Controls {
    bool run = false;
    bool reverse = false;
    UInt<2> speed = 0;  // 0 to 3: a quarter to the whole of the set speed
  };

  struct In {
    Pins pins;                   // asynchronous
    Controls controls;           // asynchronous too
    bool brake_to_stop = false;  // else coast; fixed at synthesis, as are the words
    SpiAdcConfig adc;
    SinusoidalConfig config;
  };

  struct Out {
    Gates gates;
    bool cs_n = true;     // to the ADC
    bool sclk = true;
    bool mosi = false;
    bool locked = false;  // running, the estimate is claimed to be right
    bool fault = false;   // latched
    bool turn = false;    // a tachometer, one period per electrical turn while the loop is closed
  };

  static constexpr int clocks_of_a_sample(int half, int quiet) {
    const int codes = 98 * half + 2 * (quiet < 4 ? 4 : quiet) + 5;
    return codes + 1 + SinusoidalLoop::kClocks;
  }

  Out tick(const In& in) {
    const auto adc = adc_.tick(
        {.sample = sampled_, .miso = in.pins.miso, .config = in.adc});
    const bool takes = sampled_ && bounce_ == Bounce(0);
    SinusoidalConfig config = in.config;
    config.speed.target = target(in.config.speed);
    const auto drive = drive_.tick({.fault = in.pins.fault,
                                    .codes = adc.codes,
                                    .command = {.configured = true,
                                                .run = taken_.run && second_.run,
                                                .reverse = taken_.reverse,
                                                .brake_to_stop = in.brake_to_stop,
                                                .clear_fault = takes},  // not while told to run
                                    .config = config});
    if (takes) taken_ = second_;
    taken_.run = taken_.run && second_.run;
    if (sampled_) bounce_ = wrap<Bounce>(bounce_ + 1);
    sampled_ = drive.sample;
    second_ = first_;
    first_ = in.controls;
    return {.gates = drive.gates,
            .cs_n = adc.cs_n,
            .sclk = adc.sclk,
            .mosi = adc.mosi,
            .locked = drive.locked,
            .fault = drive.state == SinusoidalState::kFault,
            .turn = drive.estimating && drive.angle.bit(23)};
  }

 private:
  using Bounce = UInt<8>;
  using Target = UInt<25>;  // u0.25 of 1/16 turn per sample

  // Quarters are sums of halves; at the lock speed itself no estimate would ever be trusted.
  Target target(const RegulatorConfig& config) const {
    const Target whole = config.target;
    const Target half = whole >> 1;
    const Target quarter = whole >> 2;
    Target part = whole;
    if (taken_.speed == 0) part = quarter;
    if (taken_.speed == 1) part = half;
    if (taken_.speed == 2) part = wrap<Target>(half + quarter);
    const Target lock = Target(config.lock) << 10;  // of u0.15
    const auto least = saturate<Target>(lock + (lock >> 4) + (lock >> 5));
    return part < least ? least : part;
  }

  SpiAdc adc_;
  SinusoidalTop drive_;
  Controls first_;   // two flip-flops for each pin; nothing but the second reads the first
  Controls second_;
  Controls taken_;   // what the drive is told
  Bounce bounce_ = 0;
  bool sampled_ = false;  // a period has begun
};

}  // namespace steplock
