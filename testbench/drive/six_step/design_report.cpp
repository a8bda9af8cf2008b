#include "testbench/drive/six_step/design_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "model/design/bounds.hpp"
#include "model/design/budget.hpp"
#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/report/word_table.hpp"
#include "testbench/run/units.hpp"

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;

// One figure of the design, told once and shown twice.
struct Row {
  const char* key;
  double value;
  const char* unit;
  const char* about;
};

struct Group {
  const char* key;
  const char* title;
  std::vector<Row> rows;
};

bool per_second(const design::Settings& s) { return s.loop.form == design::LoopForm::kPerSecond; }

std::vector<Group> groups(const design::Settings& s, const design::Design& d) {
  const design::LoopParameters& loop = d.parameters.loop;
  const design::SpeedParameters& speed = d.parameters.speed;
  std::vector<Group> all;
  all.push_back({"motor", "motor and load",
                 {{"k_e", d.motor.k_e, "V s/rad", "back-EMF of two phases; torque per ampere"},
                  {"r_loop", d.motor.r_loop, "ohm", "two phases and two switches"},
                  {"inertia", d.motor.inertia, "kg m^2", "in total"},
                  {"tau_m", d.motor.tau_m, "s", "mechanical time constant"},
                  {"tau_e", d.motor.tau_e, "s", "electrical time constant"},
                  {"no_load_rpm", rpm(d.motor.no_load), "rpm", "bus voltage / K_e"},
                  {"rated_torque", d.rated_torque, "N m", "at rated current"}}});
  if (per_second(s)) {
    const design::Components& c = d.components;
    all.push_back({"filter", "loop filter, per second: Eqs. (5)-(17)",
                   {{"c1", c.c1, "F", ""},
                    {"c2", c.c2, "F", ""},
                    {"r", c.r, "ohm", ""},
                    {"k_l", d.k_l, "", "loop gain K_p K_v / N"},
                    {"omega_z", c.omega_z(), "rad/s", "zero"},
                    {"omega_g", c.omega_g(), "rad/s", "crossover"},
                    {"omega_p", c.omega_p(), "rad/s", "pole"}}});
  }
  const bool seconds = per_second(s);
  all.push_back({"loop", "phase-locked loop",
                 {{"integral", loop.integral, seconds ? "1/s^2" : "1/step", ""},
                  {"proportional", loop.proportional, seconds ? "1/s" : "1/step", ""},
                  {"pole", loop.pole, seconds ? "rad/s" : "1/step", ""},
                  {"crossover", d.continuous.crossover, seconds ? "rad/s" : "rad/step", ""},
                  {"phase_margin_deg", d.continuous.phase_deg, "deg", "of the equations"},
                  {"sampled_phase_margin_deg", d.sampled.phase_deg, "deg",
                   "as the drive computes it, at hand-over"},
                  {"sampled_gain_margin_db", d.sampled.gain_db, "dB", "likewise"}}});
  const auto& start = d.parameters.start;
  if (start.method == design::Method::kFollow) {
    all.push_back({"start", "start: following the rotor",
                   {{"look", start.look, "s", "gates off, until no current flows"},
                    {"probe", start.probe, "s", "a drive between two looks"},
                    {"still", double(start.still), "", "looks without news, until the field moves on"},
                    {"hand_over_rpm", d.hand_over_rpm, "rpm", ""},
                    {"start_current", d.start_current, "A", "beyond the limit, which therefore rules"}}});
  } else {
    all.push_back({"start", "start: Eqs. (18)-(23)",
                   {{"kappa", d.kappa, "N m/rad", "stiffness at the aligned position"},
                    {"align_time_formula", d.align_time_formula, "s", "Eq. (22)"},
                    {"align_time", d.parameters.start.align, "s", "as used"},
                    {"pre_align_time", d.parameters.start.pre_align, "s", "as used"},
                    {"acceleration_time", d.acceleration_time, "s", "to hand-over"},
                    {"hand_over_rpm", d.hand_over_rpm, "rpm", ""},
                    {"ramp_rpm_s", d.ramp_rpm_s, "rpm/s", ""},
                    {"align_current", d.align_current, "A", ""},
                    {"start_current", d.start_current, "A", ""}}});
  }
  all.push_back({"speed", "speed control",
                 {{"kp", speed.kp, "1/(step/s)", "duty per error"},
                  {"ki", speed.ki, "1/step", "duty per error and second"},
                  {"slew_rpm_s", design::rpm_of(s, speed.slew), "rpm/s", ""},
                  {"duty_slew", speed.duty_slew, "1/s", ""}}});
  const design::StartBounds bounds = design::start_bounds(s);
  all.push_back({"bounds", "bounds of a start: beyond one of them it is rough",
                 {{"current", bounds.current_a, "A", "of any phase"},
                  {"kick_deg", bounds.kick_deg, "deg", "electrical, backwards from rest"},
                  {"speed", bounds.speed, "", "over the set speed, from rest"},
                  {"lock", bounds.lock_s, "s", "from `run`"}}});
  return all;
}

