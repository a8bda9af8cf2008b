#include "testbench/drive/six_step/summary.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

// A record of a rotor that turns at exactly `rpm` while the drive claims a lock from 0.1 s on.
Record record_at(double rpm) {
  Record r;
  const double speed = rpm * std::numbers::pi / 30;
  for (int i = 0; i <= 9500; ++i) {
    Sample s;
    s.time = i * 1e-4;
    s.plant.speed = speed;
    s.plant.angle = speed * s.time;
    const State state = s.time < 0.1 ? State::kAccelerate : State::kRun;
    s.watch.bits = static_cast<std::uint32_t>(state) << Watch::kState |
                   std::uint32_t{state == State::kRun} << Watch::kLocked;
    s.totals.current_squared = 4 * s.time;  // 2 A rms
    s.plant.energy.supplied = 3 + 100 * s.time;
    s.plant.energy.load = 80 * s.time;
    s.plant.energy.copper = 9 * s.time, s.plant.energy.bridge = 5 * s.time, s.plant.energy.bus_resistance = 1 * s.time;
    s.plant.energy.friction = 3 * s.time, s.plant.energy.kinetic = 7 + 2 * s.time;
    s.totals.commutations = static_cast<std::uint64_t>(i);
    s.totals.commutation_deg = 3.0 * i;     // 3 degrees late, always
    s.totals.commutation_squared = 9.0 * i;
    s.totals.phase_error_squared = 25.0 * i;
    r.overview.push_back(s);
  }
  r.changes = {{0.001, State::kAccelerate, Reason::kNone}, {0.1, State::kRun, Reason::kNone}};
  r.clocks = 11400000;
  r.simulated_s = 0.95;
  r.wall_s = r.cpu_s = 1;
  return r;
}

design::Settings steady_only() {
  design::Settings s = short_drive();
  s.scenario.load_step_s.reset();
  s.scenario.load_off_s.reset();
  s.scenario.reverse_s.reset();
  s.scenario.stop_s.reset();
  return s;
}

TEST(Summary, FiguresFollowFromTheRecord) {
  const Summary s = summarise(steady_only(), {}, record_at(3003));
  EXPECT_TRUE(s.locked);
  EXPECT_DOUBLE_EQ(*s.lock_time_s, 0.1);
  EXPECT_NEAR(s.steady.mean_rpm, 3003, 1e-6);
  EXPECT_NEAR(s.steady.error_percent, 0.1, 1e-6);
  EXPECT_NEAR(s.rms_current_a, 2, 1e-6);
  EXPECT_NEAR(s.commutation_error_mean_deg, 3, 1e-6);
  EXPECT_NEAR(s.commutation_error_rms_deg, 3, 1e-6);
  EXPECT_NEAR(s.phase_error_rms_deg, 5, 1e-6);
  EXPECT_TRUE(s.failures().empty()) << why(s);
}

TEST(Summary, PowersAreTheEnergiesOfTheSpan) {
  const Power p = summarise(steady_only(), {}, record_at(3000)).power;
  EXPECT_NEAR(p.input, 100, 1e-6);
  EXPECT_NEAR(p.load, 80, 1e-6);
  EXPECT_NEAR(p.copper, 9, 1e-6);
  EXPECT_NEAR(p.switches, 5, 1e-6);
  EXPECT_NEAR(p.bus_resistance, 1, 1e-6);
  EXPECT_NEAR(p.friction, 3, 1e-6);
  EXPECT_NEAR(p.stored, 2, 1e-6);
  EXPECT_NEAR(p.efficiency(), 0.8, 1e-9);
  EXPECT_EQ(to_json(p)["efficiency_percent"], 80);
  EXPECT_EQ(Power{}.efficiency(), 0) << "nothing comes in";
}

// The mean of a rotor that swings says nothing of it.
TEST(Summary, ASpeedThatSwingsHasARippleAndTheSameMean) {
  Record r = record_at(3000);
  for (std::size_t i = 0; i < r.overview.size(); ++i) r.overview[i].plant.speed *= i % 2 == 0 ? 1.1 : 0.9;
  const Summary s = summarise(steady_only(), {}, r);
  EXPECT_NEAR(s.steady.mean_rpm, 3000, 1e-6) << "from the angle";
  EXPECT_NEAR(s.ripple.speed_rpm.least, 2700, 1e-6);
  EXPECT_NEAR(s.ripple.speed_rpm.greatest, 3300, 1e-6);
  EXPECT_NEAR(s.ripple.speed_rpm.rms, 300, 3);
  EXPECT_NE(to_text(s).find("2700.00 to 3300.00 rpm"), std::string::npos);
}

