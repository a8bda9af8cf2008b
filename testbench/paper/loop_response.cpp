#include "testbench/paper/loop_response.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/rtl_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/paper/ideal_rotor.hpp"

namespace steplock {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// Whole numbers of periods in the measured span, so that no tone leaks into another.
std::vector<double> tone_frequencies(const LoopExperiment& e) {
  std::set<long> periods;
  for (int i = 0; i < e.tones; ++i) {
    const double omega = e.lowest * std::pow(e.highest / e.lowest, double(i) / (e.tones - 1));
    periods.insert(std::max(1L, std::lround(omega * e.measure_s / kTurn)));
  }
  std::vector<double> omegas;
  for (const long n : periods) omegas.push_back(kTurn * static_cast<double>(n) / e.measure_s);
  return omegas;
}

std::vector<StepTaken> commutations_of(const design::Settings& s, const LoopExperiment& e,
                                         const IdealRotor& rotor) {
  const double clock_hz = s.control.clock_hz;
  const SixStepConfig config =
      hls_config(design::quantise(design::design_drive(s).parameters, clock_hz).config);
  const double seconds = e.settle_s + e.measure_s;
  if (e.engine == EngineKind::kRtl) {
    RtlEngine engine(config, clock_hz);
    return commutations_on(engine, rotor, clock_hz, seconds);
  }
  FixedEngine engine(config, clock_hz);
  return commutations_on(engine, rotor, clock_hz, seconds);
}

}  // namespace

double LoopPoint::phase_deg() const {
  const double deg = std::arg(open) * 180 / std::numbers::pi;
  return deg > 0 ? deg - 360 : deg;
}

std::vector<std::complex<double>> tones_in(const std::vector<double>& times,
                                           const std::vector<double>& turns,
                                           const std::vector<double>& omegas) {
  const auto rows = static_cast<Eigen::Index>(times.size());
  const auto tones = static_cast<Eigen::Index>(omegas.size());
  Eigen::MatrixXd basis(rows, 2 + 2 * tones);
  Eigen::VectorXd seen(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto k = static_cast<std::size_t>(i);
    basis(i, 0) = 1;
    basis(i, 1) = times[k];
    for (Eigen::Index j = 0; j < tones; ++j) {
      const double angle = omegas[static_cast<std::size_t>(j)] * times[k];
      basis(i, 2 + 2 * j) = std::sin(angle);
      basis(i, 3 + 2 * j) = std::cos(angle);
    }
    seen(i) = turns[k];
  }
  const Eigen::VectorXd fit = basis.colPivHouseholderQr().solve(seen);
  std::vector<std::complex<double>> found;
  for (Eigen::Index j = 0; j < tones; ++j) found.emplace_back(fit(2 + 2 * j), fit(3 + 2 * j));
  return found;
}

std::vector<LoopPoint> measure_loop(const design::Settings& settings, const LoopExperiment& e) {
  design::Settings s = settings;
  s.scenario.speed_rpm = e.rpm;
  const double amplitude = e.tone_deg / 360;
  const std::vector<double> omegas = tone_frequencies(e);
  std::vector<Tone> tones;
  for (const double omega : omegas) tones.push_back({omega, amplitude});
  const IdealRotor rotor(e.rpm / 60 * s.motor.pole_pairs, tones);

  std::vector<double> times, turns;
  int before = -1;
  std::int64_t count = 0;
  for (const StepTaken& c : commutations_of(s, e, rotor)) {
    if (before >= 0 && (c.step - before + 6) % 6 != 1) {
      throw std::runtime_error(fmt::format("the drive lost the rotor at {:.3f} s", c.time));
    }
    before = c.step;
    ++count;
    if (c.time < e.settle_s) continue;
    times.push_back(c.time);
    turns.push_back(static_cast<double>(count) / 6);
  }
  const double expected = 6 * rotor.frequency() * e.measure_s;
  if (static_cast<double>(times.size()) < 0.99 * expected) {
    throw std::runtime_error(fmt::format("the drive held no lock: {} of {:.0f} commutations",
                                         times.size(), expected));
  }
  const auto found = tones_in(times, turns, omegas);
  std::vector<LoopPoint> points;
  for (std::size_t i = 0; i < omegas.size(); ++i) {
    const std::complex<double> closed = found[i] / amplitude;
    points.push_back({omegas[i], closed, closed / (1.0 - closed)});
  }
  return points;
}

Crossover crossover(const std::vector<LoopPoint>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const LoopPoint &a = points[i - 1], &b = points[i];
    if (a.gain_db() < 0 || b.gain_db() >= 0) continue;
    const double part = a.gain_db() / (a.gain_db() - b.gain_db());
    return {a.omega * std::pow(b.omega / a.omega, part),
            180 + a.phase_deg() + part * (b.phase_deg() - a.phase_deg())};
  }
  return {};
}

}  // namespace steplock
