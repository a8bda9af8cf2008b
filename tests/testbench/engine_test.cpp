// The engines' interface: packing of the watched word, words, and the skipping of quiet clocks, alone and
// beside the RTL.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "hls/bus/word_rows.hpp"
#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/lockstep_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/drive/six_step/run.hpp"
#include "testbench/engine/word_name.hpp"
#include "tests/hls/six_step_chaos.hpp"
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

// All but the scale of gains per second, which a loop of gains per step does not have.
TEST(HlsConfig, EachIsTheOneOfItsName) {
  const design::Settings s = short_drive();
  const design::Config d = design::quantise(design::design_drive(s).parameters, 12e6).config;
  const SixStepConfig w = hls_config(d);
  EXPECT_EQ(w.pwm.period.raw(), 400);  // 12 MHz over 30 kHz
  EXPECT_EQ(w.pwm.complementary, true);
  EXPECT_EQ(w.source, Source::kBemf);
  std::size_t checked = 0;
  const auto check = [&](const auto& row) {
    using Place = typename std::remove_cvref_t<decltype(row)>::Word;
    const std::string name = word_name<Place>('.');
    if (name == "loop.scale") return;
    EXPECT_EQ(bits_of(Place::of(w)).raw(), d[name]) << name;
    ++checked;
  };
  std::apply([&](const auto&... row) { (check(row), ...); }, kWordRows);
  EXPECT_EQ(checked, d.all().size());
  EXPECT_EQ(checked, 59u);
}

TEST(HlsConfig, OneThatTheDriveDoesNotHaveOrThatDoesNotFitIsRefused) {
  const auto refusal = [](const char* name, design::Word word) -> std::string {
    design::Config d;
    d.set(name, word);
    try {
      hls_config(d);
    } catch (const std::logic_error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("loop.divide", 3), "");
  EXPECT_EQ(refusal("loop.divide", 4), "loop.divide has fewer bits than the design library gives it");
  EXPECT_EQ(refusal("loop.divider", 3), "the drive has no word loop.divider, which the design library names");
  EXPECT_THROW(design::Config{}["loop.divide"], std::out_of_range);
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
  const SixStepConfig config = hls_config(design::quantise(design::design_drive(s).parameters, 12e6).config);
  FixedEngine skipping(config, s.control.clock_hz);
  TickingEngine ticking(config, s.control.clock_hz);
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

// A lockstep engine and what it sees for 400,000 clocks: a host that starts it, and pins that flicker.
struct Chase {
  struct Run { std::uint64_t begin, clocks; };
  LockstepEngine engine;
  std::vector<Run> runs = {};

  static SixStepConfig config() {
    SixStepConfig w = quick_config();
    w.pwm.period = 4000;
    return w;
  }
  Chase() : engine(config(), 12e6) {}

  // Not more than `most` clocks at once.
  Lockstep chase(std::uint64_t most) {
    std::mt19937 random{1};
    engine.set_command({.run = true});
    for (std::uint64_t clock = 0; clock < 400'000;) {
      engine.set_pins({.comparator = {random() % 2 == 0, random() % 2 == 0, random() % 2 == 0}});
      for (const std::uint64_t end = clock + 1 + random() % 3000; clock < end;) {
        const std::uint64_t taken = engine.run(std::min(most, end - clock));
        runs.push_back({clock, taken});
        clock += taken;
      }
    }
    return engine.found();
  }
  static constexpr std::uint64_t kAny = 1 << 20;
};

std::vector<Chase::Run> long_runs() {
  Chase chase;
  EXPECT_TRUE(chase.chase(Chase::kAny).equal());
  EXPECT_LT(chase.runs.size(), chase.engine.found().clocks / 4);
  std::erase_if(chase.runs, [](const Chase::Run& r) { return r.clocks < 40; });
  return chase.runs;
}

// Skipping by the blocks must be invisible in what is found: the same clocks differ, and the same is first.
TEST(LockstepEngine, FindsWhatTickingFindsFromTheMidstOfQuietClocksToTheMidstOfOthers) {
  const std::vector<Chase::Run> runs = long_runs();
  ASSERT_GT(runs.size(), 400u);
  std::uint64_t inside = 0;
  for (std::size_t i = 1; i < 8; ++i) {
    const Chase::Run& first = runs[i * runs.size() / 8];
    const Chase::Run& last = runs[i * runs.size() / 8 + 3 * (i % 3)];
    const std::uint64_t from = first.begin + first.clocks / 3, to = last.begin + last.clocks * 2 / 3;
    Chase skipping, ticking;
    for (Chase* chase : {&skipping, &ticking}) chase->engine.invert_comparators(from, to);
    const Lockstep found = skipping.chase(Chase::kAny), expected = ticking.chase(1);
    EXPECT_EQ(found.clocks, expected.clocks);
    EXPECT_EQ(found.differing_clocks, expected.differing_clocks) << "from " << from << " to " << to;
    EXPECT_EQ(found.first_clock, expected.first_clock) << "from " << from << " to " << to;
    EXPECT_EQ(found.first_port, expected.first_port);
    if (found.equal()) continue;
    EXPECT_GE(found.first_clock, from);
    inside += std::ranges::any_of(skipping.runs, [&](const Chase::Run& r) {
      return r.begin < found.first_clock && found.first_clock < r.begin + r.clocks;
    });
  }
  EXPECT_GT(inside, 0u);  // a clock that the blocks skipped
}

TEST(LockstepEngine, ComparesTheStepPhaseInEveryClockOfAQuietStretch) {
  const std::vector<Chase::Run> runs = long_runs();
  const Chase::Run& run = runs[runs.size() / 2];
  for (const std::uint64_t clock : {run.begin, run.begin + 1, run.begin + 2, run.begin + run.clocks / 2,
                                    run.begin + run.clocks - 1}) {
    Chase chase;
    chase.engine.spoil(clock);
    const Lockstep found = chase.chase(Chase::kAny);
    EXPECT_EQ(found.differing_clocks, 1u);
    EXPECT_EQ(found.first_clock, clock);
    EXPECT_EQ(found.first_port, "step_phase_o");
  }
}

}  // namespace
}  // namespace steplock
