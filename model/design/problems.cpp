// What makes no sense in a drive's settings: each line names the key and says how to mend it.
#include <cmath>
#include <sstream>
#include <tuple>
#include <type_traits>

#include "model/design/design.hpp"
#include "model/design/settings_keys.hpp"
#include "model/design/sinusoidal/design.hpp"
#include "model/design/config.hpp"

namespace steplock::design {
namespace {

class Findings {
 public:
  template <class... Parts>
  void add(const Parts&... parts) {
    std::ostringstream line;
    (line << ... << parts);
    lines.push_back(line.str());
  }
  std::vector<std::string> lines;
};

void check_range(Findings& found, const Key& key, double value) {
  if (value >= key.low && value <= key.high) return;
  found.add(key.section, ".", key.name, " is ", value, key.unit.empty() ? "" : " ", key.unit,
            "; must be within ", key.low, " .. ", key.high);
}

void check_ranges(Findings& found, const Settings& s) {
  for_each_key(s, [&](const Key& key, const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, int>) {
      check_range(found, key, value);
    } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
      if (value) check_range(found, key, *value);
    } else if constexpr (std::is_same_v<Value, std::vector<double>> ||
                         std::is_same_v<Value, std::array<double, 2>> ||
                         std::is_same_v<Value, std::array<double, 3>>) {
      for (const double v : value) check_range(found, key, v);
    } else if constexpr (std::is_same_v<Value, std::string>) {
      if (key.required && value.empty()) {
        found.add(key.section, ".", key.name, " is empty; write ", key.about);
      }
    }
  });
}

void check_assumed(Findings& found, const Settings& s) {
  for (const auto& line : s.drive.assumed) {
    const auto colon = line.find(':');
    const std::string name = line.substr(0, colon);
    bool known = false;
    for_each_key(s, [&](const Key& key, const auto&) {
      known |= name == std::string(key.section) + "." + std::string(key.name);
    });
    if (!known) found.add("drive.assumed names \"", name, "\"; must begin with a key, section.key");
    if (colon == std::string::npos || colon + 2 >= line.size()) {
      found.add("drive.assumed gives no reason for \"", name, "\"; write \"", name, ": reason\"");
    }
  }
}

// What turns, of either kind of drive.
void check_mechanics(Findings& found, const Settings& s) {
  if (s.load.wind_rpm != 0 && s.load.fan_nms2 == 0) {
    found.add("load.wind_rpm is ", s.load.wind_rpm, " and load.fan_nms2 is 0; wind turns a fan, give it one");
  }
  if (s.load.spring_nm_rad > 0 && s.load.inertia_kgm2 == 0) {
    found.add("load.spring_nm_rad is ", s.load.spring_nm_rad, " and load.inertia_kgm2 is 0; a spring needs an inertia behind it");
  }
  if (s.motor.static_nm && *s.motor.static_nm < s.motor.coulomb_nm) {
    found.add("motor.static_nm is ", *s.motor.static_nm, " N m; must be at least coulomb_nm");
  }
}

void check_control(Findings& found, const Settings& s) {
  const auto& c = s.control;
  const double settled = (c.chopping == Chopping::kComplementary ? s.inverter.dead_time_s : 0) +
                         s.sensors.comparator_delay_s + 3 / c.clock_hz;
  if (c.blanking_s < settled) {
    found.add("control.blanking_s is ", c.blanking_s, " s; must be at least ", settled,
              " s: dead time, comparator delay and three clocks");
  }
  if (c.pwm_hz > 0 && 4 * c.blanking_s > 1 / c.pwm_hz) {
    found.add("control.blanking_s is ", c.blanking_s,
              " s; must be below a quarter of the PWM period");
  }
  if (c.clock_hz < 200 * c.pwm_hz) {
    found.add("control.pwm_hz is ", c.pwm_hz, " Hz; must leave 200 clocks per period, at most ",
              c.clock_hz / 200);
  }
  if (s.sensors.reference == Reference::kHalfBus && c.sampling != Sampling::kOnTime) {
    found.add("sensors.reference is half_bus; the star point stands there in the on-time alone: write control.sampling = \"on_time\"");
  }
  if (s.speed.minimum_duty >= s.speed.maximum_duty) {
    found.add("speed.minimum_duty is ", s.speed.minimum_duty, "; must be below maximum_duty, ",
              s.speed.maximum_duty);
  }
  if (s.motor.shape == Shape::kTable && s.motor.table.size() < 8) {
    found.add("motor.table has ", s.motor.table.size(), " values; must have at least 8");
  }
}

