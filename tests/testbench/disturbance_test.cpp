// Each kind of disturbance on a running drive, in closed loop; and a drive without its protection, of
// which each loss must be seen.
#include "testbench/sweep/disturbance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "testbench/sweep_page/disturbance_statistics.hpp"
#include "testbench/sweep_page/statistics.hpp"
#include "testbench/sweep/drawn_run.hpp"
#include "testbench/sweep/sweep.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

constexpr RunSeed kSeed{8 * 12345 + 2};

design::Settings calm_drive() {
  design::Settings s = short_drive();
  s.envelope.load = {0};
  s.envelope.fan = 0.1;
  s.envelope.inertia = {0.9, 1.1};
  return s;
}

// The same motor at the same speed, and this disturbance.
DrawnRun run_of(const design::Settings& s, Trouble kind, double size, double duration_s = 0) {
  DrawnRun run = drawn_run(s, kSeed);
  run.disturbance = {.kind = kind, .size = size, .duration_s = duration_s, .set_speed = 0.8, .wait_turns = 1.3,
                     .place = 0.6, .phase = 1};
  if (kind == Trouble::kDemagnetisation) {
    const double factor = inductance_for(s, run.disturbance) / run.conditions.inductance;
    run.settings.motor.inductance_h *= factor;
  }
  return run;
}

AfterFindings after(const design::Settings& s, Trouble kind, double size, double duration_s = 0) {
  const DrawnResult result = simulate(run_of(s, kind, size, duration_s));
  EXPECT_EQ(result.findings.outcome, Outcome::kStarted);
  return result.after;
}

// It takes 8 % of the light rotor's speed per commutation step.
TEST(Disturbance, ALoadStepOfMoreThanHalfTheRatedTorqueIsRecoveredFrom) {
  const AfterFindings f = after(calm_drive(), Trouble::kLoadStep, 0.6);
  EXPECT_EQ(f.outcome, After::kRecovered);
  EXPECT_EQ(f.slips, 0u);
  EXPECT_GT(f.dip, 0.03);  // the load did arrive
  EXPECT_GT(*f.recovery_s, 0.005);
}

TEST(Disturbance, ALoadThatComesAndGoesIsRecoveredFrom) {
  EXPECT_EQ(after(calm_drive(), Trouble::kLoadPulse, 0.6, 0.03).outcome, After::kRecovered);
}

TEST(Disturbance, ASetSpeedStepArrives) {
  const AfterFindings f = after(calm_drive(), Trouble::kSetSpeed, 1);
  EXPECT_EQ(f.outcome, After::kRecovered);
  EXPECT_GT(f.dip, 0.15);  // it began at 0.8 of it
}

// 0.6 of the bus drives a rotor without load to 0.6 of the speed, in a few of its time constants; the duty can rise by its slew meanwhile.
TEST(Disturbance, ABusDipIsRecoveredFrom) {
  const design::Settings settings = calm_drive();
  const AfterFindings f = after(settings, Trouble::kBusDip, 0.4, 0.05);
  EXPECT_EQ(f.outcome, After::kRecovered);
  const design::Design d = design::design_drive(settings);
  const double rpm = 0.8 * settings.scenario.speed_rpm, turn = 60 / (rpm * settings.motor.pole_pairs);
  const double follows = 4 * 1.1 * d.motor.tau_m;  // of the heaviest rotor
  const double duty = rpm / (d.motor.no_load * 30 / std::numbers::pi);
  const double rise = d.parameters.speed.duty_slew * (follows + turn) / duty;  // of the speed that the duty gives, over a turn
  EXPECT_GT(f.dip, 1 - 0.6 * (1 + rise) - 0.4 * std::exp(-4));
  EXPECT_LT(f.dip, 0.4);
}

TEST(Disturbance, AComparatorStuckForSomeStepsIsRecoveredFrom) {
  EXPECT_EQ(after(calm_drive(), Trouble::kStuckSteps, 12).outcome, After::kRecovered);
}

