#include "testbench/drive/six_step/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "testbench/report/events.hpp"
#include "testbench/report/power_figure.hpp"
#include "testbench/run/timeline.hpp"
#include "testbench/run/units.hpp"

namespace steplock {
namespace {

using Samples = std::vector<Sample>;

constexpr std::array kPhaseColor = {palette::kU, palette::kV, palette::kW};
constexpr std::array kPhaseName = {"u", "v", "w"};

template <class F>
std::vector<Point> points(const Samples& samples, double scale, double origin, F&& y) {
  std::vector<Point> all;
  all.reserve(samples.size());
  for (const Sample& s : samples) all.push_back({(s.time - origin) * scale, y(s)});
  return outlined(all);
}

// Phase current, rms between neighbouring points of the figure.
std::vector<Point> rms_current(const Samples& samples) {
  std::vector<Point> all;
  const std::size_t stride = std::max<std::size_t>(1, samples.size() / 600);
  for (std::size_t i = stride; i < samples.size(); i += stride) {
    const Sample &a = samples[i - stride], &b = samples[i];
    const double square = (b.totals.current_squared - a.totals.current_squared) / (b.time - a.time);
    all.push_back({b.time, std::sqrt(std::max(0.0, square))});
  }
  return all;
}

Panel speeds(const Samples& samples, int pole_pairs, double scale, double origin) {
  double way = 1;
  return {.label = "speed, rpm",
          .curves = {{"drive's own", palette::kDrive, points(samples, scale, origin, [&](const Sample& s) {
                        // The drive knows no sign; it is the rotor's wherever the rotor turns.
                        if (std::abs(s.plant.speed) > 0.5) way = s.plant.speed < 0 ? -1 : 1;
                        return way * rpm_of_steps(s.drive.steps_per_second, pole_pairs);
                      })},
                     {"rotor", palette::kTrue,
                      points(samples, scale, origin, [](const Sample& s) { return rpm(s.plant.speed); })}},
          .weight = 1.3};
}

Panel currents(const Samples& samples, double scale, double origin) {
  Panel panel{.label = "phase current, A"};
  for (std::size_t k = 0; k < 3; ++k) {
    panel.curves.push_back({kPhaseName[k], kPhaseColor[k],
                            points(samples, scale, origin,
                                   [k](const Sample& s) { return s.plant.current[k]; }),
                            1.1});
  }
  return panel;
}

Panel phase_errors(const Samples& samples, double scale, double origin) {
  Panel panel{.label = "degrees",
              .curves = {{"phase detector", palette::kDrive,
                          points(samples, scale, origin,
                                 [](const Sample& s) { return s.drive.phase_error_deg; }),
                          1.2, true}}};
  // Judged from the first commutation behind the lock: before it there is no error, not one of 0.
  const auto lock = std::ranges::find_if(samples, [](const Sample& s) { return s.watch.locked(); });
  const auto first = std::find_if(lock, samples.end(), [&](const Sample& s) { return s.watch.step() != lock->watch.step(); });
  if (const Samples judged(first, samples.end()); !judged.empty()) {
    panel.curves.push_back({"commutation late", palette::kTrue,
                            points(judged, scale, origin, [](const Sample& s) { return s.commutation_error_deg; }),
                            1.2, true});
  }
  return panel;
}

Figure whole_run(const design::Settings& s, const Record& record) {
  Figure f{.name = "start", .title = s.drive.name + ": from standstill to stop", .axis = "time, s",
           .caption = "The whole scenario: speed as the drive measures it and as the rotor turns, phase "
                      "current, duty, and the state of the start sequence."};
  f.panels.push_back(speeds(record.overview, s.motor.pole_pairs, 1, 0));
  f.panels.push_back({.label = "current, A rms",
                      .curves = {{"phase", palette::kU, rms_current(record.overview)}}});
  f.panels.push_back({.label = "duty, %",
                      .curves = {{"duty", palette::kW, points(record.overview, 1, 0, [](const Sample& x) {
                                    return 100 * x.drive.duty;
                                  })}}});
  f.panels.push_back({.label = "state",
                      .curves = {{"", palette::kTrue, points(record.overview, 1, 0, [](const Sample& x) {
                                    return static_cast<double>(x.watch.state());
                                  }), 1.4, true}},
                      .weight = 1.2,
                      .range = {{-0.5, 10.5}},
                      .ticks = {{0, "idle"}, {1, "detect spin"}, {2, "brake"}, {3, "pre-align"}, {4, "align"}, {5, "accelerate"},
                                {6, "pull in"}, {7, "run"}, {8, "slow down"}, {9, "retry delay"}, {10, "fault"}}});
  f.marks = events_of(s);
  return f;
}

Figure lock(const design::Settings& s, const Summary& sum, const Record& record) {
  const double origin = record.lock.front().time;
  Figure f{.name = "lock", .title = "Hand-over and lock", .axis = "time after hand-over, ms",
           .caption = "From the last steps of the start to the closed phase-locked loop. Commutation errors are "
                      "judged from the plant's true angle, once the drive claims a lock."};
  f.panels.push_back(speeds(record.lock, s.motor.pole_pairs, 1e3, origin));
  f.panels.push_back(currents(record.lock, 1e3, origin));
  f.panels.push_back(phase_errors(record.lock, 1e3, origin));
  if (sum.lock_time_s && *sum.lock_time_s >= origin &&
      *sum.lock_time_s <= record.lock.back().time) {
    f.marks.push_back({1e3 * (*sum.lock_time_s - origin), "locked"});
  }
  return f;
}

Figure steady(const Record& record) {
  const double origin = record.steady.front().time;
  const auto curve = [&](const char* title, const char* color, double width, auto&& y) {
    return Curve{title, color, points(record.steady, 1e3, origin, y), width};
  };
  Figure f{.name = "steady", .title = "Two electrical turns at set speed", .axis = "time, ms",
           .caption = "The last two electrical turns before the first disturbance: back-EMF, currents, "
                      "one terminal against the comparators' reference, and the six gates."};
  Panel emf{.label = "back-EMF, V"}, voltage{.label = "terminal u, V"};
  for (std::size_t k = 0; k < 3; ++k) {
    emf.curves.push_back(curve(kPhaseName[k], kPhaseColor[k], 1.2,
                               [k](const Sample& s) { return s.plant.emf[k]; }));
  }
  voltage.curves = {curve("terminal", palette::kU, 0.7, [](const Sample& s) { return s.plant.voltage[0]; }),
                    curve("reference", palette::kQuiet, 0.7,
                          [](const Sample& s) { return s.plant.virtual_neutral; })};
  f.panels = {emf, currents(record.steady, 1e3, origin), voltage};

  Panel gates{.label = "gates", .weight = 1.4,
              .range = {{-0.4, 6.2}},
              .ticks = {{5.3, "uh"}, {4.3, "ul"}, {3.3, "vh"}, {2.3, "vl"}, {1.3, "wh"}, {0.3, "wl"}}};
  for (int i = 0; i < 6; ++i) {
    gates.curves.push_back(curve("", kPhaseColor[static_cast<std::size_t>(i / 2)], 0.8,
                                 [i](const Sample& s) {
                                   return (5 - i) + 0.7 * static_cast<double>(s.watch.bits >> i & 1);
                                 }));
    gates.curves.back().steps = true;
  }
  f.panels.push_back(gates);
  return f;
}

Figure load_step(const design::Settings& s, const Samples& samples) {
  Figure f{.name = "load_step", .title = "Load step", .axis = "time, s",
           .caption = "Half the rated torque added and taken away again: speed, torque, current, and the "
                      "phase error that would have to reach 30 degrees to lose the rotor."};
  f.panels.push_back(speeds(samples, s.motor.pole_pairs, 1, 0));
  f.panels.push_back({.label = "torque, N m",
                      .curves = {{"motor", palette::kW, points(samples, 1, 0, [](const Sample& x) {
                                    return x.plant.torque;
                                  }), 0.9},
                                 {"load", palette::kTrue, points(samples, 1, 0, [](const Sample& x) {
                                    return x.load_nm;
                                  })}}});
  f.panels.push_back(
      {.label = "current, A rms", .curves = {{"phase", palette::kU, rms_current(samples)}}});
  f.panels.push_back(phase_errors(samples, 1, 0));
  return f;
}

}  // namespace

std::vector<Figure> run_figures(const design::Settings& s, const Summary& sum, const Record& record) {
  std::vector<Figure> all;
  constexpr std::size_t kFew = 4;  // fewer samples make no curve
  if (record.overview.size() >= kFew) all.push_back(whole_run(s, record));
  if (record.lock.size() >= kFew) all.push_back(lock(s, sum, record));
  if (record.steady.size() >= kFew) all.push_back(steady(record));
  const design::ScenarioSection& n = s.scenario;
  if (n.load_step_s) {
    const double to = n.load_off_s.value_or(n.duration_s);
    const double margin = 0.25 * (to - *n.load_step_s);
    Samples around;
    std::ranges::copy_if(record.overview, std::back_inserter(around), [&](const Sample& x) {
      return x.time >= *n.load_step_s - margin && x.time <= to + margin;
    });
    if (around.size() >= kFew) all.push_back(load_step(s, around));
  }
  if (record.overview.size() >= kFew) all.push_back(power_figure(record.overview, events_of(s)));
  return all;
}

}  // namespace steplock
