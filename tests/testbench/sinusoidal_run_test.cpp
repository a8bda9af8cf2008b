// The sinusoidal reference drive and its motors in closed loop.
#include "testbench/drive/sinusoidal/run.hpp"

#include <gtest/gtest.h>

#include "testbench/run/check.hpp"

namespace steplock::sinusoidal {
namespace {

design::Settings drive(const std::string& name) {
  return open_drive_file(STEPLOCK_DRIVES "/" + name + ".toml").settings;
}

std::string all(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "; ";
  return text;
}

Result result_of(const design::Settings& s, double angle_deg) {
  const RunOptions options{.engine = EngineKind::kFloat, .angle_deg = angle_deg};
  return summarise(s, options, run(s, options));
}

// Starts at standstill, load cycle, stop; energy within the integration's tolerance.
TEST(SinusoidalRun, EveryDriveRunsItsScenarioWithEitherEstimator) {
  for (const char* name : {"matsui1996", "ipm_2k2", "m2310p_sinusoidal", "br2804_sinusoidal"}) {
    for (const design::Estimator e : {design::Estimator::kVoltage, design::Estimator::kCurrent}) {
      design::Settings s = drive(name);
      s.sinusoidal.estimator = e;
      const Result r = result_of(s, 130);
      EXPECT_TRUE(r.failures().empty()) << name << ' ' << r.estimator << ": " << all(r.failures());
      EXPECT_LT(std::abs(r.energy_residual), 1e-5);
      EXPECT_LT(r.delta_theta_rms_deg, 3) << name;
      EXPECT_TRUE(r.reasons.empty()) << name << all(r.reasons);
    }
  }
}

// Up to the closed loop, from all round: within 3 degrees, polarity right.
TEST(SinusoidalRun, PilotPulsesFindTheRotorFrom64AnglesWithin3Degrees) {
  design::Settings s = drive("ipm_2k2");
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset(), s.scenario.stop_s.reset();
  s.scenario.duration_s = 0.06;
  double worst = 0, moved = 0;
  for (int n = 0; n < 64; ++n) {
    const double angle = n * 360.0 / 64;
    const Record record = run(s, {.engine = EngineKind::kFloat, .angle_deg = angle});
    const Result r = summarise(s, {.engine = EngineKind::kFloat, .angle_deg = angle}, record);
    ASSERT_TRUE(r.position_error_deg) << angle << all(r.reasons);
    worst = std::max(worst, std::abs(*r.position_error_deg));
    for (const StateChange& c : record.changes) {
      if (c.state != State::kStarting) continue;
      const double from = angle * std::numbers::pi / 180 / 3;
      moved = std::max(moved, std::abs(c.mechanical_rad - from));
    }
  }
  EXPECT_LT(worst, 3);
  EXPECT_LT(degrees(moved) * 3, 2);  // electrical degrees that the pulses turned the rotor
}

TEST(SinusoidalRun, ARoundRotorIsReportedAsAmbiguousNotGuessed) {
  const design::Settings believed = drive("ipm_2k2");
  design::Settings real = believed;
  real.motor.inductance_d_h = real.motor.inductance_q_h = 43.5e-3;
  real.motor.saturation = 0;
  Bench bench(believed, real, timeline(believed), 40);
  bench.run_until(0.2);
  const Record record = bench.take();
  bool reported = false;
  for (const StateChange& c : record.changes) {
    EXPECT_NE(c.state, State::kStarting);
    reported |= c.reason == Reason::kNoSaliency;
  }
  EXPECT_TRUE(reported);
}

TEST(SinusoidalRun, FromOppositeItTurnsBackwardFirstAndThenConverges) {
  design::Settings s = drive("matsui1996");
  s.sinusoidal_start.by = design::StartBy::kArbitrary;
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset(), s.scenario.stop_s.reset();
  // The assumed axis stands at winding u; theta_e = 180 has the N pole there, 0 is opposite.
  const Result right = result_of(s, 180), opposite = result_of(s, 0);
  EXPECT_TRUE(right.failures().empty()) << all(right.failures());
  EXPECT_TRUE(opposite.failures().empty()) << all(opposite.failures());
  EXPECT_LT(right.backward_deg, 5);
  EXPECT_GT(opposite.backward_deg, 20);
}

TEST(SinusoidalRun, ItReversesOnCommand) {
  design::Settings s = drive("matsui1996");
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset(), s.scenario.stop_s.reset();
  s.scenario.reverse_s = 0.8;
  s.scenario.duration_s = 2.5;
  const Record record = run(s, {.engine = EngineKind::kFloat});
  EXPECT_NEAR(rpm(record.overview.back().plant.speed), -1200, 12);
  EXPECT_TRUE(record.overview.back().watch.locked());
}

TEST(SinusoidalRun, ASetSpeedOfZeroStopsItAndAnotherOneStartsItAgain) {
  design::Settings s = drive("matsui1996");
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset(), s.scenario.stop_s.reset();
  Bench bench(s, s, timeline(s), 0);
  bench.run_until(1.0);
  EXPECT_EQ(bench.engine().watch().state(), State::kRun);
  bench.engine().set_target_rpm(0);
  bench.run_until(2.0);
  EXPECT_EQ(bench.engine().watch().state(), State::kIdle);
  EXPECT_NEAR(rpm(bench.plant().state().speed), 0, 12);
  bench.engine().set_target_rpm(s.scenario.speed_rpm);
  bench.run_until(3.0);
  EXPECT_EQ(bench.engine().watch().state(), State::kRun);
  for (const StateChange& c : bench.take().changes) EXPECT_NE(c.state, State::kRetryDelay);
}

// The reason of the first try that failed.
template <class Spoil>
Reason spoiled(Spoil&& spoil, design::Settings s = drive("matsui1996")) {
  s.sinusoidal_start.retries = 0;
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset();
  Bench bench(s, s, timeline(s), 0);
  bench.run_until(1.0);
  EXPECT_TRUE(bench.engine().watch().locked());
  spoil(bench);
  bench.run_until(2.0);
  for (const StateChange& c : bench.take().changes) {
    if (c.state == State::kFault) return c.reason;
  }
  return Reason::kNone;
}

TEST(SinusoidalRun, FaultsHaveTheirReasons) {
  EXPECT_EQ(spoiled([](Bench& b) { b.engine().lose_samples(true); }), Reason::kLostSample);
  EXPECT_EQ(spoiled([](Bench& b) { b.plant().set_bus_voltage(70); }), Reason::kSaturated);
  HostCommand command{.run = true, .fault_pin = true};
  EXPECT_EQ(spoiled([&](Bench& b) { b.engine().set_command(command); }), Reason::kFaultPin);
  EXPECT_EQ(spoiled([](Bench&) {}), Reason::kNone);
}

TEST(SinusoidalRun, ABlockedRotorIsNeverClaimedToTurn) {
  design::Settings s = drive("matsui1996");
  design::Settings real = s;
  real.motor.static_nm = 1000;
  real.motor.coulomb_nm = 1000;
  Bench bench(s, real, timeline(s), 0);
  bench.run_until(1.2);
  EXPECT_NE(bench.engine().watch().state(), State::kRun);
  for (const Sample& x : bench.take().overview) EXPECT_FALSE(x.watch.locked()) << x.time;
}

TEST(SinusoidalRun, TheSameRunGivesTheSameSamples) {
  design::Settings s = drive("matsui1996");
  s.scenario.duration_s = 0.5;
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset(), s.scenario.stop_s.reset();
  const RunOptions options{.engine = EngineKind::kFloat, .angle_deg = 12};
  EXPECT_EQ(samples_csv(run(s, options).overview), samples_csv(run(s, options).overview));
}

TEST(SinusoidalRun, OneKindsSectionsAndCommandsRefuseTheOther) {
  const auto refusal = [](auto&& attempt) -> std::string {
    try {
      attempt();
    } catch (const BadInput& e) {
      return e.what();
    }
    return "accepted";
  };
  const std::string matsui = STEPLOCK_DRIVES "/matsui1996.toml", servo = STEPLOCK_DRIVES "/m2310p_servo.toml";
  const std::string one = refusal([&] { open_six_step_files({matsui}, "a sweep"); });
  EXPECT_NE(one.find("matsui1996.toml:6: drive.kind is \"sinusoidal\"; a sweep serves \"six_step\""),
            std::string::npos) << one;
  EXPECT_EQ(open_six_step_files({matsui, servo}, "a sweep").size(), 1u);
  const std::string text = "[drive]\nname = \"x\"\nsource = \"y\"\nkind = \"sinusoidal\"\n[loop]\n";
  EXPECT_NE(refusal([&] { parse_drive_file(text, "x.toml"); }).find(
                "x.toml:5: [loop] is not for drive.kind = \"sinusoidal\""),
            std::string::npos);
}

}  // namespace
}  // namespace steplock::sinusoidal
