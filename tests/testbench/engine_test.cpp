// The engines' interface: packing of the watched word, words, and the skipping of quiet clocks.
#include <gtest/gtest.h>

#include "model/design/design.hpp"
#include "model/design/words.hpp"
#include "testbench/engine/fixed.hpp"
#include "testbench/engine/words.hpp"
#include "testbench/run/drive_loop.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

TEST(Watch, EverySignalHasItsPlace) {
  SixStepTop::Out out;
  out.gates.vl = true;
  out.step = 5;
  out.state = State::kFault;
  out.reason = Reason::kHallCode;
  out.missed = true;
  const Watch w = watch_of(out);
  EXPECT_EQ(w.gates(), (plant::Gates{.vl = true}));
  EXPECT_EQ(w.step(), 5);
  EXPECT_EQ(w.state(), State::kFault);
  EXPECT_EQ(w.reason(), Reason::kHallCode);
  EXPECT_TRUE(w.missed());
  EXPECT_FALSE(w.crossing());
  EXPECT_FALSE(w.locked());
  EXPECT_STREQ(name_of(w.state()), "fault");
  EXPECT_STREQ(name_of(w.reason()), "hall_code");
}

TEST(HlsWords, EveryGroupArrives) {
  const design::Settings s = short_drive();
  const design::Words d = design::quantise(design::design_drive(s).parameters, 12e6).words;
  const Words w = hls_words(d);
  EXPECT_EQ(w.pwm.period.raw(), 400);  // 12 MHz over 30 kHz
  EXPECT_EQ(w.pwm.complementary, true);
  EXPECT_EQ(w.loop.kp.raw(), d.loop.kp);
  EXPECT_EQ(w.start.hand_over.raw(), d.start.hand_over);
  EXPECT_EQ(w.speed.target.raw(), d.speed.target);
  EXPECT_EQ(w.protection.stall.raw(), d.protection.stall);
  EXPECT_EQ(w.bemf.samples.raw(), d.bemf.samples);
  EXPECT_EQ(w.limit.off_time.raw(), d.limit.off_time);
}

// Ticks on every clock, and remembers all outputs of the last one.
class TickingEngine : public FixedEngine {
 public:
  using FixedEngine::FixedEngine;
  std::uint64_t run(std::uint64_t) { return tick(), 1; }
};

// Skipping must be invisible to the last bit: same motor angle, same current, same outputs.
TEST(FixedEngine, SkippingQuietClocksEndsInTheSamePlaceAsTicking) {
  design::Settings s = short_drive();
  const Words words = hls_words(design::quantise(design::design_drive(s).parameters, 12e6).words);
  FixedEngine skipping(words, s.control.clock_hz);
  TickingEngine ticking(words, s.control.clock_hz);
  const Record a = run_with(skipping, s, {.engine = EngineKind::kFixed, .angle_deg = 75});
  const Record b = run_with(ticking, s, {.engine = EngineKind::kFixed, .angle_deg = 75});
  EXPECT_EQ(skipping.output(), ticking.output());
  ASSERT_EQ(a.overview.size(), b.overview.size());
  for (std::size_t i = 0; i < a.overview.size(); ++i) {
    ASSERT_EQ(a.overview[i].plant.angle, b.overview[i].plant.angle) << "sample " << i;
    ASSERT_EQ(a.overview[i].plant.current, b.overview[i].plant.current) << "sample " << i;
    ASSERT_EQ(a.overview[i].drive.step_phase_deg, b.overview[i].drive.step_phase_deg);
  }
  EXPECT_EQ(a.peak_current, b.peak_current);
}

}  // namespace
}  // namespace steplock
