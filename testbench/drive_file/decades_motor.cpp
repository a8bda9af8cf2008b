#include "testbench/drive_file/decades_motor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "testbench/sweep/draw.hpp"

namespace steplock {
namespace {

enum Quantity : std::uint64_t { kBus, kRated, kFrequency, kInertia, kPairs, kEmf, kLoss, kReactance, kLimit, kAngle, kQuantities };

struct Drawn {
  double bus, rated, rpm, inertia, resistance, inductance, flux, k_e, limit, angle_deg;
  int pairs;

  bool possible() const {
    const double tau = 2 * resistance * inertia / (k_e * k_e), tau_e = inductance / resistance;
    return tau > 1e-3 && tau < 3 && tau_e < 50e-3 && rpm < 200e3 && resistance > 1e-4 && inductance > 1e-7 && inductance < 1 && flux < 10 &&
           limit > 1.2 * rated;
  }
};

Drawn drawn(const Draw& draw, std::uint64_t attempt) {
  const std::uint64_t from = attempt * kQuantities;
  Drawn d;
  d.bus = draw.by_ratio(from + kBus, 2, 800);
  d.rated = draw.by_ratio(from + kRated, 0.1, 1000);
  const double frequency = draw.by_ratio(from + kFrequency, 100, 1e6) / 60, omega = 2 * std::numbers::pi * frequency;
  d.inertia = draw.by_ratio(from + kInertia, 1e-8, 10);
  d.pairs = 1 + static_cast<int>(draw.below(from + kPairs, 21));
  d.rpm = 60 * frequency / d.pairs;
  const double emf = draw.uniform(from + kEmf, 0.4, 0.58) * d.bus;
  d.flux = emf / (std::sqrt(3.0) * omega);
  d.k_e = std::sqrt(3.0) * d.flux * d.pairs;
  d.resistance = draw.by_ratio(from + kLoss, 0.03, 0.2) * emf / (2 * d.rated);
  d.inductance = draw.by_ratio(from + kReactance, 0.03, 0.25) * d.bus / (omega * 2 * d.rated);
  d.limit = std::min(draw.uniform(from + kLimit, 2, 4) * d.rated, 0.6 * d.bus / (2 * d.resistance));
  d.angle_deg = draw.uniform(from + kAngle, 0, 360);
  return d;
}

}  // namespace

std::string decades_motor_name(std::uint64_t index) { return fmt::format("decades_{:04}", index); }

std::string decades_motor_file(std::uint64_t seed, std::uint64_t index) {
  const Draw draw(scramble(seed) + index);
  Drawn d = drawn(draw, 0);
  for (std::uint64_t attempt = 1; !d.possible(); ++attempt) d = drawn(draw, attempt);
  return fmt::format(R"([drive]
name = "{}"
source = "drawn, seed {}: steplock motors --decades"
[motor]
resistance_ohm = {:.4g}
inductance_h = {:.4g}
flux_vs = {:.4g}
pole_pairs = {}
shape = "sinusoidal"
inertia_kgm2 = {:.4g}
coulomb_nm = {:.4g}
rated_current_a = {:.4g}
[inverter]
bus_v = {:.4g}
on_resistance_ohm = {:.4g}
[sensors]
comparator_offset_v = [{:.4g}, {:.4g}, {:.4g}]
comparator_noise_v = {:.4g}
comparator_hysteresis_v = {:.4g}
limit_a = {:.4g}
[control]
clock_hz = 24e6
chopping = "complementary"
[scenario]
speed_rpm = {:.5g}
duration_s = 5
start_angle_deg = {:.1f}
)",
                     decades_motor_name(index), seed, d.resistance, d.inductance, d.flux, d.pairs, d.inertia,
                     std::min(0.02 * d.k_e * d.rated, 100.0), d.rated, d.bus, std::min(d.resistance / 20, 10.0), 4e-4 * d.bus,
                     -4e-4 * d.bus, 2e-4 * d.bus, 2e-4 * d.bus, 4e-4 * d.bus, d.limit, d.rpm, d.angle_deg);
}

}  // namespace steplock