void check_speeds(Findings& found, const Settings& s, const Design& d) {
  const auto& p = d.parameters;
  const double set = s.scenario.speed_rpm, no_load = d.motor.no_load * 30 / 3.14159265358979;
  if (set > 0.95 * no_load) {
    found.add("scenario.speed_rpm is ", set, " rpm; must be below ", 0.95 * no_load,
              " rpm, 95 % of what the bus voltage allows");
  }
  if (d.hand_over_rpm > 0.9 * set) {
    found.add("start.hand_over_rpm is ", d.hand_over_rpm,
              " rpm; must be below 90 % of the set speed");
  }
  if (p.loop.minimum >= p.start.hand_over) {
    found.add("loop.minimum_rpm is ", rpm_of(s, p.loop.minimum), " rpm; must be below hand-over");
  }
  if (p.loop.maximum < 1.05 * p.speed.target) {
    found.add("loop.maximum_rpm is ", rpm_of(s, p.loop.maximum),
              " rpm; must be 5 % above the set speed");
  }
  // docs/range.md: what of a step the comparators may take until a crossing is believed, and what clocks the blocks need.
  constexpr double kMostOfAStep = 0.36, kLeastClocks = 170;
  const double step = 1 / p.speed.target, looks = p.bemf.blanking + p.bemf.samples * p.bemf.sample_every;
  if (p.source == Source::kBemf && looks > kMostOfAStep * step) {
    found.add("scenario.speed_rpm is ", set, " rpm, a step of ", step, " s, of which control.blanking_s and control.samples of sample_every_s take ", looks,
              " s; must be at most ", kMostOfAStep * step, " s: lower them, or the speed to ", set * kMostOfAStep * step / looks);
  }
  if (step * s.control.clock_hz < kLeastClocks) {
    found.add("scenario.speed_rpm is ", set, " rpm, a step of ", step * s.control.clock_hz, " clocks; must be at least ", kLeastClocks,
              ": raise control.clock_hz to ", kLeastClocks / step, ", or lower the speed");
  }
  const double slowest = 1.1 * rpm_of(s, std::max(p.loop.minimum, p.protection.stall)), fastest = rpm_of(s, p.loop.maximum) / 1.05;
  for (const double speed : s.scenario.set_speed_rpm) {
    if (speed < slowest || speed > fastest) {
      found.add("scenario.set_speed_rpm has ", speed, " rpm; must be from ", slowest, " to ", fastest,
                " rpm, what the loop follows and is no stall");
    }
  }
  if (p.loop.form == LoopForm::kPerSecond && p.source == Source::kBemf &&
      d.sampled.phase_deg < 15) {
    found.add("start.hand_over_rpm is ", d.hand_over_rpm, " rpm; at that speed the loop has ",
              d.sampled.phase_deg, " degrees of phase margin, must be 15 or more: raise it");
  }
}

void check_start(Findings& found, const Settings& s, const Design& d) {
  const auto& p = d.parameters;
  for (const auto& [name, current] : {std::pair{"start.align_current_a", d.align_current},
                                      std::pair{"start.start_current_a", d.start_current}}) {
    const double least = (s.motor.coulomb_nm + s.load.opposing_nm) / d.motor.k_e;
    if (current <= least) {
      found.add(name, " is ", current, " A; must be above ", least, " A to overcome friction");
    }
    if (current >= s.sensors.limit_a && p.start.method == Method::kRamp) {
      found.add(name, " is ", current, " A; must be below sensors.limit_a, ", s.sensors.limit_a);
    }
  }
  if (p.limit.off_time > 0 && p.limit.off_time < least_off_time(s)) {
    found.add("control.limit_off_time_s is ", p.limit.off_time, " s; must be at least ", least_off_time(s),
              " s, or 0: in a quarter of it, with all gates off, the current falls by what it rose while the comparator was not believed; or lower control.limit_blanking_s");
  }
  if (p.start.align_duty * p.pwm.period < p.pwm.minimum) {
    found.add("control.minimum_pulse_s is ", p.pwm.minimum, " s; must be below the alignment pulse, ",
              p.start.align_duty * p.pwm.period, " s");
  }
}