TEST(Disturbance, AMissingAndAnExtraCrossingCostNoLock) {
  for (const double level : {0, 1}) {
    const AfterFindings f = after(calm_drive(), Trouble::kMissingCrossing, level);
    EXPECT_EQ(f.outcome, After::kRecovered);
    EXPECT_EQ(f.lost_locks, 0);
  }
  const AfterFindings f = after(calm_drive(), Trouble::kExtraCrossing, 0.2);
  EXPECT_EQ(f.outcome, After::kRecovered);
  EXPECT_EQ(f.lost_locks, 0);
}

TEST(Disturbance, ALongDemagnetisationIsHeldAndMeasured) {
  const AfterFindings f = after(calm_drive(), Trouble::kDemagnetisation, 25);
  EXPECT_EQ(f.outcome, After::kRecovered);
  EXPECT_GT(f.demagnetisation_deg, 20);
  EXPECT_LT(f.demagnetisation_deg, 45);
}

TEST(Disturbance, AComparatorStuckForGoodEndsInTheLatchedFault) {
  for (const double level : {0, 1}) {
    const AfterFindings f = after(calm_drive(), Trouble::kStuckForGood, level);
    EXPECT_EQ(f.outcome, After::kLatched) << level;
    ASSERT_TRUE(f.lost_s && f.fault_s);
    EXPECT_LT(*f.lost_s, 0.5);
  }
}

TEST(Disturbance, AnOpenPhaseEndsInTheLatchedFault) {
  const AfterFindings f = after(calm_drive(), Trouble::kOpenPhase, 1);
  EXPECT_EQ(f.outcome, After::kLatched);
  ASSERT_TRUE(f.lost_s && f.fault_s);
  EXPECT_LT(*f.lost_s, 0.5);
}

design::Settings blind_drive() {
  design::Settings s = calm_drive();
  s.protection.misses = 63;
  s.protection.wrong_lock_s = 0;
  s.protection.slip_duty = 2;
  s.protection.stall_rpm = 0;
  return s;
}

// The negative control: what a drive without protection does not tell, the rotor's true angle does.
TEST(Disturbance, ABlindDriveLosesItsRotorSilentlyAndIsCounted) {
  DrawnRun run = run_of(blind_drive(), Trouble::kLoadStep, 5);
  run.config.protection.misses = 0;
  const AfterFindings f = simulate(run).after;
  EXPECT_EQ(f.outcome, After::kSilentStepOut);
  EXPECT_GT(f.slips, 0u);
  EXPECT_FALSE(ends_well(Trouble::kLoadStep, f.outcome));
  // With its protection the same load latches.
  EXPECT_EQ(after(calm_drive(), Trouble::kLoadStep, 5).outcome, After::kLatched);
}

TEST(Disturbance, ABlindDriveOnAnOpenPhaseEndsBadly) {
  DrawnRun run = run_of(blind_drive(), Trouble::kOpenPhase, 1);
  run.config.protection.misses = 0;
  run.limit_s = 2;
  EXPECT_FALSE(ends_well(Trouble::kOpenPhase, simulate(run).after.outcome));
}

// Pins, plant and words change under an engine that skips quiet clocks, and under the RTL, which does
// not: every output on every clock, and the same findings.
TEST(Disturbance, IsSeenByTheRtlOnTheSameClocks) {
  for (const Trouble kind : {Trouble::kExtraCrossing, Trouble::kMissingCrossing, Trouble::kSetSpeed,
                             Trouble::kInertia, Trouble::kStuckSteps, Trouble::kBusDip}) {
    const DrawnRun run = run_of(calm_drive(), kind, kind == Trouble::kStuckSteps ? 9 : kind == Trouble::kInertia ? 3 : 0.7,
                                kind == Trouble::kBusDip ? 0.01 : 0);
    const AfterFindings alone = simulate(run).after;
    const DrawnResult beside = simulate(run, {.rtl_beside = true});
    EXPECT_TRUE(beside.rtl_agrees) << name_of(kind) << ": " << beside.rtl_difference;
    EXPECT_EQ(alone.outcome, beside.after.outcome) << name_of(kind);
    EXPECT_EQ(alone.end_s, beside.after.end_s) << name_of(kind);
    EXPECT_EQ(alone.peak_current_a, beside.after.peak_current_a) << name_of(kind);
    EXPECT_EQ(alone.recovery_s, beside.after.recovery_s) << name_of(kind);
  }
}

