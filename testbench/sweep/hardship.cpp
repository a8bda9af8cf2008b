#include "testbench/sweep/hardship.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steplock {
namespace {

constexpr double kPi = std::numbers::pi;

// Numbers of the quantities in Draw, apart from those of the conditions and of the disturbances.
enum Quantity : std::uint64_t { kKind = 200, kSize, kAmplitude, kPhase, kSide, kDetents };

// What is less than this part of the most is no hardship.
constexpr double kLeast = 0.2;
constexpr double kSwingDeg[] = {30, 150};  // mechanical, amplitude
constexpr double kBeltDamping = 0.02;      // of the critical one
constexpr double kLeastBehindBelt = 0.5;   // of all inertia
constexpr double kWindFan = 0.5;           // part of the rated torque at set speed, where the envelope has no fan

// rad/s, at which air that moves at `wind` turns a fan: F (wind - w)^2 = friction + B w; 0 if it holds.
double windmilling(double wind, double fan, double friction, double viscous) {
  if (fan * wind * wind <= friction) return 0;
  double low = 0, high = wind;
  for (int k = 0; k < 60; ++k) {
    const double w = (low + high) / 2;
    (fan * (wind - w) * (wind - w) > friction + viscous * w ? low : high) = w;
  }
  return low;
}

void swing(design::Settings& s, const Hardship& h, double rated) {
  s.load.unbalance_nm = h.size * rated;
  const double angle = s.scenario.start_angle_deg / s.motor.pole_pairs;
  s.load.unbalance_deg = std::remainder(angle - h.detail * 180 / kPi, 360);
  s.scenario.start_speed_rpm =
      h.speed * std::sqrt(2 * s.load.unbalance_nm / (s.motor.inertia_kgm2 + s.load.inertia_kgm2)) * 30 / kPi;
}

void blow(design::Settings& s, const Hardship& h, const design::Settings& file) {
  s.load.wind_rpm = h.size * file.scenario.speed_rpm;
  const double w = windmilling(std::abs(s.load.wind_rpm) * kPi / 30, s.load.fan_nms2, s.motor.coulomb_nm + s.load.opposing_nm,
                               s.motor.viscous_nms);
  s.scenario.start_speed_rpm = std::copysign(w * 30 / kPi, s.load.wind_rpm);
}

void hang_on_belt(design::Settings& s, const Hardship& h) {
  const double all = s.motor.inertia_kgm2 + s.load.inertia_kgm2;
  s.load.inertia_kgm2 = std::max(s.load.inertia_kgm2, kLeastBehindBelt * all);
  s.motor.inertia_kgm2 = all - s.load.inertia_kgm2;
  const double rate = 2 * kPi * h.size;
  s.load.spring_nm_rad = rate * rate * s.load.inertia_kgm2;
  s.load.spring_nms_rad = 2 * kBeltDamping * rate * s.load.inertia_kgm2;
}

}  // namespace

const char* name_of(Trial t) {
  constexpr const char* kNames[kTrials] = {"swing", "wind", "spring", "cogging", "stiction", "breakaway", "comparators"};
  return kNames[static_cast<int>(t)];
}

Hardship draw_hardship(const design::Settings& file, RunSeed seed) {
  const design::HardshipSection& most = file.hardship;
  const Draw draw(seed.value);
  const auto up_to = [&](double greatest) { return draw.uniform(kSize, kLeast * greatest, greatest); };
  Hardship h{.kind = static_cast<Trial>(draw.below(kKind, kTrials))};
  switch (h.kind) {
    case Trial::kSwing: {
      h.size = up_to(most.unbalance);
      const double amplitude = draw.uniform(kAmplitude, kSwingDeg[0], kSwingDeg[1]) * kPi / 180;
      h.detail = amplitude * draw.uniform(kPhase, -1, 1);
      // What the weight has lost in height.
      const double lost = std::sqrt(std::max(0.0, std::cos(h.detail) - std::cos(amplitude)));
      h.speed = draw.unit(kSide) < 0.5 ? lost : -lost;
      break;
    }
    case Trial::kWind: h.size = up_to(most.wind) * (draw.unit(kSide) < 0.5 ? 1 : -1); break;
    case Trial::kSpring: h.size = draw.by_ratio(kSize, most.spring_hz[0], most.spring_hz[1]); break;
    case Trial::kCogging:
      h.size = up_to(most.cogging);
      h.detail = (draw.unit(kDetents) < 0.5 ? 6 : 12) * file.motor.pole_pairs;
      break;
    case Trial::kStiction: h.size = up_to(most.stiction); break;
    case Trial::kBreakaway: h.size = up_to(most.breakaway); break;
    case Trial::kComparators: h.size = most.comparators; break;
  }
  return h;
}

void choose_load(Conditions& c, const Hardship& h, const design::Settings& file) {
  if (h.kind == Trial::kSwing || h.kind == Trial::kWind) {
    c.load = c.speed = 0;
    c.fan = h.kind == Trial::kSwing ? 0 : file.envelope.fan > 0 ? file.envelope.fan : kWindFan;
  }
  if (h.kind == Trial::kStiction || h.kind == Trial::kBreakaway) c.speed = 0;
  if (h.kind != Trial::kComparators) return;
  for (double* x : {&c.offset_u_v, &c.offset_v_v, &c.offset_w_v, &c.noise_v, &c.delay_s}) *x *= h.size;
}

void meet(design::Settings& s, const Hardship& h, const design::Settings& file) {
  const double rated = rated_torque(file);
  switch (h.kind) {
    case Trial::kSwing: swing(s, h, rated); break;
    case Trial::kWind: blow(s, h, file); break;
    case Trial::kSpring: hang_on_belt(s, h); break;
    case Trial::kCogging:
      s.motor.cogging_nm = h.size * rated;
      s.motor.cogging_periods = static_cast<int>(h.detail);
      break;
    case Trial::kStiction: s.motor.static_nm = s.motor.static_nm.value_or(s.motor.coulomb_nm) + h.size * rated; break;
    case Trial::kBreakaway: s.load.breakaway_nm = h.size * rated; break;
    case Trial::kComparators: break;
  }
}

}  // namespace steplock
