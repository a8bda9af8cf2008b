// The figures of a run: the whole scenario, the start, two turns at set speed, the load step, where the power goes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "testbench/report/power_figure.hpp"
#include "testbench/report/events.hpp"
#include "testbench/run/units.hpp"
#include "testbench/drive/sinusoidal/run.hpp"

namespace steplock::sinusoidal {
namespace {

using Samples = std::vector<Sample>;

// Curves over the samples of a span, against the time from `origin` on.
class Curves {
 public:
  Curves(const Samples& samples, double scale = 1, double origin = 0, double from = 0,
         double to = std::numeric_limits<double>::infinity())
      : samples_(samples), scale_(scale), origin_(origin), from_(from), to_(to) {}

  template <class F>
  Curve operator()(const char* title, const char* color, F&& y, double width = 1.4) const {
    std::vector<Point> all;
    for (const Sample& s : samples_) {
      if (s.time >= from_ && s.time <= to_) all.push_back({(s.time - origin_) * scale_, y(s)});
    }
    return {title, color, outlined(all), width};
  }
  Panel speeds() const {
    return {.label = "speed, rpm",
            .curves = {(*this)("drive's own", palette::kDrive, [](const Sample& s) { return s.drive.speed_rpm; }),
                       (*this)("rotor", palette::kTrue, [](const Sample& s) { return rpm(s.plant.speed); })},
            .weight = 1.3};
  }
  Panel phases() const {
    Panel panel{.label = "phase current, A"};
    constexpr const char* kName[] = {"u", "v", "w"};
    constexpr const char* kColor[] = {palette::kU, palette::kV, palette::kW};
    for (std::size_t k = 0; k < 3; ++k) {
      panel.curves.push_back((*this)(kName[k], kColor[k], [k](const Sample& s) { return s.plant.current[k]; }, 1.1));
    }
    return panel;
  }
  // The rotor's axes, and the drive's: equal where the estimate is right.
  Panel axes() const {
    return {.label = "d and q current, A",
            .curves = {(*this)("q, rotor", palette::kW, [](const Sample& s) { return rotor_current(s.plant).q; }, 1),
                       (*this)("d, rotor", palette::kU, [](const Sample& s) { return rotor_current(s.plant).d; }, 1),
                       (*this)("delta, drive", palette::kTrue, [](const Sample& s) { return s.drive.i_delta; }, 1),
                       (*this)("gamma, drive", palette::kDrive, [](const Sample& s) { return s.drive.i_gamma; }, 1)},
            .weight = 1.3};
  }
  Panel angle_error() const {
    return {.label = "angle error, deg",
            .curves = {(*this)("", palette::kTrue, [](const Sample& s) { return s.delta_theta_deg; })}};
  }
  Panel torques() const {
    return {.label = "torque, N m",
            .curves = {(*this)("motor", palette::kV, [](const Sample& s) { return s.plant.torque; }, 0.9),
                       (*this)("load", palette::kQuiet, [](const Sample& s) { return s.load_nm; })}};
  }

 private:
  const Samples& samples_;
  double scale_, origin_, from_, to_;
};

Figure whole_run(const design::Settings& s, const Record& record) {
  const Curves curves(record.overview);
  Figure run{.name = "run", .title = s.drive.name + ": the whole scenario", .axis = "time, s",
             .caption = "The whole scenario: speed, current in the rotor's axes and in the drive's, torque, and the "
                        "error of the estimated angle."};
  run.panels = {curves.speeds(), curves.axes(), curves.torques(), curves.angle_error()};
  run.marks = events_of(s);
  return run;
}

Figure start(const design::Settings& s, const Record& record) {
  Figure f{.name = "start", .title = s.drive.name + ": start", .axis = "time, s",
           .caption = "From standstill to lock: phase currents, speed and the N pole, the rotor's and the drive's."};
  double end = 0.3 * s.scenario.duration_s;
  for (const StateChange& c : record.changes) {
    f.marks.push_back({c.time, name_of(c.state)});
    if (c.state == State::kRun) {
      end = c.time * 1.2;
      break;
    }
  }
  const Curves curves(record.overview, 1, 0, 0, end);
  f.panels = {curves.phases(), curves.speeds(),
              {.label = "N pole, deg",
               .curves = {curves("drive's own", palette::kDrive,
                                 [](const Sample& x) { return x.drive.angle_deg - 360 * std::floor(x.drive.angle_deg / 360); }),
                          curves("rotor", palette::kTrue, [](const Sample& x) { return north_pole_deg(x.plant); })}}};
  return f;
}

Figure lock(const Record& record) {
  const Curves curves(record.lock, 1e3, record.lock.front().time);
  Figure f{.name = "lock", .title = "The estimator takes hold", .axis = "time after the estimator's start, ms",
           .caption = "From the estimator's first sample to a little after lock: where the rotor's axes and the "
                      "drive's agree, the estimate is right."};
  f.panels = {curves.speeds(), curves.axes(), curves.angle_error()};
  return f;
}

Figure steady(const Record& record) {
  const Curves curves(record.steady, 1e3, record.steady.front().time);
  Figure f{.name = "steady", .title = "Two electrical turns at set speed", .axis = "time, ms",
           .caption = "The last two electrical turns before the first disturbance: back-EMF, phase currents with the "
                      "ripple of the PWM, the same in the rotor's axes, and the error of the estimated angle."};
  Panel emf{.label = "back-EMF, V"};
  constexpr const char* kName[] = {"u", "v", "w"};
  constexpr const char* kColor[] = {palette::kU, palette::kV, palette::kW};
  for (std::size_t k = 0; k < 3; ++k) {
    emf.curves.push_back(curves(kName[k], kColor[k], [k](const Sample& s) { return s.plant.emf[k]; }, 1.2));
  }
  f.panels = {emf, curves.phases(), curves.axes(), curves.angle_error()};
  return f;
}

Figure load_step(const Samples& samples, double from, double to) {
  const double margin = 0.25 * (to - from);
  const Curves curves(samples, 1, 0, from - margin, to + margin);
  Figure f{.name = "load_step", .title = "Load step", .axis = "time, s",
           .caption = "The load added and taken away again: speed, torque, currents, and the error of the estimated "
                      "angle, which would have to reach 90 degrees to lose the rotor."};
  f.panels = {curves.speeds(), curves.torques(), curves.axes(), curves.angle_error()};
  return f;
}

}  // namespace

std::vector<Figure> figures(const design::Settings& s, const Record& record) {
  constexpr std::size_t kFew = 4;  // fewer samples make no curve
  std::vector<Figure> all;
  if (record.overview.size() >= kFew) {
    all.push_back(whole_run(s, record));
    all.push_back(start(s, record));
  }
  if (record.lock.size() >= kFew) all.push_back(lock(record));
  if (record.steady.size() >= kFew) all.push_back(steady(record));
  const design::ScenarioSection& n = s.scenario;
  if (n.load_step_s && record.overview.size() >= kFew && record.simulated_s > *n.load_step_s) {
    all.push_back(load_step(record.overview, *n.load_step_s, n.load_off_s.value_or(n.duration_s)));
  }
  if (record.overview.size() >= kFew) all.push_back(power_figure(record.overview, events_of(s)));
  return all;
}

}  // namespace steplock::sinusoidal
