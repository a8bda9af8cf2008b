// How the points of the page are measured.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/design/sinusoidal/design.hpp"
#include "testbench/paper/matsui1996.hpp"
#include "testbench/run/timeline.hpp"
#include "testbench/drive/sinusoidal/fixed_engine.hpp"
#include "testbench/drive/sinusoidal/rtl_engine.hpp"
#include "testbench/drive/sinusoidal/run.hpp"

namespace steplock::matsui1996 {
namespace {

template <class Engine>
class RigOf : public Rig {
 public:
  RigOf(const design::Settings& believed, const design::Settings& real, double angle_deg)
      : bench_(believed, real, timeline(believed), angle_deg) {}

  void run_until(double seconds) override { bench_.run_until(seconds); }
  double time() const override { return bench_.time(); }
  void set_speed(double rpm) override { bench_.engine().set_target_rpm(rpm); }
  void set_torque(double nm) override { bench_.plant().set_active_torque(nm); }
  plant::State state() override { return bench_.plant().state(); }
  sinusoidal::View view() override { return bench_.engine().view(); }
  bool locked() override { return bench_.engine().watch().locked(); }
  double delta_deg() override { return bench_.recorder().delta_theta_deg(); }
  sinusoidal::Totals totals() override { return bench_.recorder().totals(); }
  sinusoidal::Record take() override { return bench_.take(); }

 private:
  sinusoidal::BenchOf<Engine> bench_;
};

}  // namespace

std::unique_ptr<Rig> make_rig(EngineKind engine, const design::Settings& believed,
                              const design::Settings& real, double angle_deg) {
  switch (engine) {
    case EngineKind::kFloat:
      return std::make_unique<RigOf<sinusoidal::FloatEngine>>(believed, real, angle_deg);
    case EngineKind::kFixed:
      return std::make_unique<RigOf<sinusoidal::FixedEngine>>(believed, real, angle_deg);
    case EngineKind::kRtl:
      return std::make_unique<RigOf<sinusoidal::RtlEngine>>(believed, real, angle_deg);
  }
  throw std::invalid_argument("no such engine");
}

design::Settings steady(design::Settings s, design::Estimator estimator, double rpm,
                        double i_gamma) {
  drop_events(s.scenario);
  s.scenario.speed_rpm = rpm;
  s.scenario.duration_s = 60;  // more than any run here
  s.sinusoidal.estimator = estimator;
  s.sinusoidal.i_gamma_a = i_gamma;
  return s;
}

double rated_torque(const design::Settings& s) {
  return design::sinusoidal::design_drive(s).rated_torque;
}

std::vector<Point> measure(const design::Settings& believed, const design::Settings& real,
                           const Case& c, const PaperOptions& options, const std::string& what) {
  constexpr double kStarted = 0.9;  // s, after which a start has locked
  const auto start = design::sinusoidal::design_drive(believed).parameters.start;
  // Without load and without gamma current it hunts: nearer to the lock's speed no lock would be claimed.
  const double locks = 2 * design::sinusoidal::rpm_of(believed, start.lock_speed);
  const double settle = c.rpm <= 10 ? 1 : c.rpm <= 50 ? 0.6 : 0.4;
  const double turn = 60 / c.rpm / believed.motor.pole_pairs;
  // What of its hunting does not go with the turns moves the rotor by a degree or two at both ends.  At the
  // slowest a turn of the shaft is what there is time for.
  const double turns = c.rpm <= 10 ? believed.motor.pole_pairs : c.rpm <= 50 ? 4 : 2;
  const double span = turn * std::max(turns, std::round(0.3 / turn));
  const auto rig = make_rig(
      c.engine, steady(believed, c.estimator, std::max(c.rpm, locks), c.i_gamma), real, 130);
  rig->run_until(kStarted);
  rig->set_speed(c.rpm);
  rig->run_until(kStarted + settle / 2);
  std::vector<Point> all;
  for (const double torque : c.torques) {
    if (options.progress &&
        !options.progress(what, double(all.size()) / double(c.torques.size()))) {
      throw Stopped();
    }
    constexpr int kParts = 50;
    const double was = all.empty() ? 0 : all.back().torque;
    for (int n = 1; c.slowly && n < kParts; ++n) {
      rig->set_torque((was + (torque - was) * n / kParts) * rated_torque(real));
      rig->run_until(rig->time() + 1.0 / kParts);
    }
    rig->set_torque(torque * rated_torque(real));
    rig->run_until(rig->time() + settle);
    const double from = rig->time(), angle = rig->state().angle;
    const sinusoidal::Totals before = rig->totals();
    Point p{.rpm = c.rpm, .torque = torque, .least_rpm = 1e9, .greatest_rpm = -1e9};
    double sum = 0, squares = 0;
    const double period = 1 / believed.control.pwm_hz;
    const auto periods = static_cast<int>(std::round(span / period));
    for (int n = 1; n <= periods; ++n) {
      rig->run_until(n < periods ? from + n * period : from + span);
      const double now = rpm(rig->state().speed);
      p.least_rpm = std::min(p.least_rpm, now), p.greatest_rpm = std::max(p.greatest_rpm, now);
      p.delta_greatest_deg = std::max(p.delta_greatest_deg, std::abs(rig->delta_deg()));
      sum += now, squares += now * now;
    }
    p.rms_rpm = std::sqrt(std::max(0.0, squares / periods - sum / periods * sum / periods));
    const double mean = rpm((rig->state().angle - angle) / (rig->time() - from));
    const sinusoidal::Totals after = rig->totals();
    const double samples = std::max(1.0, double(after.angles - before.angles));
    p.error_percent = 100 * (mean / c.rpm - 1);
    p.held = rig->locked() && std::abs(p.error_percent) < 20;
    p.delta_deg = (after.angle_deg - before.angle_deg) / samples;
    p.delta_rms_deg = std::sqrt((after.angle_squared - before.angle_squared) / samples);
    all.push_back(p);
  }
  return all;
}

Claim rtl_point(const design::Settings& drive, const Case& fixed, const std::string& where,
                const PaperOptions& options, std::vector<std::string>& failures) {
  Case rtl = fixed;
  rtl.engine = options.engine;
  const std::string what = fmt::format("{}, engine {}", where, name_of(options.engine));
  const Point a = measure(drive, drive, fixed, options, where + ", engine fixed").front();
  const Point b = measure(drive, drive, rtl, options, what).front();
  const bool same = a.error_percent == b.error_percent && a.delta_deg == b.delta_deg;
  if (!same) failures.push_back(what + " differs from engine fixed");
  return {fmt::format("{}, rated torque, engine {}: error", where, name_of(options.engine)),
          "%",
          {},
          "",
          b.error_percent,
          same ? "engine fixed: the same" : "engine fixed differs"};
}

bool all_held(const std::vector<Point>& points) {
  return std::ranges::all_of(points, &Point::held);
}

const Point& most_swinging(const std::vector<Point>& points) {
  return *std::ranges::max_element(points, {}, &Point::swing_percent);
}

double worst_error(const std::vector<Point>& points) {
  double worst = 0;
  for (const Point& p : points) worst = std::max(worst, std::abs(p.error_percent));
  return worst;
}

}  // namespace steplock::matsui1996
