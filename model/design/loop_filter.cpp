// See loop_filter.hpp for the equations.
#include "model/design/loop_filter.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace steplock::design {
namespace {

using Complex = std::complex<double>;
constexpr double kDegrees = 180 / std::numbers::pi;

double log_rho(const LoopSpecification& s) { return std::log(s.rho / 100); }

}  // namespace

double settling_time(const LoopSpecification& s) { return s.n_c / s.f_m; }
double omega_n(const LoopSpecification& s) { return -log_rho(s) / (s.zeta * settling_time(s)); }
double omega_g(const LoopSpecification& s) { return -2 * log_rho(s) * s.f_m / s.n_c; }
double omega_z(const LoopSpecification& s) { return omega_g(s) / std::sqrt(s.lambda); }

double Components::omega_g() const { return std::sqrt(omega_z() * omega_p()); }

Complex Components::impedance(Complex s) const {
  return (s * r * c2 + 1.0) / (s * s * r * c1 * c2 + s * (c1 + c2));
}

Components components(const LoopSpecification& s) {
  const double l = log_rho(s);
  const double c1 = s.k_l * s.n_c * s.n_c / (4 * std::sqrt(s.lambda) * l * l * s.f_m * s.f_m);
  return {.c1 = c1,
          .c2 = c1 * (s.lambda - 1),
          .r = 2 * s.lambda * l * s.f_m / (s.n_c * s.k_l * (1 - s.lambda))};
}

double loop_gain_for(const Components& c) {
  const double g = c.omega_g();
  return g * g * c.c1 * std::hypot(g, c.omega_p()) / std::hypot(g, c.omega_z());
}

PerSecond per_second(const Components& c, double k_l) {
  const double integral = k_l / (c.c1 + c.c2);
  return {.integral = integral, .proportional = integral / c.omega_z(), .omega_p = c.omega_p()};
}

PerStep per_step(double bandwidth, double damping, double pole_ratio, int steps) {
  const double integral = bandwidth * bandwidth * steps, proportional = 2 * damping * bandwidth;
  const double omega_z = integral / proportional;  // rad per update
  return {.integral = integral,
          .proportional = proportional,
          .pole = pole_ratio > 0 ? 1 - std::exp(-pole_ratio * omega_z) : 1,
          .steps = steps};
}

Response open_loop(const PerSecond& f) {
  return [f](double omega) {
    const Complex s(0, omega);
    return (f.integral / s + f.proportional) / (1.0 + s / f.omega_p) / s;
  };
}

Response open_loop_sampled(const PerSecond& f, double tick, double crossing_interval) {
  return [=](double omega) {
    const Complex z = std::polar(1.0, omega * tick);
    const double pole = 1 - std::exp(-f.omega_p * tick);
    const Complex filter =
        (f.integral * tick * z / (z - 1.0) + f.proportional) * pole / (1.0 - (1 - pole) / z);
    // The held error is half an interval old on the average; a frequency acts for a tick.
    const Complex hold = std::polar(1.0, -omega * crossing_interval / 2);
    return filter * hold * tick / (z - 1.0);
  };
}

Response open_loop(const PerStep& f) {
  return [f](double omega) {
    const Complex z = std::polar(1.0, omega);
    const Complex filter =
        (f.integral * z / (z - 1.0) + f.proportional) * f.pole / (1.0 - (1 - f.pole) / z);
    return filter * double(f.steps) / (z - 1.0);
  };
}

std::vector<BodePoint> bode(const Response& h, double lowest, double highest, int points) {
  std::vector<BodePoint> curve;
  double phase = -180;
  for (int k = 0; k < points; ++k) {
    const double omega = lowest * std::pow(highest / lowest, double(k) / (points - 1));
    const Complex value = h(omega);
    const double angle = std::arg(value) * kDegrees;
    phase = angle - 360 * std::round((angle - phase) / 360);
    curve.push_back({omega, 20 * std::log10(std::abs(value)), phase});
  }
  return curve;
}

Margins margins(const Response& h, double lowest, double highest) {
  Margins m{.gain_db = std::numeric_limits<double>::infinity()};
  const auto curve = bode(h, lowest, highest, 4000);
  for (std::size_t k = 1; k < curve.size(); ++k) {
    const auto &a = curve[k - 1], &b = curve[k];
    if (m.crossover == 0 && a.gain_db >= 0 && b.gain_db < 0) {
      const double part = a.gain_db / (a.gain_db - b.gain_db);
      m.crossover = a.omega * std::pow(b.omega / a.omega, part);
      m.phase_deg = 180 + a.phase_deg + part * (b.phase_deg - a.phase_deg);
    }
    if (m.crossover > 0 && a.phase_deg >= -180 && b.phase_deg < -180) {
      m.gain_db = -a.gain_db;
      break;
    }
  }
  return m;
}

}  // namespace steplock::design
