// The error budget against the loop it speaks of, run with white noise.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/design/budget.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock::design {
namespace {

struct Measured {
  double phase = 0, error = 0, frequency = 0;  // variances per variance of the place
};

// The per-step loop in its plainest form: a rotor that turns one step per step, noise on each
// place.
Measured run_per_step(const PerStep& f) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 1e-3);  // small: the loop is linear
  double x = 1, y = 1, ahead = 0;                   // of the VCO, in turns
  Measured m;
  constexpr int kSteps = 400000;
  for (int k = 0; k < kSteps; ++k) {
    const double e = noise(random) - ahead;
    m.error += e * e;
    m.phase += ahead * ahead;
    x += f.integral * e;
    y += f.pole * (x + f.proportional * e - y);
    m.frequency += (y - 1) * (y - 1);
    ahead += y - 1;
  }
  const double per = 1e-6 * kSteps;
  return {m.phase / per, m.error / per, m.frequency / per};
}

TEST(ErrorBudget, NoiseGainsAreThoseOfTheRunningLoop) {
  for (const double bandwidth : {0.1, 0.2, 0.4}) {
    for (const double pole_ratio : {0.0, 10.0}) {
      const auto f = per_step(bandwidth, 1, pole_ratio);
      const auto g = noise_gains(open_loop(f), 1);
      const auto m = run_per_step(f);
      // 400,000 samples of correlated noise: well within 3 %.
      EXPECT_NEAR(m.phase, g.phase, 0.03 * g.phase);
      EXPECT_NEAR(m.error, g.error, 0.03 * g.error);
      EXPECT_NEAR(m.frequency, g.frequency, 0.03 * g.frequency);
    }
  }
}

TEST(ErrorBudget, ANarrowLoopPassesLessNoise) {
  EXPECT_LT(noise_gains(open_loop(per_step(0.1, 1, 0)), 1).phase,
            noise_gains(open_loop(per_step(0.4, 1, 0)), 1).phase);
}

TEST(ErrorBudget, OfEveryDriveStaysWithinAFewDegreesAndPerMille) {
  for (const char* name : {"amano2003", "bly172s", "br2804_drone", "ceiling_fan", "hoverboard_hub",
                           "m2310p_servo", "maxon_ec45_flat", "tekin_spindle"}) {
    const auto s = load_drive_file(std::string(DRIVES) + "/" + name + ".toml").settings;
    const auto d = design_drive(s);
    const auto b = error_budget(s, d, quantise(d.parameters, s.control.clock_hz).config);
    // A commutation 10 degrees off costs 1.5 % of torque.
    EXPECT_LT(b.commutation.bound, 10) << name;
    EXPECT_LT(b.mean_speed.bound, 2e-3 * s.scenario.speed_rpm) << name;
    for (const auto& row : b.out()) EXPECT_GE(row.bound, row.rms) << name << " " << row.name;
  }
}

TEST(ErrorBudget, FinerSamplingLowersIt) {
  auto s = load_drive_file(std::string(DRIVES) + "/br2804_drone.toml").settings;
  const auto of = [](const Settings& settings) {
    const auto d = design_drive(settings);
    return error_budget(settings, d, quantise(d.parameters, settings.control.clock_hz).config);
  };
  const auto fine = of(s);
  s.control.sample_every_s *= 4;
  s.control.blanking_s *= 2;
  EXPECT_GT(of(s).commutation.rms, 1.5 * fine.commutation.rms);
}

}  // namespace
}  // namespace steplock::design
