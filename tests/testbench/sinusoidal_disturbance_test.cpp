// Disturbed runs of sinusoidal drives: how they are judged, which kinds they meet, what becomes of the drive, and sweeps of them.
#include "testbench/disturb/sinusoidal_disturbance.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

#include "testbench/disturb/disturbance_sweep.hpp"
#include "testbench/disturb/sinusoidal_aftermath.hpp"
#include "testbench/report/report.hpp"
#include "testbench/run/check.hpp"
#include "testbench/sweep_page/disturbance_statistics.hpp"
#include "testbench/sweep_page/statistics.hpp"

namespace steplock::sinusoidal {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = std::numbers::pi / 180;

DriveFile servo() { return open_drive_file(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml"); }

// 600 r/min, one pole pair: 100 ms per electrical turn, ten samples in each.  The disturbance comes at 1 s.
class Story {
 public:
  explicit Story(bool good = false) : aftermath_({.run_s = 0, .set_rpm = 600, .pole_pairs = 1}) {
    enter(State::kRun);
    turn(10);
    aftermath_.disturb({.from_s = 1, .until_s = 1, .set_rpm = 600, .for_good = good});
  }
  // So many turns' time: the rotor turns at this part of the set speed, the estimate is so far from it, and the drive believes `believed`.
  void turn(int count, double part = 1, double error_deg = 0, std::optional<double> believed = {}) {
    for (int k = 0; k < 10 * count && !aftermath_.decided(); ++k) {
      state_.time += 0.01;
      state_.electrical_angle += part * 36 * kDegree;
      state_.speed = part * 20 * std::numbers::pi;
      view_.speed_rpm = believed.value_or(part * 600);
      view_.estimating = true;
      strobe();  // taken in,
      view_.angle_deg = north_pole_deg(state_) - error_deg;
      strobe();  // and shown with the next one
      if (state_.time >= aftermath_.next_sample()) aftermath_.sample(state_, was_, view_, 0);
    }
  }
  void enter(State state, Reason reason = Reason::kNone) {
    change(static_cast<std::uint32_t>(state) << Watch::kState | static_cast<std::uint32_t>(reason) << Watch::kReason);
  }
  void current(double amps) { state_.current = {amps, -amps, 0}; }
  void over() { aftermath_.time_is_over(); }
  const AfterFindings& findings() const { return aftermath_.findings(); }
  Reason reason() const { return aftermath_.reason(); }

 private:
  void strobe() {
    change(was_.bits | Watch::kStrobeMask);
    change(was_.bits & ~Watch::kStrobeMask);
  }
  void change(std::uint32_t bits) {
    const Watch now{bits};
    aftermath_.changed(state_, was_, now, view_, 0);
    was_ = now;
  }
  Aftermath aftermath_;
  plant::State state_;
  View view_;
  Watch was_;
};

TEST(SinusoidalAftermath, ADriveThatIsNeverShakenHasRecoveredAtOnce) {
  Story story;
  story.turn(40);
  EXPECT_EQ(story.findings().outcome, After::kRecovered);
  EXPECT_EQ(*story.findings().recovery_s, 0);
  EXPECT_EQ(story.findings().slips, 0u);
  EXPECT_NEAR(story.findings().dip, 0, 1e-9);
}

TEST(SinusoidalAftermath, RecoveryLastsUntilTheLastTurnThatWasSlow) {
  Story story;
  story.turn(2, 0.9);
  story.turn(40);
  EXPECT_EQ(story.findings().outcome, After::kRecovered);
  EXPECT_NEAR(*story.findings().recovery_s, 0.25, 0.051);  // two slow turns, and a look every turn
  EXPECT_NEAR(story.findings().dip, 0.1, 1e-6);
}

TEST(SinusoidalAftermath, AnEstimateOfTheOtherPoleIsASilentStepOutOnceItIsClaimedForHalfASecond) {
  Story story;
  story.turn(4, 1, 180);
  EXPECT_EQ(story.findings().outcome, After::kUnfinished);
  story.turn(4, 1, 180);
  EXPECT_EQ(story.findings().outcome, After::kSilentStepOut);
  EXPECT_EQ(story.findings().slips, 1u);  // one way astray, however many samples it lasts
}

TEST(SinusoidalAftermath, AnErrorOfLessThanAQuarterTurnIsNone) {
  Story story;
  story.turn(40, 1, 80);
  EXPECT_EQ(story.findings().outcome, After::kRecovered);
}

TEST(SinusoidalAftermath, ARotorThatStandsWhileTheDriveBelievesInItIsSilent) {
  Story story;
  story.turn(8, 0, 0, 600);
  EXPECT_EQ(story.findings().outcome, After::kSilentStepOut);
}

TEST(SinusoidalAftermath, AFailedAttemptIsCountedAndAFaultLatches) {
  Story story;
  story.turn(3);
  story.enter(State::kRetryDelay, Reason::kEmf);
  story.turn(3, 0.5);
  story.enter(State::kStarting);
  story.turn(1, 0.5);
  story.enter(State::kFault, Reason::kNoLock);
  const AfterFindings f = story.findings();
  EXPECT_EQ(f.outcome, After::kLatched);
  EXPECT_EQ(f.retries, 2);
  EXPECT_EQ(f.lost_locks, 1);
  EXPECT_EQ(story.reason(), Reason::kNoLock);
  EXPECT_NEAR(*f.lost_s, 0.3, 0.011);
  EXPECT_NEAR(*f.fault_s, 0.7, 0.011);
}

TEST(SinusoidalAftermath, WhatIsForGoodIsJudgedWhenTheTimeIsOver) {
  Story story(true);
  story.turn(60);
  EXPECT_EQ(story.findings().outcome, After::kUnfinished);
  story.over();
  EXPECT_EQ(story.findings().outcome, After::kRecovered);
}

TEST(SinusoidalAftermath, ThePeakIsThatAfterTheDisturbance) {
  Story story;
  story.current(4);
  story.turn(1);
  story.current(3);
  story.turn(1);
  EXPECT_EQ(story.findings().peak_current_a, 4);
}

TEST(SinusoidalDisturbance, EachKindThatItMeetsIsDrawnAndNoOther) {
  const DriveFile file = servo();
  const SweepKind kind{.matrix = Matrix::kDisturb, .seed = 7};
  std::set<Trouble> drawn;
  for (std::uint64_t k = 0; k < 200; ++k) {
    const RunSeed seed = disturbed_seed(file.settings, kind, k);
    EXPECT_TRUE(seed.disturbed());
    EXPECT_EQ(disturbed_seed(file.settings, kind, k).value, seed.value);
    drawn.insert(drawn_run(file.settings, seed).disturbance.kind);
  }
  EXPECT_EQ(drawn, (std::set{Trouble::kLoadStep, Trouble::kLoadPulse, Trouble::kSetSpeed, Trouble::kBusDip, Trouble::kOpenPhase,
                             Trouble::kInertia}));
}

// The same motor at the same speed, and this disturbance.
DrawnRun run_of(Trouble kind, double size, double duration_s = 0) {
  const design::Settings s = servo().settings;
  DrawnRun run = drawn_run(s, disturbed_seed(s, {.matrix = Matrix::kDisturb, .seed = 5}, 0));
  run.disturbance = {.kind = kind, .size = size, .duration_s = duration_s, .set_speed = 0.8, .wait_turns = 1.3, .place = 0.6, .phase = 1};
  return run;
}

AfterFindings after(Trouble kind, double size, double duration_s = 0) {
  const DrawnResult result = simulate_disturbed(run_of(kind, size, duration_s));
  EXPECT_EQ(result.findings.outcome, Outcome::kStarted);
  return result.after;
}

TEST(SinusoidalDisturbance, ALoadThatComesAndGoesIsRecoveredFrom) {
  const AfterFindings f = after(Trouble::kLoadPulse, 0.5, 0.03);
  EXPECT_EQ(f.outcome, After::kRecovered);
  EXPECT_EQ(f.slips, 0u);
  EXPECT_GT(f.dip, 0);  // the load did arrive
}

TEST(SinusoidalDisturbance, ASetSpeedStepArrives) {
  const AfterFindings f = after(Trouble::kSetSpeed, 1);
  EXPECT_EQ(f.outcome, After::kRecovered);
  EXPECT_GT(f.dip, 0.15);  // it began at 0.8 of it
}

// It has no test for an open winding, and may go on with the two others; but it never believes in a rotor that it has lost.
TEST(SinusoidalDisturbance, AnOpenPhaseIsNoSilentStepOut) {
  const AfterFindings f = after(Trouble::kOpenPhase, 1);
  EXPECT_NE(f.outcome, After::kSilentStepOut);
  EXPECT_NE(f.outcome, After::kNotStarted);
}

std::string text_of(const fs::path& path) {
  std::ostringstream all;
  all << std::ifstream(path, std::ios::binary).rdbuf();
  return all.str();
}

TEST(SinusoidalDisturbance, ASweepThatWasStoppedIsTheWholeOneOnceItIsResumed) {
  const std::vector<DriveFile> files{servo()};
  const SweepSetup setup = sweep_setup({.matrix = Matrix::kDisturb, .seed = 3, .rtl = 0}, 4, files);
  const fs::path base = fs::path(testing::TempDir()) / "steplock_sinusoidal_disturbances";
  fs::remove_all(base);
  const SweepEnd whole = sweep_disturbances(setup, files, {.jobs = 2}, base / "whole");
  ASSERT_EQ(whole.rows.size(), 4u);
  const std::string all = text_of(base / "whole/runs.csv");
  // Two whole lines, and a third that the machine did not come to write.
  std::size_t end = 0;
  for (int line = 0; line < 3; ++line) end = all.find('\n', end) + 1;
  fs::create_directories(base / "part");
  write_file(base / "part/runs.csv", all.substr(0, end + 20));
  write_file(base / "part/setup.json", text_of(base / "whole/setup.json"));
  EXPECT_THROW(sweep_disturbances(setup, files, {.jobs = 2}, base / "part"), BadInput);
  const SweepEnd resumed = sweep_disturbances(setup, files, {.jobs = 2, .resume = true}, base / "part");
  EXPECT_EQ(resumed.done, 2u);
  EXPECT_EQ(text_of(base / "part/runs.csv"), all);
  EXPECT_THROW(sweep_disturbances(setup, files, {.shard = {0, 2}}, base / "shard"), BadInput);
  const std::string page = disturbance_page(setup, whole.rows, true);
  EXPECT_NE(page.find("# Disturbances of the sinusoidal drives"), page.npos);
  EXPECT_EQ(page.find("Demagnetisation"), page.npos);
  EXPECT_EQ(page.find("in steps"), page.npos);
}

TEST(SinusoidalDisturbance, ALineIsReadAsItWasWritten) {
  const RunSeed seed = disturbed_seed(servo().settings, {.matrix = Matrix::kDisturb}, 3);
  Row row{.index = 3, .drive = "x", .seed = seed.value, .outside = false, .rtl = "equal",
          .conditions = {}, .findings = {}, .disturbance = {}, .hardship = {}, .after = {}, .kind = design::DriveKind::kSinusoidal};
  row.findings.sinusoidal_reason = Reason::kOverCurrent;
  row.after.outcome = After::kLatched;
  const std::string line = disturbed_line(row);
  EXPECT_EQ(disturbed_line(disturbed_row_of(line, "runs.csv", 2)), line);
  EXPECT_EQ(disturbed_row_of(line, "runs.csv", 2).findings.sinusoidal_reason, Reason::kOverCurrent);
  EXPECT_THROW(disturbed_row_of(line + "x", "runs.csv", 2), BadInput);
}

// The control: one wrong bit of the RTL is told.
TEST(SinusoidalDisturbance, TheRtlBesideTellsOneWrongBit) {
  DrawnRun run = run_of(Trouble::kSetSpeed, 0.9);
  run.limit_s = 0.02;  // no start is over by then
  EXPECT_TRUE(simulate_disturbed(run, {.rtl_beside = true}).rtl_agrees);
  EXPECT_FALSE(simulate_disturbed(run, {.rtl_beside = true, .spoil_clock = 100'000}).rtl_agrees);
}

}  // namespace
}  // namespace steplock::sinusoidal
