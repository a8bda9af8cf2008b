// The whole drive turns a motor: the blocks against the plant, judged by the rotor's true angle.
// The words are those that the design library makes for drives/bly172s.toml.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/design/bounds.hpp"
#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "model/plant/plant.hpp"
#include "testbench/drive_file/drive_file.hpp"
#include "testbench/drive/six_step/skipping_top.hpp"
#include "testbench/drive/six_step/config.hpp"

namespace steplock {
namespace {

constexpr double kRpm = 30 / std::numbers::pi;

const design::Settings& settings() {
  static const auto file = load_drive_file(STEPLOCK_ROOT "/drives/bly172s.toml");
  return file.settings;
}

SixStepConfig designed_config(design::Source source = design::Source::kBemf) {
  auto s = settings();
  s.control.source = source;
  return hls_config(design::quantise(design::design_drive(s).parameters, s.control.clock_hz).config);
}

struct Rig {
  double clock_hz = settings().control.clock_hz;
  plant::Plant plant;
  SkippingTop top;
  SixStepTop::In in;
  SixStepTop::Out out;
  std::uint64_t clock = 0;
  std::vector<State> visited;
  double worst_late = 0;  // degrees, of commutations while locked
  double peak = 0;        // A, of any phase
  bool lying_shunt = false, dead_comparators = false, dead_halls = false;

  explicit Rig(double angle_deg = 0, double rpm = 0)
      : plant(plant_parameters(settings()), start(angle_deg, rpm)) {
    in.config = designed_config();
    in.command.configured = in.command.run = true;
  }

  static plant::InitialState start(double angle_deg, double rpm) {
    auto state = initial_state(settings(), angle_deg);
    state.speed = rpm / kRpm;
    return state;
  }

  void run_for(double seconds) {
    const auto end = clock + std::uint64_t(seconds * clock_hz);
    std::uint64_t visit = clock;
    bool ticked = false;
    while (clock < end) {
      if (clock >= visit) {
        plant.advance_to(double(clock) / clock_hz);
        visit = show_pins();
        ticked = false;
      }
      const auto room = std::min(visit, end) - clock;
      if (const auto quiet = ticked ? std::min(top.quiet(in, out), room) : 0; quiet > 0) {
        top.skip(in, out, quiet);
        clock += quiet;
        ticked = false;
        continue;
      }
      out = top.tick(in);
      ticked = true;
      const auto& g = out.gates;
      const plant::Gates gates{g.uh, g.ul, g.vh, g.vl, g.wh, g.wl};
      if (!(gates == plant.gates())) {
        plant.advance_to(double(clock) / clock_hz);
        plant.set_gates(gates);
        visit = show_pins();
        ticked = false;
      }
      if (visited.empty() || visited.back() != out.state) visited.push_back(out.state);
      if (out.commutate && out.locked) judge();
      ++clock;
    }
    plant.advance_to(double(clock) / clock_hz);
  }

  // The first clock at which a pin may change again.
  std::uint64_t show_pins() {
    const auto& p = plant.pins();
    for (const double i : plant.state().current) peak = std::max(peak, std::abs(i));
    in.pins.comparator_u = p.comparator[0];
    in.pins.comparator_v = p.comparator[1];
    in.pins.comparator_w = p.comparator[2];
    in.pins.limit = p.limit;
    in.pins.hall_u = p.hall[0];
    in.pins.hall_v = p.hall[1];
    in.pins.hall_w = p.hall[2];
    if (lying_shunt) in.pins.limit = true;
    if (dead_comparators) in.pins.comparator_u = in.pins.comparator_v = in.pins.comparator_w = true;
    if (dead_halls) in.pins.hall_u = in.pins.hall_v = in.pins.hall_w = false;
    const double next = std::min(std::ceil(plant.next_event() * clock_hz), 1e15);
    return std::max(std::uint64_t(next), clock + 1);
  }

  // Forward step k is ideal from theta = 30 + 60 k; in reverse three places on.  docs/theory.md
  void judge() {
    plant.advance_to(double(clock) / clock_hz);
    const double theta = plant.state().electrical_angle * 180 / std::numbers::pi;
    const int k = (int(out.step.raw()) + (out.reverse ? 3 : 0)) % 6;
    const double late = out.reverse ? 90 + 60 * k - theta : theta - 30 - 60 * k;
    worst_late = std::max(worst_late, std::abs(std::remainder(late, 360.0)));
  }

