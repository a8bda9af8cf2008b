#include "hls/six_step/vco_counter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace steplock {
namespace {

constexpr Frequency turns_per_clock(double f) { return Frequency(std::uint64_t(f * 4294967296.0)); }

TEST(VcoCounter, AHundredthOfATurnPerClockMakesOnePulseInAHundredClocks) {
  VcoCounter dut;
  int pulses = 0;
  // One clock more for the output register, one for the fraction that truncation took.
  for (int i = 0; i < 102; ++i) {
    pulses += dut.tick({.enable = true, .frequency = turns_per_clock(0.01)}).pulse;
  }
  EXPECT_EQ(pulses, 1);
}

TEST(VcoCounter, ThePulseMarksTheFirstClockOfTheNewTurn) {
  VcoCounter dut;
  const VcoCounter::In quick = {.enable = true, .frequency = turns_per_clock(1.0 / 65536)};
  dut.tick({.load = true, .half = true});
  for (int i = 0x8000; i < 0xFFFF; ++i) ASSERT_FALSE(dut.tick(quick).pulse);
  EXPECT_EQ(dut.tick(quick).phase, Phase(0xFFFF));
  const auto wrapped = dut.tick(quick);
  EXPECT_EQ(wrapped.phase, Phase(0));
  EXPECT_TRUE(wrapped.pulse);
  EXPECT_FALSE(dut.tick(quick).pulse);
}

TEST(VcoCounter, HoldsItsPhaseWhenNotEnabled) {
  VcoCounter dut;
  dut.tick({.load = true, .half = true});
  dut.tick({.frequency = Frequency::max()});
  const auto out = dut.tick({});
  EXPECT_EQ(out.phase, Phase(0x8000));
  EXPECT_FALSE(out.pulse);
}

TEST(VcoCounter, LoadWinsOverEnableAndMakesNoPulse) {
  for (const bool half : {false, true}) {
    VcoCounter dut;
    for (int i = 0; i < 64; ++i) dut.tick({.enable = true, .frequency = Frequency::max()});  // one more ends the turn
    VcoCounter not_loaded = dut;
    not_loaded.tick({.enable = true, .frequency = Frequency::max()});
    EXPECT_TRUE(not_loaded.tick({}).pulse);
    dut.tick({.enable = true, .load = true, .half = half, .frequency = Frequency::max()});
    const auto out = dut.tick({});
    EXPECT_EQ(out.phase, half ? Phase(0x8000) : Phase(0));
    EXPECT_FALSE(out.pulse);
  }
}

TEST(VcoCounter, ATurnFromItsMiddleIsHalfAsLong) {
  for (const bool half : {false, true}) {
    VcoCounter dut;
    dut.tick({.load = true, .half = half});
    int clocks = 0;
    while (!dut.tick({.enable = true, .frequency = turns_per_clock(1.0 / 128)}).pulse) ++clocks;
    EXPECT_EQ(clocks, half ? 64 : 128);
  }
}

// Pulses counted and phase reached add up to the distance travelled, to the last of 32 bits, by
// whatever the frequency did on the way: the oscillator cannot drift however long it runs.
RC_GTEST_PROP(VcoCounter, NeverDrifts, ()) {
  const auto frequencies = *rc::gen::container<std::vector<std::uint32_t>>(
      100, rc::gen::inRange<std::uint32_t>(0, 1u << 26));
  VcoCounter dut;
  std::uint64_t travelled = 0;
  std::uint64_t pulses = 0;
  for (const auto f : frequencies) {
    for (int i = 0; i < 50; ++i) {
      travelled += f;
      pulses += dut.tick({.enable = true, .frequency = f}).pulse;
    }
  }
  const auto out = dut.tick({});
  pulses += out.pulse;
  RC_ASSERT(pulses == travelled >> 32);
  RC_ASSERT(std::uint64_t(out.phase.raw()) == (travelled >> 16) % 65536);
}

}  // namespace
}  // namespace steplock
