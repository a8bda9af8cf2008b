// Against an ADC that answers bit by bit as the AD7928's data sheet says: every code, the times, any delay
// of the line, and what an ADC out of step does.

#include "hls/sinusoidal/spi_adc.hpp"

#include <gtest/gtest.h>

#include "hls/sinusoidal/sinusoidal_top.hpp"
#include "tests/hls/spi_adc_model.hpp"

namespace steplock {
namespace {

struct Bench {
  explicit Bench(int half = 2, int quiet = 10) {
    in.config = {.half = half, .quiet = quiet, .u = 3, .v = 6, .dc = 1};
    adc.config = in.config;
    adc.input = [](int channel, long) { return 100 * channel; };
  }
  SpiAdc::Out tick(bool sample = false) {
    in.sample = sample;
    out = dut.tick(in);
    in.miso = adc.clock({out.cs_n, out.sclk, out.mosi});
    if (broken) in.miso = broken(in.miso);
    errors += out.error;
    missed += out.missed;
    return out;
  }
  void wake() {
    for (int i = 0; i < 100'000 && !out.ready; ++i) tick();
  }
  // Clocks to valid, or 0 if there is none.
  int sampled(int limit = 20'000) {
    tick(true);
    for (int clock = 1; clock < limit; ++clock) {
      if (tick().codes.valid) {
        codes = out.codes;
        wake();
        return clock;
      }
    }
    return 0;
  }

  SpiAdc dut;
  SpiAdc::In in;
  SpiAdc::Out out;
  SpiAdcModel adc;
  CurrentSense::Codes codes;
  std::function<bool(bool)> broken;
  int errors = 0, missed = 0;
};

TEST(SpiAdc, EveryCodeOfEveryChannelArrives) {
  Bench b(1, 4);
  int k = 0;
  b.adc.input = [&](int channel, long) {
    return channel == 3 ? k : channel == 6 ? 4095 - k : channel == 1 ? (k * 1365) & 4095 : 0;
  };
  b.wake();
  for (k = 0; k < 4096; ++k) {
    ASSERT_NE(b.sampled(), 0);
    ASSERT_EQ(b.codes.u, k - 2048);
    ASSERT_EQ(b.codes.v, 2047 - k);
    ASSERT_EQ(b.codes.dc, (k * 1365) & 4095);
  }
  EXPECT_EQ(b.adc.violations + b.errors + b.missed, 0);
}

TEST(SpiAdc, HoldsAndCodesComeWhenTheHeaderSays) {
  for (const int half : {1, 2, 3, 7, 63}) {
    for (const int quiet : {4, 5, 30, 255}) {
      Bench b(half, quiet);
      b.wake();
      const long strobe = b.adc.now() + 1;
      ASSERT_EQ(b.sampled(30'000), 98 * half + 2 * quiet + 4);
      const int frame = 33 * half + quiet;
      EXPECT_EQ(b.adc.held[3], strobe + 1);
      EXPECT_EQ(b.adc.held[6], strobe + 1 + frame);
      EXPECT_EQ(b.adc.held[1], strobe + 1 + 2 * frame);
      EXPECT_EQ(b.adc.violations, 0);
    }
  }
}

TEST(SpiAdc, AnyDelayOfTheLineBelowAPeriodIsReadAndALongerOneIsNoticed) {
  for (const int half : {1, 2, 3, 4}) {
    for (int delay = 1; delay <= 2 * half; ++delay) {
      Bench b(half);
      b.adc.delay = delay;
      b.wake();
      const bool comes = b.sampled(2000) != 0;
      EXPECT_EQ(comes, delay < 2 * half) << half << " " << delay;
      EXPECT_EQ(b.errors != 0, delay == 2 * half);
      EXPECT_TRUE(!comes || b.codes.u == 300 - 2048);
    }
  }
}

TEST(SpiAdc, ALineThatStandsStillIsAnErrorAndNoCurrent) {
  for (const bool level : {false, true}) {
    Bench b;
    b.wake();
    b.broken = [=](bool) { return level; };
    EXPECT_EQ(b.sampled(2000), 0);
    EXPECT_EQ(b.errors, 1);
    b.broken = nullptr;
    b.wake();
    EXPECT_NE(b.sampled(), 0);
    EXPECT_EQ(b.codes.u, 300 - 2048);
  }
}

TEST(SpiAdc, AnotherChannelInAnyOfASamplesThreeFramesIsAnError) {
  for (int frame = 0; frame < 3; ++frame) {
    Bench b;
    b.wake();
    const int first = b.adc.frames;
    b.broken = [&](bool bit) { return bit != (b.adc.frames == first + frame); };
    EXPECT_EQ(b.sampled(2000), 0) << frame;
    EXPECT_EQ(b.errors, 1) << frame;
  }
}

TEST(SpiAdc, AConverterThatForgotItsChannelIsWokenAgain) {
  Bench b;
  b.wake();
  ASSERT_NE(b.sampled(), 0);
  b.adc.reset();
  for (int tries = 0; tries < 3; ++tries) {
    if (b.sampled(2000) != 0) break;
    b.wake();
  }
  EXPECT_GE(b.errors, 1);
  EXPECT_EQ(b.codes.u, 300 - 2048);
  EXPECT_EQ(b.codes.v, 600 - 2048);
  EXPECT_EQ(b.codes.dc, 100);
}

TEST(SpiAdc, ASampleThatComesTooEarlyIsMissedAndDisturbsNothing) {
  Bench b;
  b.tick(true);
  b.tick();
  EXPECT_EQ(b.missed, 1) << "not awake yet";
  b.wake();
  b.tick(true);
  int valid = 0;
  for (int clock = 1; clock < 200; ++clock) valid += b.tick(clock % 50 == 0).codes.valid;
  for (int clock = 0; clock < 100; ++clock) valid += b.tick().codes.valid;
  EXPECT_EQ(b.missed, 4);
  EXPECT_EQ(valid, 1);
  EXPECT_EQ(b.adc.violations + b.errors, 0);
}

TEST(SpiAdc, OffMovesNoPinAndOnWakesTheConverter) {
  Bench b;
  b.in.config.half = 0;
  for (int clock = 0; clock < 1000; ++clock) {
    b.tick();
    ASSERT_TRUE(b.out.cs_n && b.out.sclk && !b.out.ready);
  }
  b.in.config.half = 2;
  b.wake();
  EXPECT_NE(b.sampled(), 0);
}

// The test's own eyes: a line that is written at the wrong edge is a violation.
TEST(SpiAdc, TheConverterModelNoticesAWrongPhase) {
  Bench b;
  for (int clock = 0; clock < 400; ++clock) {
    auto pins = b.dut.tick(b.in);
    pins.sclk = !pins.sclk;
    b.adc.clock({pins.cs_n, pins.sclk, pins.mosi});
  }
  EXPECT_GT(b.adc.violations, 10);
}

TEST(SpiAdc, TheDriveGetsASampleInEveryPeriod) {
  Bench b;
  SinusoidalTop drive;
  SinusoidalTop::In in;
  in.config.bridge.period = 1000;
  in.config.bridge.reciprocal = 11185;  // 2^25 / (3 * 1000)
  int strobes = 0, done = 0;
  bool sample = false;
  for (int clock = 0; clock < 50'000; ++clock) {
    in.codes = b.tick(sample).codes;
    const auto out = drive.tick(in);
    sample = out.sample;
    strobes += sample;
    done += out.done;
  }
  EXPECT_EQ(strobes, 50);
  EXPECT_EQ(b.missed, 1) << "the ADC wakes";
  EXPECT_EQ(done, strobes - b.missed);
}

}  // namespace
}  // namespace steplock