  double rpm() const { return plant.state().speed * kRpm; }
  double mean_rpm(double seconds) {
    const double from = plant.state().angle;
    run_for(seconds);
    return (plant.state().angle - from) / seconds * kRpm;
  }
  bool was(State state) const {
    return std::find(visited.begin(), visited.end(), state) != visited.end();
  }
};

double set_rpm() { return settings().scenario.speed_rpm; }

TEST(ClosedLoop, StartsFromStandstillLocksAndHoldsItsSpeed) {
  for (const double angle : {0.0, 60.0, 120.0, 180.0, 240.0, 300.0}) {
    Rig rig(angle);
    rig.run_for(0.5);
    EXPECT_EQ(rig.out.state, State::kRun) << angle;
    EXPECT_FALSE(rig.was(State::kRetryDelay)) << angle;
    EXPECT_NEAR(rig.mean_rpm(0.1), set_rpm(), 0.005 * set_rpm()) << angle;
    // A commutation further off than 30 degrees would belong to another step.
    EXPECT_LT(rig.worst_late, 30) << angle;
    EXPECT_EQ(rig.plant.shoot_throughs(), 0u);
  }
}

TEST(ClosedLoop, TakesALoadStepAndLeavesItAgain) {
  Rig rig;
  rig.run_for(0.5);
  rig.plant.set_load_torque(design::load_step_torque(settings()));
  rig.run_for(0.3);
  EXPECT_NEAR(rig.mean_rpm(0.1), set_rpm(), 0.005 * set_rpm());
  rig.plant.set_load_torque(0);
  rig.run_for(0.4);
  EXPECT_NEAR(rig.mean_rpm(0.1), set_rpm(), 0.005 * set_rpm());
  EXPECT_EQ(rig.out.state, State::kRun);
  EXPECT_FALSE(rig.was(State::kRetryDelay));
  EXPECT_LT(rig.worst_late, 30);
}

TEST(ClosedLoop, ReversesThroughABrakeAndAFreshStart) {
  Rig rig;
  rig.run_for(0.5);
  rig.in.command.reverse = true;
  rig.run_for(1.0);
  EXPECT_TRUE(rig.was(State::kSlowDown));
  EXPECT_TRUE(rig.was(State::kBrake));
  EXPECT_EQ(rig.out.state, State::kRun);
  EXPECT_NEAR(rig.mean_rpm(0.1), -set_rpm(), 0.005 * set_rpm());
}

TEST(ClosedLoop, BrakesToAStop) {
  Rig rig;
  rig.run_for(0.5);
  rig.in.command.brake_to_stop = true;
  rig.in.command.run = false;
  rig.run_for(0.8);
  EXPECT_EQ(rig.out.state, State::kIdle);
  EXPECT_NEAR(rig.rpm(), 0, 0.01 * set_rpm());
}

TEST(ClosedLoop, CatchesARotorThatAlreadyTurnsTheWantedWay) {
  for (const bool reverse : {false, true}) {
    Rig rig(100, reverse ? -2000 : 2000);
    rig.in.command.reverse = reverse;
    rig.run_for(0.3);
    EXPECT_EQ(rig.out.state, State::kRun);
    EXPECT_FALSE(rig.was(State::kPreAlign)) << "caught, not started";
    // The first step is entered in its middle, 30 degrees after its ideal beginning.
    EXPECT_LT(rig.worst_late, 31);
  }
}

// Both ways it coasts, and no duty is little enough to hold it back: what the integral loses meanwhile must not take it far below.
TEST(ClosedLoop, ComesDownToASlowerSetSpeedWithoutFallingATenthBelowIt) {
  for (const bool caught : {false, true}) {
    Rig rig(100, caught ? 7000 : 0);
    if (!caught) {
      rig.in.config.speed.target = Frequency(2 * rig.in.config.speed.target.raw());
      rig.run_for(1.5);
      ASSERT_GT(rig.mean_rpm(0.05), 1.5 * set_rpm());
      rig.in.config.speed.target = designed_config().speed.target;
    }
    double lowest = rig.rpm();
    for (int i = 0; i < 150; ++i) {
      rig.run_for(0.01);
      lowest = std::min(lowest, rig.rpm());
    }
    EXPECT_EQ(rig.out.state, State::kRun);
    EXPECT_GT(lowest, 0.9 * set_rpm()) << caught;
    EXPECT_NEAR(rig.mean_rpm(0.1), set_rpm(), 0.005 * set_rpm()) << caught;
  }
}

TEST(ClosedLoop, BrakesARotorThatTurnsTheOtherWayAndThenStarts) {
  Rig rig(100, -2000);
  rig.run_for(1.0);
  EXPECT_TRUE(rig.was(State::kBrake));
  EXPECT_EQ(rig.out.state, State::kRun);
  EXPECT_NEAR(rig.mean_rpm(0.1), set_rpm(), 0.005 * set_rpm());
}

TEST(ClosedLoop, RunsOnHallSensorsToo) {
  for (const bool reverse : {false, true}) {
    Rig rig(20);
    rig.in.config = designed_config(design::Source::kHall);
    rig.in.command.reverse = reverse;
    rig.run_for(1.0);
    EXPECT_EQ(rig.out.state, State::kRun);
    EXPECT_FALSE(rig.was(State::kRetryDelay));
    EXPECT_NEAR(rig.mean_rpm(0.1), reverse ? -set_rpm() : set_rpm(), 0.005 * set_rpm());
  }
}

// Four tries and their rests, within five seconds.
TEST(ClosedLoop, ARotorHeldFastIsBlockedAndEndsInAFault) {
  Rig rig;
  rig.plant.set_load_torque(100);  // N m, far above what the motor can
  for (int i = 0; i < 10 && rig.out.state != State::kFault; ++i) rig.run_for(0.5);
  EXPECT_EQ(rig.out.state, State::kFault);
  EXPECT_EQ(rig.out.reason, Reason::kBlocked);
  EXPECT_EQ(int(rig.out.counts.retries.raw()), int(rig.in.config.start.retries.raw()) + 1);
}

// From a lock, what each part that breaks ends the drive with; gates off, and latched.
struct Broken {
  Reason reason;
  void (*part)(Rig&);
};
TEST(ClosedLoop, EachPartThatBreaksEndsInAFaultWithItsReason) {
  const Broken cases[] = {
      {Reason::kFaultPin, [](Rig& rig) { rig.in.pins.fault = true; }},
      {Reason::kOverCurrent, [](Rig& rig) { rig.lying_shunt = true; }},
      {Reason::kStepOut, [](Rig& rig) { rig.dead_comparators = true; }},
      {Reason::kHallCode, [](Rig& rig) { rig.dead_halls = true; }},
  };
  for (const Broken& broken : cases) {
    Rig rig;
    if (broken.reason == Reason::kHallCode) rig.in.config = designed_config(design::Source::kHall);
    rig.in.config.start.retries = 0;
    rig.run_for(0.5);
    ASSERT_EQ(rig.out.state, State::kRun) << int(broken.reason);
    broken.part(rig);
    rig.run_for(0.2);
    EXPECT_EQ(rig.out.state, State::kFault) << int(broken.reason);
    EXPECT_EQ(rig.out.reason, broken.reason);
    const auto& g = rig.out.gates;
    EXPECT_FALSE(g.uh || g.ul || g.vh || g.vl || g.wh || g.wl);
  }
}

// What may be written while the motor turns, each at its worst: the drive may lose its lock, or latch.  The shunt sees what the
// bus drives, and past it flows what shorted windings drive at the speed that it turns at: no phase carries more than both.
TEST(ClosedLoop, NoGainWrittenWhileRunningDrivesMoreThanTheLimitAndShortedWindings) {
  void (*const writes[])(SixStepConfig&) = {
      [](SixStepConfig& w) { w.loop.ki = UInt<16>::max(); }, [](SixStepConfig& w) { w.loop.kp = UInt<16>::max(); },
      [](SixStepConfig& w) { w.loop.ki = w.loop.kp = UInt<16>::max(); }, [](SixStepConfig& w) { w.speed.kp = UInt<16>::max(); },
      [](SixStepConfig& w) { w.speed.ki = UInt<16>::max(); }, [](SixStepConfig& w) { w.speed.ki = w.speed.kp = UInt<16>::max(); },
  };
  for (std::size_t k = 0; k < std::size(writes); ++k) {
    Rig rig;
    rig.run_for(0.5);
    ASSERT_EQ(rig.out.state, State::kRun);
    rig.peak = 0;
    writes[k](rig.in.config);
    double fastest = 0, slowest = 1e9;
    for (int i = 0; i < 100; ++i) {
      rig.run_for(0.01);
      fastest = std::max(fastest, rig.rpm()), slowest = std::min(slowest, rig.rpm());
    }
    const double speed = std::max(fastest, -slowest);
    EXPECT_LE(rig.peak, design::limited_current(settings()) + design::shorted_current(settings(), speed)) << k;
    EXPECT_LT(speed, 1.1 * set_rpm()) << k;
  }
}

TEST(ClosedLoop, ASetSpeedOfNothingStopsAndTheNextOneStarts) {
  Rig rig;
  const auto target = rig.in.config.speed.target;
  rig.run_for(0.5);
  rig.in.config.speed.target = 0;
  rig.run_for(0.8);
  EXPECT_EQ(rig.out.state, State::kIdle);
  EXPECT_FALSE(rig.was(State::kRetryDelay)) << "no lock was lost on the way";
  EXPECT_NEAR(rig.rpm(), 0, 0.01 * set_rpm());
  rig.in.config.speed.target = target;
  rig.run_for(0.5);
  EXPECT_EQ(rig.out.state, State::kRun);
}

// The control of all the above: a drive that never looks does not lock.
TEST(ClosedLoop, WithoutSamplesNothingLocks) {
  Rig rig;
  rig.in.config.bemf.blanking = 1023;  // no clock between two edges of the PWM is left
  rig.run_for(0.6);
  EXPECT_FALSE(rig.was(State::kRun));
}

}  // namespace
}  // namespace steplock