// It turns at the new set speed, and four times as slowly takes up a load.
TEST(Disturbance, FourTimesTheInertiaInOneStepIsRecoveredFrom) {
  DrawnRun run = run_of(calm_drive(), Trouble::kInertia, 4);
  const AfterFindings f = simulate(run).after;
  EXPECT_EQ(f.outcome, After::kRecovered);
  EXPECT_EQ(f.slips, 0u);
  const double alone = *f.recovery_s;
  run.disturbance.size = 1;
  EXPECT_LT(*simulate(run).after.recovery_s, alone);  // without the mass
}

TEST(Disturbance, EveryKindIsDrawnWithinWhatTheFileAllows) {
  const design::Settings s = short_drive();
  const design::DisturbanceSection& most = s.disturbance;
  std::set<Trouble> kinds;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const RunSeed seed = run_seed({.matrix = Matrix::kDisturb}, k);
    ASSERT_TRUE(seed.disturbed());
    const Disturbance d = draw_disturbance(s, draw_conditions(s, seed), seed);
    kinds.insert(d.kind);
    EXPECT_GE(d.set_speed, most.set_speed[0]);
    EXPECT_LE(d.set_speed, most.set_speed[1]);
    EXPECT_GE(d.size, 0);
    EXPECT_LE(d.size, d.kind == Trouble::kLoadStep || d.kind == Trouble::kLoadPulse ? most.load_step
                      : d.kind == Trouble::kBusDip                                    ? most.bus_dip
                      : d.kind == Trouble::kStuckSteps                                ? most.stuck_steps
                      : d.kind == Trouble::kDemagnetisation ? most.demagnetisation_deg
                      : d.kind == Trouble::kInertia         ? most.inertia_step
                                                            : 2);
  }
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(kTroubles));
}

TEST(Disturbance, ARunOfTheMatrixIsTheSameRowAgainAndItsLossFailsTheSweep) {
  const design::Settings s = calm_drive();
  const auto a = make_row(0, "short", s, kSeed), b = make_row(0, "short", s, kSeed);
  EXPECT_EQ(csv_line(*a), csv_line(*b));
  Row lost = *a;
  lost.after.outcome = After::kSilentStepOut;
  const SweepSetup setup{.kind = {.matrix = Matrix::kDisturb}, .runs = 1, .drives = {{"short", "x"}}};
  EXPECT_TRUE(passed(setup, {*a}));
  EXPECT_FALSE(passed(setup, {lost}));
  EXPECT_EQ(disturbance_json(setup, {lost}, false)["silent_step_outs"], 1);
  EXPECT_NE(disturbance_page(setup, {lost}, false).find(std::to_string(kSeed.value)), std::string::npos);
}

TEST(Disturbance, ARunThatDiffersOnTheRtlIsNamedWithItsPortAndClock) {
  const design::Settings s = calm_drive();
  Row differs = *make_row(0, "short", s, kSeed);
  const SweepSetup setup{.kind = {.matrix = Matrix::kDisturb}, .runs = 1, .drives = {{"short", "x"}}};
  differs.rtl = "equal";
  EXPECT_TRUE(passed(setup, {differs}));
  EXPECT_EQ(disturbance_page(setup, {differs}, true).find("differs on the RTL"), std::string::npos);
  differs.rtl = "gates_uh_o at clock 7";
  EXPECT_FALSE(passed(setup, {differs}));
  const std::string said = std::to_string(kSeed.value) + " first differs on the RTL in gates_uh_o at clock 7";
  EXPECT_NE(disturbance_page(setup, {differs}, false).find(said), std::string::npos);
  EXPECT_NE(disturbance_text(setup, {differs}, false).find(std::to_string(kSeed.value) + ": gates_uh_o at clock 7"), std::string::npos);
}

}  // namespace
}  // namespace steplock