void check_scenario(Findings& found, const Settings& s) {
  const auto& n = s.scenario;
  const auto between = [&](const char* name, const std::optional<double>& time, const char* before,
                           double least) {
    if (time && *time <= least) {
      found.add("scenario.", name, " is ", *time, " s; must come after ", before, ", ", least, " s");
    } else if (time && *time >= n.duration_s) {
      found.add("scenario.", name, " is ", *time, " s; must come before duration_s, ", n.duration_s,
                " s");
    }
  };
  if (n.run_s >= n.duration_s) {
    found.add("scenario.run_s is ", n.run_s, " s; must come before duration_s, ", n.duration_s, " s");
  }
  between("load_step_s", n.load_step_s, "run_s", n.run_s);
  between("load_off_s", n.load_off_s, "load_step_s", n.load_step_s.value_or(n.run_s));
  between("inertia_step_s", n.inertia_step_s, "run_s", n.run_s);
  between("reverse_s", n.reverse_s, "run_s", n.run_s);
  between("stop_s", n.stop_s, "run_s", n.run_s);
  for (const auto& [name, times, other, values] : {std::tuple{"set_speed_s", &n.set_speed_s, "set_speed_rpm", &n.set_speed_rpm},
                                                   std::tuple{"load_s", &n.load_s, "load_nm", &n.load_nm}}) {
    if (times->size() != values->size()) {
      found.add("scenario.", name, " has ", times->size(), " values; must have as many as ", other, ", ", values->size());
    }
    double before = n.run_s;
    for (const double t : *times) {
      between(name, t, before == n.run_s ? "run_s" : "the time before it", before);
      before = t;
    }
  }
  if (!n.load_s.empty() && n.load_step_s) {
    found.add("scenario.load_s is set beside load_step_s; write the step into load_s and load_nm");
  }
  if (n.load_off_s && !n.load_step_s) {
    found.add("scenario.load_off_s is set without load_step_s; add load_step_s");
  }
}

void check_envelope(Findings& found, const Settings& s) {
  const auto& v = s.envelope;
  for (const auto& [name, range] :
       {std::pair{"inertia", v.inertia}, std::pair{"bus", v.bus},
        std::pair{"resistance", v.resistance}, std::pair{"inductance", v.inductance},
        std::pair{"flux", v.flux}, std::pair{"offset", v.offset}, std::pair{"noise", v.noise},
        std::pair{"delay", v.delay}, std::pair{"speed", v.speed}}) {
    if (range[0] > range[1]) {
      found.add("envelope.", name, " is from ", range[0], " to ", range[1],
                "; must not fall: write the lower end first");
    }
  }
  if (const auto& r = s.hardship.spring_hz; r[0] > r[1]) {
    found.add("hardship.spring_hz is from ", r[0], " to ", r[1], "; must not fall: write the lower end first");
  }
  if (const auto& r = s.disturbance.set_speed; r[0] > r[1]) {
    found.add("disturbance.set_speed is from ", r[0], " to ", r[1],
              "; must not fall: write the lower end first");
  }
  if (v.load.empty() && v.fan == 0) {
    found.add("envelope.load is empty, and there is no fan; must name one load, 0 for none");
  }
}

// The nearest below that is written with three digits.
double rounded_down(double value) {
  const double digit = std::pow(10, std::floor(std::log10(value)) - 2);
  return std::floor(value / digit) * digit;
}

// How large a gain its word holds goes by the clock: between one and two times, and back again with each doubling of it.
bool check_speed_gain(Findings& found, const Settings& s, const Design& d) {
  const double kp = d.parameters.speed.kp, most = most_duty_per_speed(d.parameters.loop, s.control.clock_hz);
  const auto& v = s.speed;
  if (kp <= most || (!v.kp_duty_per_rpm && !v.bandwidth_rad_s)) return true;
  const char* key = v.kp_duty_per_rpm ? "kp_duty_per_rpm" : "bandwidth_rad_s";
  const double value = v.kp_duty_per_rpm ? *v.kp_duty_per_rpm : *v.bandwidth_rad_s;
  found.add("speed.", key, " is ", value, "; at most ", rounded_down(value * most / kp), " at a clock of ",
            s.control.clock_hz / 1e6, " MHz, where the word of the gain ends");
  return false;
}

}  // namespace

std::vector<std::string> problems(const Settings& s) {
  Findings found;
  check_ranges(found, s);
  check_assumed(found, s);
  check_mechanics(found, s);
  check_scenario(found, s);
  check_envelope(found, s);
  if (!found.lines.empty()) return found.lines;  // the rest divides by what may be zero
  if (s.drive.kind == DriveKind::kSinusoidal) return sinusoidal::problems(s);
  check_control(found, s);
  const Design d = design_drive(s);
  check_speeds(found, s, d);
  check_start(found, s, d);
  const bool gain_fits = check_speed_gain(found, s, d);
  for (const auto& line : quantise(d.parameters, s.control.clock_hz).problems) {
    if (gain_fits || !line.starts_with("speed.kp ")) found.lines.push_back(line);
  }
  return found.lines;
}

}  // namespace steplock::design
