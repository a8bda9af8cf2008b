#include "testbench/compare/control_shadow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/design/sinusoidal/config.hpp"
#include "model/design/sinusoidal/design.hpp"

namespace steplock::sinusoidal {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
const double kRoot = std::sqrt(1.5);  // a power-invariant vector over a phase's peak

double part(Int<16> x) { return std::ldexp(static_cast<double>(x.raw()), -15); }

}  // namespace

ControlShadow::ControlShadow(const design::Settings& s, const design::sinusoidal::Parameters& p)
    : p_(p),
      current_(design::sinusoidal::current_range(s)),
      voltage_(design::sinusoidal::voltage_range(s)),
      speed_(kTurn / 16 * s.control.pwm_hz) {
  const auto q = design::sinusoidal::quantise(s);
  k_p_ = rounded(q.rows, "control.k_p"), k_i_ = rounded(q.rows, "control.k_i");
  inductance_ = rounded(q.rows, "control.inductance"), emf_ = rounded(q.rows, "control.emf");
  period_ = q.config["bridge.period"], minimum_ = q.config["bridge.minimum"];
  lost_ = p.applied.dead_time * s.control.clock_hz * (1 + 2 * p.applied.diode_drop / s.inverter.bus_v);
}

double ControlShadow::axis(double& x, double error, double known, double limit) const {
  const double moved = x + p_.current.ki_delta * p_.pwm.period * error;
  const double wanted = moved + p_.current.kp_delta * error + known;
  const bool above = wanted > limit, below = wanted < -limit;
  if (!(above && error >= 0) && !(below && error < 0)) x = moved;
  return std::clamp(wanted, -limit, limit);
}

void ControlShadow::take(const SinusoidalTop::Out& out, const SinusoidalTop::Out& before) {
  ++samples_;
  const double w = speed_ * part(before.speed), gamma = current_ * part(out.i_gamma), delta = current_ * part(out.i_delta);
  const double set_gamma = p_.current.i_gamma / kRoot, set_delta = current_ * part(before.wanted);
  const double v_dc = voltage_ * std::ldexp(static_cast<double>(out.v_dc.raw()), -12);
  const double limit = v_dc * (p_.pwm.modulation == design::Modulation::kSine ? 0.5 : 1 / std::numbers::sqrt3);
  const double w_l = w * p_.motor.inductance_q, w_k = w * p_.motor.k_e / kRoot;
  const double u_gamma = axis(x_gamma_, set_gamma - gamma, -w_l * delta, 0.75 * limit);
  const double length = std::abs(u_gamma);
  const double left = std::min({limit - 9.0 / 64 * length, 17.0 / 16 * limit - 13.0 / 32 * length, 1.25 * limit - 13.0 / 16 * length});
  const double u_delta = axis(x_delta_, set_delta - delta, w_l * gamma + w_k, std::max(0.0, left));

  // A sample and a half on.
  const double angle = kTurn * static_cast<double>(out.angle.raw() >> 8) / 65536 + 1.5 * w * p_.pwm.period;
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const auto phases = [&](double x, double y) {
    const double alpha = x * cosine - y * sine, beta = x * sine + y * cosine, side = std::numbers::sqrt3 / 2 * beta;
    return std::array{alpha, side - alpha / 2, -side - alpha / 2};
  };
  std::array<double, 3> v = phases(u_gamma, u_delta);
  const std::array<double, 3> wanted = phases(set_gamma, set_delta);
  if (p_.pwm.modulation == design::Modulation::kSpaceVector) {
    const auto [least, greatest] = std::ranges::minmax(v);
    for (double& x : v) x -= (least + greatest) / 2;
  }
  const double place = std::ldexp(voltage_, -15);  // V
  const double per_place = period_ * place / v_dc;  // clocks
  const double vector = std::hypot(u_gamma, u_delta) / place;
  const auto words = [&](double error, double x, double across) {
    return (k_p_ * std::abs(p_.current.kp_delta * error) + k_i_ * std::abs(x) + inductance_ * std::abs(w_l * across)) / place;
  };
  const double began = std::ldexp(static_cast<double>(samples_), -13);
  const double of_gamma = 1 + began + words(set_gamma - gamma, x_gamma_, delta);
  const double of_delta = 1 + began + words(set_delta - delta, x_delta_, gamma) + emf_ * std::abs(w_k) / place;
  const double greatest = std::max(std::abs(std::ranges::min(v)), std::abs(std::ranges::max(v)));
  const double inverse = std::ldexp(1, -12) * v_dc / voltage_;  // relative, of 1 / v_dc in u3.12
  const double bias = per_place * std::hypot(of_gamma, of_delta) + period_ * greatest / v_dc * inverse + 3.0 / 16;
  const double turned = vector * std::hypot(2 * std::ldexp(std::numbers::sqrt2, -15), 1.5 * kTurn / 65536);
  const double scatter = std::hypot(kUniform, per_place * std::hypot(kUniform * std::sqrt(2 * (2 + 3) + 2 + 4), turned));
  error_ = {std::max(error_.bias, bias), std::max(error_.scatter, scatter)};

  const LegClocks on[] = {out.on_u, out.on_v, out.on_w};
  clocks_.clear();
  // A wanted phase current so small may be told with the other sign: its roundings, and as `turned` of the voltage.
  const double vague = current_ * std::ldexp(4, -15) +
                       std::hypot(set_gamma, set_delta) * (2 * std::ldexp(std::numbers::sqrt2, -15) + 1.5 * kTurn / 65536);
  for (std::size_t k = 0; k < 3; ++k) {
    if (p_.applied.compensate && std::abs(wanted[k]) < vague) continue;
    const double made_up = p_.applied.compensate ? std::copysign(lost_, wanted[k]) : 0;
    const double exact = period_ * (0.5 + v[k] / v_dc) + made_up;
    const double shortest = std::min(std::abs(exact - minimum_), std::abs(period_ - exact - minimum_));
    if (shortest < bias + 6 * scatter) continue;
    const double asked = exact < minimum_ ? 0 : period_ - exact < minimum_ ? period_ : exact;
    clocks_.push_back(static_cast<double>(on[k].raw()) - asked);
  }
}

}  // namespace steplock::sinusoidal
