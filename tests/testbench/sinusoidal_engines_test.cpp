// The sinusoidal drive's blocks in closed loop with motors: natively, as RTL, and beside the reference in
// doubles.
#include <gtest/gtest.h>

#include "hls/bus/sinusoidal_rows.hpp"
#include "hls/sinusoidal/sinusoidal_top.hpp"
#include "testbench/run/check.hpp"
#include "testbench/drive/sinusoidal/lockstep_engine.hpp"
#include "testbench/drive/sinusoidal/run.hpp"

namespace steplock::sinusoidal {
namespace {

design::Settings drive(const std::string& name) {
  return open_drive_file(STEPLOCK_DRIVES "/" + name + ".toml").settings;
}

Result result_of(const design::Settings& s, EngineKind engine, double angle_deg) {
  const RunOptions options{.engine = engine, .angle_deg = angle_deg};
  return summarise(s, options, run(s, options));
}

std::string all(const Result& r) {
  std::string text = r.drive + ": ";
  for (const std::string& line : r.failures()) text += line + "; ";
  for (const std::string& line : r.reasons) text += "(" + line + ") ";
  return text;
}

// The design library names every word of a drive that is found by pilot pulses; hls_config refuses what it names beside them.
TEST(SinusoidalEngines, EveryWordHasItsNameInTheDesignLibrary) {
  const auto named = design::sinusoidal::quantise(drive("ipm_2k2")).config;
  EXPECT_EQ(named.all().size(), std::tuple_size_v<std::remove_cvref_t<decltype(kSinusoidalWordRows)>>);
  EXPECT_NO_THROW(hls_config(named));
}

// Start, load step, stop.  One place of speed is 0.6 r/min of 3000; the mean of a lock cannot drift.
TEST(SinusoidalEngines, TheFixedDriveRunsItsScenarioFromAllRound) {
  for (const double angle : {0.0, 130.0, 250.0}) {
    const Result r = result_of(drive("m2310p_sinusoidal"), EngineKind::kFixed, angle);
    EXPECT_TRUE(r.failures().empty() && r.reasons.empty()) << angle << ' ' << all(r);
    EXPECT_LT(std::abs(r.speed_error_percent), 0.05);
    EXPECT_LT(r.delta_theta_rms_deg, 2);
  }
}

// 1500 r/min at rated torque needs nearly the whole linear range of the modulator.
TEST(SinusoidalEngines, TheFixedDriveRunsMatsuisMotorUpTo1500AtRatedTorque) {
  design::Settings s = drive("matsui1996");
  for (const double speed : {1200.0, 1500.0}) {
    s.scenario.speed_rpm = speed;
    const Result r = result_of(s, EngineKind::kFixed, 130);
    EXPECT_TRUE(r.failures().empty() && r.reasons.empty()) << speed << ' ' << all(r);
    EXPECT_LT(r.delta_theta_rms_deg, 2);
  }
}

// Both see a rotor of their own; their angles part by noise of the ADCs alone.
TEST(SinusoidalEngines, FixedAndFloatAgreeWithinTheConvertersNoise) {
  const design::Settings s = drive("m2310p_sinusoidal");
  const Result fixed = result_of(s, EngineKind::kFixed, 40);
  const Result exact = result_of(s, EngineKind::kFloat, 40);
  EXPECT_NEAR(fixed.mean_rpm, exact.mean_rpm, 0.5);
  ASSERT_TRUE(fixed.lock_time_s && exact.lock_time_s);
  EXPECT_NEAR(*fixed.lock_time_s, *exact.lock_time_s, 0.005);
  EXPECT_NEAR(fixed.delta_theta_mean_deg, exact.delta_theta_mean_deg, 1);
  EXPECT_NEAR(*fixed.load_dip_percent, *exact.load_dip_percent, 2);
}

// `estimator` chooses at run time; the same start, load and stop.
TEST(SinusoidalEngines, TheFixedDriveRunsWithTheVoltageModelToo) {
  const auto runs = [](const char* name, int samples) {
    design::Settings s = drive(name);
    s.sinusoidal.estimator = design::Estimator::kVoltage;
    s.sinusoidal.moving_average = samples;
    const Result r = result_of(s, EngineKind::kFixed, 130);
    EXPECT_TRUE(r.failures().empty() && r.reasons.empty()) << samples << ' ' << all(r);
    EXPECT_LT(r.delta_theta_rms_deg, 3) << name << ' ' << samples;
  };
  runs("m2310p_sinusoidal", 8);
  runs("m2310p_sinusoidal", 1);
  runs("matsui1996", 8);
}

// Phase currents are within two steps of the ADC, so that dead time's way hangs on the currents that
// are wanted.  By the signs of the measured ones the rotor hunts, or, with no noise, stands while the drive
// claims to run.  What remains of hunting turns the rotor to and fro by some 5 electrical degrees; at both
// ends of 1.7 s, 1500 degrees, that is 1 % of the mean speed.
TEST(SinusoidalEngines, TheFixedDriveTurnsSlowlyWithoutLoad) {
  design::Settings s = drive("matsui1996");
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset(), s.scenario.stop_s.reset();
  s.scenario.speed_rpm = 50;
  s.scenario.duration_s = 4;
  s.sinusoidal_start.lock_rpm = 40;  // the resistance is what the drive believes
  s.sinusoidal_start.lock_s = 0.02;  // hunting, it is not above that for longer
  for (const double noise : {0.0, s.adc.current_noise_a}) {
    s.adc.current_noise_a = noise;
    const Result r = result_of(s, EngineKind::kFixed, 130);
    EXPECT_TRUE(r.locked && r.reasons.empty()) << noise << ' ' << all(r);
    EXPECT_LT(std::abs(r.speed_error_percent), 1) << noise;
    EXPECT_LT(r.delta_theta_rms_deg, 5) << noise;
  }
}

// A rotor that hunts is above the lock's speed for long enough in a row, since no current brakes it before the lock: docs/sinusoidal.md,
// "Low speed without load".
TEST(SinusoidalEngines, AStartNearTheLocksSpeedLocksWithoutLoadAndGammaCurrent) {
  design::Settings s = drive("matsui1996");
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset(), s.scenario.stop_s.reset();
  s.scenario.speed_rpm = 68;
  for (const double angle : {0.0, 130.0, 250.0}) {
    const Result r = result_of(s, EngineKind::kFixed, angle);
    EXPECT_TRUE(r.failures().empty() && r.reasons.empty()) << angle << ' ' << all(r);
    ASSERT_TRUE(r.lock_time_s);
    EXPECT_LT(*r.lock_time_s, 0.45) << angle;
  }
}

// model/ and hls/ do not include each other.
TEST(SinusoidalEngines, WhatTheDesignKnowsOfTheBlocksIsTheirs) {
  EXPECT_EQ(design::sinusoidal::kSampleClocks, 2 + SinusoidalLoop::kClocks);
  constexpr auto floor = []<int kFloor>(const GateGuard<kFloor>*) { return kFloor; };
  EXPECT_EQ(design::sinusoidal::kDeadTimeFloor, floor(static_cast<const GateGuard<>*>(nullptr)));
}

TEST(SinusoidalEngines, TheFixedDriveReversesOnCommand) {
  design::Settings s = drive("m2310p_sinusoidal");
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset(), s.scenario.stop_s.reset();
  s.scenario.reverse_s = 0.5;
  s.scenario.duration_s = 1.5;
  const Record record = run(s, {.engine = EngineKind::kFixed});
  EXPECT_NEAR(rpm(record.overview.back().plant.speed), -3000, 30);
  EXPECT_TRUE(record.overview.back().watch.locked());
}

template <class Spoil>
Reason spoiled(Spoil&& spoil) {
  design::Settings s = drive("m2310p_sinusoidal");
  s.sinusoidal_start.retries = 0;
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset(), s.scenario.stop_s.reset();
  BenchOf<FixedEngine> bench(s, s, timeline(s), 0);
  bench.run_until(0.4);
  EXPECT_TRUE(bench.engine().watch().locked());
  spoil(bench);
  bench.run_until(0.9);
  for (const StateChange& c : bench.take().changes) {
    if (c.state == State::kFault) return c.reason;
  }
  return Reason::kNone;
}

TEST(SinusoidalEngines, FaultsOfTheFixedDriveHaveTheirReasons) {
  using B = BenchOf<FixedEngine>;
  EXPECT_EQ(spoiled([](B& b) { b.engine().lose_samples(true); }), Reason::kLostSample);
  EXPECT_EQ(spoiled([](B& b) { b.plant().set_bus_voltage(8); }), Reason::kSaturated);
  const HostCommand command{.run = true, .fault_pin = true};
  EXPECT_EQ(spoiled([&](B& b) { b.engine().set_command(command); }), Reason::kFaultPin);
  EXPECT_EQ(spoiled([](B&) {}), Reason::kNone);
}

TEST(SinusoidalEngines, ASetSpeedOfZeroStopsTheFixedDriveAndAnotherOneStartsItAgain) {
  design::Settings s = drive("m2310p_sinusoidal");
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset(), s.scenario.stop_s.reset();
  BenchOf<FixedEngine> bench(s, s, timeline(s), 0);
  bench.run_until(0.4);
  EXPECT_EQ(bench.engine().watch().state(), State::kRun);
  bench.engine().set_target_rpm(0);
  bench.run_until(1.0);
  EXPECT_EQ(bench.engine().watch().state(), State::kIdle);
  bench.engine().set_target_rpm(s.scenario.speed_rpm);
  bench.run_until(1.6);
  EXPECT_EQ(bench.engine().watch().state(), State::kRun);
  for (const StateChange& c : bench.take().changes) EXPECT_NE(c.state, State::kRetryDelay);
}

// Offsets, both halves of the pattern, the closed loop to set speed: 4.8 million clocks.
TEST(SinusoidalEngines, TheRtlIsItsSourceInEveryClockOfAStart) {
  const design::Settings s = drive("m2310p_sinusoidal");
  BenchOf<LockstepEngine> bench(s, s, timeline(s), 200);
  bench.run_until(0.2);
  EXPECT_TRUE(bench.engine().found().equal()) << to_text(bench.engine().found());
  EXPECT_EQ(bench.engine().watch().state(), State::kRun);
  EXPECT_GT(rpm(bench.plant().state().speed), 1000);
}

TEST(SinusoidalEngines, TheRtlIsItsSourceWithTheVoltageModelToo) {
  design::Settings s = drive("m2310p_sinusoidal");
  s.sinusoidal.estimator = design::Estimator::kVoltage;
  BenchOf<LockstepEngine> bench(s, s, timeline(s), 200);
  bench.run_until(0.2);
  EXPECT_TRUE(bench.engine().found().equal()) << to_text(bench.engine().found());
  EXPECT_EQ(bench.engine().watch().state(), State::kRun);
}

TEST(SinusoidalEngines, OneWrongBitInOneClockIsNoticed) {
  const design::Settings s = drive("m2310p_sinusoidal");
  BenchOf<LockstepEngine> bench(s, s, timeline(s), 0);
  bench.engine().spoil(30'000);
  bench.run_until(0.002);
  EXPECT_EQ(bench.engine().found().differing_clocks, 1u);
  EXPECT_EQ(bench.engine().found().first_clock, 30'000u);
  EXPECT_EQ(bench.engine().found().first_port, "on_u_o");
}

TEST(SinusoidalEngines, WhatTheBlocksCannotDoIsRefusedWithOneLine) {
  const auto refusal = [](auto&& change) -> std::string {
    design::Settings s = drive("m2310p_sinusoidal");
    change(s);
    const auto q = design::sinusoidal::quantise(s);
    return q.problems.empty() ? "accepted" : q.problems.front();
  };
  using D = design::Settings;
  EXPECT_EQ(refusal([](D&) {}), "accepted");
  EXPECT_EQ(refusal([](D& s) {
              s.sinusoidal.estimator = design::Estimator::kVoltage;
              s.sinusoidal.moving_average = 5;
            }),
            "sinusoidal.moving_average is 5; must be 1 or 8 for this engine");
  EXPECT_EQ(refusal([](D& s) { s.adc.bits = 14; }), "adc.bits is 14; must be 12 for this engine");
  EXPECT_EQ(refusal([](D& s) { s.control.pwm_hz = 1e3; }),
            "bridge.period needs the word 24000; at most 16383");
}

}  // namespace
}  // namespace steplock::sinusoidal
