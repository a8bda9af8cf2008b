// What makes the speed of Figs. 4 and 5 of Matsui 1996 swing where it is slow: one cause at a time is taken away.
#include <fmt/format.h>

#include <algorithm>

#include "model/design/sinusoidal/design.hpp"
#include "testbench/paper/matsui1996.hpp"

namespace steplock::matsui1996 {
namespace {

constexpr int kSeeds = 5;  // of the ADCs' noise: what hunts does not hunt twice alike

struct Without {
  std::string what;
  double i_gamma = 0, torque = 0;  // A; of the rated one
  void (*change)(design::Settings&, const design::sinusoidal::Design&) = nullptr;
};

const std::vector<Without>& all() {
  using S = design::Settings;
  using D = design::sinusoidal::Design;
  static const std::vector<Without> some = {
      {"as above"},
      {"gamma current of 0.8 A", 0.8},
      {"a fifth of the rated torque", 0, 0.2},
      {"dead time of 0.5 us", 0, 0, [](S& s, const D&) { s.inverter.dead_time_s = 0.5e-6; }},
      {"dead time not made up for", 0, 0, [](S& s, const D&) { s.sinusoidal.compensate = false; }},
      {"ADCs without noise", 0, 0, [](S& s, const D&) { s.adc.current_noise_a = 0; }},
      {"speed control half as fast", 0, 0, [](S& s, const D& d) { s.sinusoidal.speed_bandwidth_rad_s = d.speed_bandwidth / 2; }},
      {"angle correction a quarter as strong", 0, 0, [](S& s, const D&) { s.sinusoidal.angle_gain /= 4; }}};
  return some;
}

std::string two_digits(double percent) { return percent < 99.5 ? fmt::format("{:.2g}", percent) : fmt::format("{:.0f}", percent); }

struct Swings {
  std::vector<double> percent = {};  // of those that are held, from least to greatest
  double median() const { return percent.empty() ? 0 : percent[percent.size() / 2]; }
  int lost() const { return kSeeds - static_cast<int>(percent.size()); }
  std::string told() const {
    if (percent.empty()) return "**lost**";
    return fmt::format("{} ({} to {}){}", two_digits(median()), two_digits(percent.front()), two_digits(percent.back()),
                       lost() > 0 ? fmt::format(", {} **lost**", lost()) : "");
  }
};

Swings swings_of(const design::Settings& drive, const Without& without, EngineKind engine, design::Estimator estimator, double rpm,
                 const PaperOptions& options) {
  design::Settings s = drive;
  if (without.change != nullptr) without.change(s, design::sinusoidal::design_drive(drive));
  Swings all;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    s.sensors.seed = seed;
    const Case c{.engine = engine, .estimator = estimator, .rpm = rpm, .i_gamma = without.i_gamma, .torques = {without.torque}};
    const Point p = measure(s, s, c, options, fmt::format("{:g} r/min, {}", rpm, without.what)).front();
    if (p.held) all.percent.push_back(p.swing_percent());
  }
  std::ranges::sort(all.percent);
  return all;
}

}  // namespace

PaperSection causes_of_the_swing(const design::Settings& drive, const PaperOptions& options) {
  constexpr double kVoltage = 100, kCurrent = 35;  // r/min, the paper's slowest
  std::string table = fmt::format(
      "\n\n| what is other | voltage model, {:g} r/min: `fixed` | `float` | current model, {:g} r/min: `fixed` | `float` |\n"
      "|---|---|---|---|---|\n",
      kVoltage, kCurrent);
  double as_it_is = 0, short_dead_time = 0;
  int lost[2] = {};  // of the current model as above, by engine
  for (const Without& without : all()) {
    table += fmt::format("| {} |", without.what);
    for (const auto& [estimator, rpm] : {std::pair{design::Estimator::kVoltage, kVoltage}, {design::Estimator::kCurrent, kCurrent}}) {
      for (const EngineKind engine : {EngineKind::kFixed, EngineKind::kFloat}) {
        const Swings s = swings_of(drive, without, engine, estimator, rpm, options);
        table += fmt::format(" {} |", s.told());
        if (without.what == "as above" && rpm == kCurrent) lost[engine == EngineKind::kFloat] = s.lost();
        if (rpm != kVoltage || engine != EngineKind::kFixed) continue;
        if (without.what == "as above") as_it_is = s.median();
        if (without.what.starts_with("dead time of")) short_dead_time = s.median();
      }
    }
    table += "\n";
  }
  const double lost_v = drive.inverter.dead_time_s * drive.control.pwm_hz * drive.inverter.bus_v;
  const double emf_v = drive.motor.flux_vs * design::sinusoidal::speed_of(drive, kVoltage);  // of a phase
  PaperSection s{
      .title = "What swings at low speed",
      .text = fmt::format(
          "The slowest points of the paper again, without load and without gamma current; one thing at a time is another. Swing of the "
          "true speed about its mean, peak to peak, in % of the speed: of {} runs with other noise of the ADCs the median of what is "
          "held, and the least and the greatest. It is no matter of the arithmetic: the reference in doubles swings as well. What swings "
          "is dead time where the currents are near zero: which of two diodes then holds a terminal nobody measures. {:g} us in a period "
          "take {:.1f} V from a phase whose EMF has a peak of {:.1f} V at {:g} r/min. With an eighth of the dead time {:.2g} % are left "
          "of {:.2g}. A gamma current moves the currents out of that band and costs copper alone; torque does the same. At {:g} r/min "
          "{}.{}",
          kSeeds, 1e6 * drive.inverter.dead_time_s, lost_v, emf_v, kVoltage, short_dead_time, as_it_is, kCurrent,
          lost[0] + lost[1] == 0
              ? std::string("every run of the first row holds")
              : fmt::format("the noise decides whether the lock lasts: `fixed` loses {} of its {} runs, `float` {}", lost[0], kSeeds,
                            lost[1]),
          table)};
  if (!(short_dead_time < as_it_is / 2)) s.failures.push_back("dead time as what makes the speed swing");
  return s;
}

}  // namespace steplock::matsui1996
