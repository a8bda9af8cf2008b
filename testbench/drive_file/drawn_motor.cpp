#include "testbench/drive_file/drawn_motor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "testbench/sweep/draw.hpp"

namespace steplock {
namespace {

// One lithium cell, packs of them, and the usual supplies.
constexpr std::array kBuses = {3.7, 7.4, 11.1, 12.0, 22.2, 24.0, 36.0, 48.0, 72.0, 96.0};

enum Quantity : std::uint64_t {
  kPower, kBus, kFrequency, kPairs, kEmf, kLoss, kReactance, kTau, kLoadInertia, kFriction, kFan, kLimit, kShape
};

}  // namespace

std::string drawn_motor_name(std::uint64_t index) { return fmt::format("motor_{:04}", index); }

std::string drawn_motor_file(std::uint64_t seed, std::uint64_t index) {
  const Draw draw(scramble(seed) + index);
  const double power = draw.by_ratio(kPower, 3, 3000);
  std::vector<double> buses;
  std::copy_if(kBuses.begin(), kBuses.end(), std::back_inserter(buses),
               [&](double v) { return power / (0.6 * v) > 0.3 && power / (0.6 * v) < 80; });
  const double bus = buses[draw.below(kBus, buses.size())];
  const double frequency = draw.by_ratio(kFrequency, 50, 700);
  std::vector<int> all_pairs;
  for (int pairs = 1; pairs <= 21; ++pairs) {
    if (const double rpm = 60 * frequency / pairs; rpm > 100 && rpm < 50'000) all_pairs.push_back(pairs);
  }
  const int pairs = all_pairs[draw.below(kPairs, all_pairs.size())];

  const double omega = 2 * std::numbers::pi * frequency;
  const double emf = draw.uniform(kEmf, 0.4, 0.58) * bus;
  const double flux = emf / (std::sqrt(3.0) * omega);
  const double rated = power / emf;
  const double resistance = draw.by_ratio(kLoss, 0.03, 0.2) * power / (2 * rated * rated);
  const double inductance = draw.by_ratio(kReactance, 0.03, 0.25) * bus / (omega * 2 * rated);
  // Torque per ampere of two phases in series; the speed constant's inverse.
  const double k_e = std::sqrt(3.0) * flux * pairs;
  const double inertia = draw.by_ratio(kTau, 3e-3, 60e-3) * k_e * k_e / (2 * resistance);
  const double torque = k_e * rated, speed = omega / pairs;
  const double limit = std::min(draw.uniform(kLimit, 2, 4) * rated, 0.6 * bus / (2 * resistance));

  return fmt::format(R"([drive]
name = "{}"
source = "drawn, seed {}: steplock motors"

[motor]
resistance_ohm = {:.4g}
inductance_h = {:.4g}
flux_vs = {:.4g}
pole_pairs = {}
shape = "{}"
inertia_kgm2 = {:.4g}
coulomb_nm = {:.4g}
rated_current_a = {:.4g}

[load]
inertia_kgm2 = {:.4g}
fan_nms2 = {:.4g}

[inverter]
bus_v = {}
bus_resistance_ohm = {:.4g}
on_resistance_ohm = {:.4g}
dead_time_s = 0.5e-6

[sensors]
comparator_offset_v = [{:.4g}, {:.4g}, {:.4g}]
comparator_noise_v = {:.4g}
comparator_hysteresis_v = {:.4g}
limit_a = {:.4g}

[control]
clock_hz = 24e6
pwm_hz = 24e3
chopping = "complementary"
blanking_s = 2e-6
sample_every_s = 1e-6
samples = 3

[scenario]
speed_rpm = {:.4g}
duration_s = 3
)",
                     drawn_motor_name(index), seed, resistance, inductance, flux, pairs,
                     draw.below(kShape, 2) == 0 ? "sinusoidal" : "trapezoidal", inertia,
                     draw.uniform(kFriction, 0.01, 0.04) * torque, rated,
                     draw.uniform(kLoadInertia, 0, 4) * inertia,
                     draw.uniform(kFan, 0, 0.5) * torque / (speed * speed), bus, resistance / 5, resistance / 20,
                     4e-4 * bus, -4e-4 * bus, 2e-4 * bus, 2e-4 * bus, 4e-4 * bus, limit, 60 * frequency / pairs);
}

}  // namespace steplock
