// See budget.hpp for the equations.
#include "model/design/budget.hpp"

#include <cmath>
#include <numbers>

namespace steplock::design {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSigmas = 6;

BudgetRow spread_over(const char* name, double width) {  // uniform over `width`
  return {name, "step", width / std::sqrt(12.0), width / 2};
}

// Volts per second of the floating phase at its crossing, as the comparator sees them: 2/3 of the
// back-EMF against the mean of the terminals.
double slope_at_crossing(const Settings& s, double f) {
  const double omega = f * 2 * kPi / 6;
  const double flank =
      s.motor.shape == Shape::kTrapezoidal ? 1 / ((180 - s.motor.flat_top_deg) / 2 * kPi / 180) : 1;
  return 2.0 / 3 * s.motor.flux_vs * omega * omega * flank;
}

std::vector<BudgetRow> blurs(const Settings& s, const Parameters& p) {
  const double f = p.speed.target, clock = 1 / s.control.clock_hz;
  std::vector<BudgetRow> rows;
  rows.push_back(spread_over("sample interval", p.bemf.sample_every * f));
  // Blind for `blanking` after each of two edges; if only one chop state is sampled, in the other.
  const double duty = std::min(1.0, p.speed.bemf * f);
  double gap = p.bemf.blanking + p.bemf.sample_every, share = 2 * p.bemf.blanking / p.pwm.period;
  if (p.bemf.sampling != Sampling::kBoth) {
    const double dark = p.bemf.sampling == Sampling::kOnTime ? 1 - duty : duty;
    gap += dark * p.pwm.period;
    share = std::min(1.0, dark + p.bemf.blanking / p.pwm.period);
  }
  rows.push_back({"blind gap at PWM edges", "step", std::sqrt(share / 12) * gap * f, gap * f / 2});
  const double noise = s.sensors.comparator_noise_v / slope_at_crossing(s, f) * f;
  rows.push_back({"comparator noise", "step", noise, kSigmas * noise});
  rows.push_back(spread_over("synchroniser", clock * f));
  rows.push_back(spread_over("phase word", 1.0 / 65536));
  return rows;
}

}  // namespace

NoiseGains noise_gains(const Response& open_loop, double interval) {
  NoiseGains g;
  constexpr int kPoints = 20000;
  for (int k = 0; k < kPoints; ++k) {
    const double omega = (k + 0.5) / kPoints * kPi / interval;
    const auto h = open_loop(omega);
    const auto closed = h / (1.0 + h);
    g.phase += std::norm(closed) / kPoints;
    g.error += std::norm(1.0 / (1.0 + h)) / kPoints;
    g.frequency += std::norm((std::polar(1.0, omega * interval) - 1.0) * closed) / kPoints;
  }
  return g;
}

Budget error_budget(const Settings& s, const Design& d, const Config& w, double apart_s) {
  const Parameters& p = d.parameters;
  const double f = p.speed.target;
  const int steps = p.loop.detector == Detector::kEveryStep ? 1 : 6;
  const double interval = steps / f;
  const bool by_step = p.loop.form == LoopForm::kPerStep;
  const NoiseGains g =
      by_step
          ? noise_gains(open_loop(per_step(d.bandwidth, s.loop.damping,
                                           s.loop.pole_ratio.value_or(0), steps)),
                        1)
          : noise_gains(open_loop_sampled(per_second(d.components, d.k_l), p.pwm.tick(), interval),
                        interval);
  Budget b;
  b.in = blurs(s, p);
  double variance = 0;
  for (const auto& row : b.in) variance += row.rms * row.rms;
  const double place = std::sqrt(variance);

  const auto row = [](const char* name, const char* unit, double rms, double bias) {
    return BudgetRow{name, unit, rms, bias + kSigmas * rms, bias};
  };
  const double hertz = std::ldexp(s.control.clock_hz, -32 - p.loop.divide);
  const double speed_step = std::ldexp(hertz, int(w["speed.shift"]));
  const double delay = 2 / s.control.clock_hz * f;  // of the latency that the delay word rounds
  b.phase_error = row("phase error", "deg", 60 * place * std::sqrt(g.error), 60 * delay);
  b.commutation = row("commutation", "deg", 60 * place * std::sqrt(g.phase), 60 * delay);
  b.instant = row("commutation instant", "s", place * std::sqrt(g.phase) / f, delay / f);
  // The frequency changes by this much of a step per interval.
  const double f_rms = place * std::sqrt(g.frequency) / interval;
  b.frequency = row("momentary speed", "rpm", rpm_of(s, f_rms), rpm_of(s, speed_step));
  const double mean_bias = rpm_of(s, speed_step + hertz);
  b.mean_speed = {"mean speed", "rpm", rpm_of(s, speed_step) / std::sqrt(12.0), mean_bias, mean_bias};
  const double clocks = s.control.clock_hz * p.pwm.period;
  // Each tick, or each new frequency if they are rarer, adds an independent error to the integral; what
  // rounding of target and frequency (one's complement) adds has a sign.
  const double look = std::max(p.pwm.tick(), interval);
  const double wander = p.speed.ki * f_rms * std::sqrt(apart_s * look);
  const double drift = p.speed.ki * 1.5 * hertz * apart_s;
  b.duty = row("duty", "1", std::hypot(p.speed.kp * f_rms, wander), 1 / clocks + 1.0 / 32768 + drift);
  return b;
}

}  // namespace steplock::design