Json finite(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Figure bode_plot(const design::Settings& s, const design::Design& d) {
  const bool seconds = per_second(s);
  const design::LoopParameters& loop = d.parameters.loop;
  const int updates = loop.detector == design::Detector::kOncePerTurn ? 6 : 1;
  const design::PerSecond filter{loop.integral, loop.proportional, loop.pole};
  const design::Response equations =
      seconds ? design::open_loop(filter)
              : design::open_loop(design::PerStep{loop.integral, loop.proportional, loop.pole, updates});
  const double middle = d.continuous.crossover > 0 ? d.continuous.crossover : 1;
  const double lowest = middle / 100, highest = seconds ? middle * 100 : 3.14;

  Figure f{.name = "bode",
           .title = s.drive.name + ": open loop",
           .axis = seconds ? "omega, rad/s" : "omega, rad per step",
           .caption = "Open loop of the phase-locked loop.",
           .logarithmic = true};
  const auto add = [&](const design::Response& response, const char* name, const char* color,
                       double high) {
    Curve gain{name, color, {}, 1.6}, phase{name, color, {}, 1.6};
    for (const design::BodePoint& p : design::bode(response, lowest, high, 400)) {
      gain.points.push_back({p.omega, p.gain_db});
      phase.points.push_back({p.omega, p.phase_deg});
    }
    f.panels[0].curves.push_back(gain);
    f.panels[1].curves.push_back(phase);
  };
  f.panels = {{.label = "gain, dB", .weight = 1.6}, {.label = "phase, degrees", .weight = 1.6}};
  add(equations, seconds ? "Eqs. (1)-(4)" : "per step", palette::kTrue, highest);
  if (seconds) {
    const double interval = updates / d.parameters.start.hand_over;
    const double tick = d.parameters.pwm.tick();
    const double nyquist = std::numbers::pi / std::max(interval, tick);
    add(design::open_loop_sampled(filter, tick, interval), "as sampled at hand-over",
        palette::kDrive, std::min(highest, nyquist));
  }
  if (d.continuous.crossover > 0) {
    f.marks.push_back({d.continuous.crossover,
                       fmt::format("crossover, margin {:.1f} deg", d.continuous.phase_deg)});
  }
  return f;
}

}  // namespace

DesignReport design_report(const design::Settings& s) {
  const design::Design d = design::design_drive(s);
  const design::Quantised q = design::quantise(d.parameters, s.control.clock_hz);
  const design::Budget budget = design::error_budget(s, d, q.config);

  DesignReport r;
  r.bode = bode_plot(s, d);
  r.json["drive"] = s.drive.name;
  r.text = s.drive.name + "\n";
  for (const Group& group : groups(s, d)) {
    r.text += fmt::format("\n{}\n", group.title);
    for (const Row& row : group.rows) {
      r.text += fmt::format("  {:<26}{:>13.6g} {:<12}{}\n", row.key, row.value, row.unit, row.about);
      r.json[group.key][row.key] = finite(row.value);
    }
  }
  r.text += word_table(q.rows);
  r.json["config"] = word_table_json(q.rows);
  const auto rows = [&](const char* key, const char* title,
                        const std::vector<design::BudgetRow>& list) {
    r.text += fmt::format("\n{}\n", title);
    r.json[key] = Json::array();
    for (const design::BudgetRow& b : list) {
      r.text += fmt::format("  {:<34}rms {:>10.4g}   bound {:>10.4g} {}\n", b.name, b.rms, b.bound,
                            b.unit);
      r.json[key].push_back({{"name", b.name}, {"unit", b.unit}, {"rms", finite(b.rms)},
                             {"bound", finite(b.bound)}});
    }
  };
  rows("budget_in", "error budget: what blurs a crossing's place", budget.in);
  rows("budget_out", "error budget: how far apart fixed and float may be", budget.out());
  return r;
}

}  // namespace steplock