// A triangle of 2 N m about 5: its rms about the mean is 1 over the root of three, as a triangle's is.
TEST(Summary, ATorqueHasARippleOverTheFineSamplesAlone) {
  Record r = record_at(3000);
  for (Sample& x : r.overview) x.plant.torque = 99;
  constexpr int kSamples = 3000, kPeriod = 1000;
  for (int i = 0; i < kSamples; ++i) {
    const double part = static_cast<double>(i % kPeriod) / kPeriod;
    Sample x;
    x.plant.torque = 5 + (part < 0.5 ? 4 * part - 1 : 3 - 4 * part);
    r.steady.push_back(x);
  }
  const Summary s = summarise(steady_only(), {}, r);
  EXPECT_NEAR(s.ripple.torque_nm.mean, 5, 1e-9);
  EXPECT_NEAR(s.ripple.torque_nm.least, 4, 1e-9);
  EXPECT_NEAR(s.ripple.torque_nm.greatest, 6, 1e-9);
  EXPECT_NEAR(s.ripple.torque_nm.rms, 1 / std::sqrt(3), 1.0 / kPeriod);
  EXPECT_NE(to_text(s).find("4 to 6 N m, 0.577 N m rms about 5"), std::string::npos) << to_text(s);
}

TEST(Summary, ASpeedErrorBeyondHalfAPercentFails) {
  EXPECT_EQ(summarise(steady_only(), {}, record_at(3014)).failures().size(), 0u);
  const auto failures = summarise(steady_only(), {}, record_at(3016)).failures();
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_NE(failures[0].find("steady"), std::string::npos);
}

TEST(Summary, ASpeedErrorBeyondHalfAPercentInReverseFails) {
  design::Settings s = steady_only();
  s.scenario.reverse_s = 0.5;
  const auto failures_at = [&](double rpm) {
    Record r = record_at(3000);
    for (Sample& x : r.overview) {
      if (x.time > 0.5) x.plant.angle += (rpm - 3000) * std::numbers::pi / 30 * (x.time - 0.5);
    }
    r.changes.push_back({0.5, State::kAccelerate, Reason::kNone});
    r.changes.push_back({0.6, State::kRun, Reason::kNone});
    return summarise(s, {}, r).failures();
  };
  EXPECT_EQ(failures_at(-2986).size(), 0u);
  const auto failures = failures_at(-2984);
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_NE(failures[0].find("in reverse"), std::string::npos);
}

TEST(Summary, ALostLockAndALatchedFaultFail) {
  Record r = record_at(3000);
  r.changes.push_back({0.5, State::kRetryDelay, Reason::kStepOut});
  r.changes.push_back({0.6, State::kFault, Reason::kStepOut});
  const Summary s = summarise(steady_only(), {}, r);
  EXPECT_EQ(s.lost_locks, 1);
  EXPECT_EQ(s.fault, "step_out");
  EXPECT_EQ(s.failures().size(), 2u) << why(s);
}

TEST(Summary, SlippedStepsFail) {
  Record r = record_at(3000);
  r.step_outs = 1;
  EXPECT_EQ(summarise(steady_only(), {}, r).failures().size(), 1u);
}

TEST(Summary, AnRtlThatIsNotItsSourceFails) {
  Record r = record_at(3000);
  r.lockstep = Lockstep{.clocks = 1000};
  EXPECT_TRUE(summarise(steady_only(), {}, r).failures().empty());
  r.lockstep = Lockstep{.clocks = 1000, .differing_clocks = 1, .first_clock = 7, .first_port = "step_o"};
  const Summary s = summarise(steady_only(), {}, r);
  EXPECT_EQ(s.failures().size(), 1u) << why(s);
  EXPECT_NE(to_text(s).find("DIFFERENT on 1, first step_o at clock 7"), std::string::npos);
}

TEST(Summary, APhaseCurrentBeyondItsBoundFails) {
  design::Settings s = steady_only();
  s.bounds.current_a = 5;
  Record r = record_at(3000);
  r.peak_current = 5;
  EXPECT_TRUE(summarise(s, {}, r).failures().empty());
  r.peak_current = 5.01;
  const auto failures = summarise(s, {}, r).failures();
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_NE(failures[0].find("5.01 A, beyond its bound of 5.00 A"), std::string::npos);
}

TEST(Summary, TheJsonHasEveryKeyThatUsersRelyOn) {
  const auto j = to_json(summarise(short_drive(), {}, record_at(3000)));
  for (const char* key :
       {"engine", "locked", "step_outs", "fault", "start_time_s", "lock_time_s", "set_speed_rpm",
        "mean_speed_rpm", "speed_error_percent", "speed_least_rpm", "speed_greatest_rpm", "speed_ripple_rms_rpm",
        "torque_mean_nm", "torque_least_nm", "torque_greatest_nm", "torque_ripple_rms_nm",
        "phase_error_rms_deg", "peak_current_a", "current_bound_a",
        "rms_current_a", "clocks", "simulated_s", "wall_s", "commutation_error_rms_deg", "retries",
        "load_dip_percent", "reversed"}) {
    EXPECT_TRUE(j.contains(key)) << key;
  }
}

TEST(Summary, AnEmptyRecordIsAFailureAndNoCrash) {
  Record r;
  r.interrupted = true;
  const Summary s = summarise(short_drive(), {}, r);
  EXPECT_FALSE(s.failures().empty());
  EXPECT_TRUE(to_json(s)["lock_time_s"].is_null());
}

}  // namespace
}  // namespace steplock
