// See config.hpp for the full scales; formats are those of hls/sinusoidal/config.hpp.
#include "model/design/sinusoidal/config.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

#include "model/design/quantiser.hpp"

namespace steplock::design::sinusoidal {
namespace {

constexpr double kPi = std::numbers::pi;
const double kRoot = std::sqrt(1.5);  // a vector's length of a phase's peak

struct Scales {
  double clock, period, current, voltage, speed;  // s, s, A, V, rad/s
};

Scales scales(const Settings& s) {
  const double period = 1 / s.control.pwm_hz;
  return {.clock = 1 / s.control.clock_hz,
          .period = period,
          .current = current_range(s),
          .voltage = voltage_range(s),
          .speed = 2 * kPi / 16 / period};
}

// Words with so many bits behind the point; `scale` is what 1 stands for.
class ScaledQuantiser {
 public:
  explicit ScaledQuantiser(Quantised& q) : word_(q.config, q.rows, q.problems) {}

  Word operator()(const char* name, const char* unit, double wanted, double scale, int fraction,
                  int bits) {
    return word_(name, unit, wanted, std::ldexp(scale, -fraction), bits);
  }
  void periods(const char* name, double seconds, const Scales& f) { (*this)(name, "s", seconds, f.period, 0, 20); }
  void choose(const char* name, bool choice) { word_.choose(name, choice); }

 private:
  Quantiser word_;
};

void bridge_config(ScaledQuantiser& word, const Parameters& p, const Settings& s, const Scales& f) {
  word.choose("bridge.compensate", p.applied.compensate);
  word.choose("bridge.sine_pwm", p.pwm.modulation == Modulation::kSine);
  const Word period = word("bridge.period", "s", p.pwm.period, f.clock, 0, 14);
  // The guard's floor is dead time that is really there.
  const double dead = std::max(p.pwm.dead_time, kDeadTimeFloor * f.clock);
  word("bridge.dead_time", "s", dead, f.clock, 0, 8);
  // A pulse shorter than its dead time would be none.
  word("bridge.minimum", "s", std::max(p.pwm.minimum, dead), f.clock, 0, 14);
  const double lost = dead * (1 + 2 * p.applied.diode_drop / s.inverter.bus_v);
  word("bridge.dead_time_loss", "s", lost, f.clock, 4, 12);
  word("bridge.reciprocal", "1/clocks", 1 / (3.0 * period), 1, 25, 15);
}

void estimator_config(ScaledQuantiser& word, const Parameters& p, const Scales& f) {
  const double per_voltage = p.pwm.period / p.motor.inductance_q;  // A/V
  const double turns = 2 * kPi / (kRoot * f.current);  // rad/A of a turn per full scale
  word.choose("estimator.voltage", p.estimator == Estimator::kVoltage);
  word.choose("estimator.average", p.voltage_model.samples != 1);
  word("estimator.decay", "", p.motor.resistance * per_voltage, 1, 15, 15);
  word("estimator.gain", "A/V", per_voltage, f.current / f.voltage, 13, 15);
  word("estimator.k_theta", "rad/A", p.current_model.k_theta, turns, 14, 15);
  word("estimator.k_e", "V/A", p.current_model.k_e, f.voltage / f.current, 13, 15);
  word("estimator.k_speed", "rad/V", p.pwm.period / p.motor.k_e, 2 * kPi / (kRoot * f.voltage), 17, 15);
  word("estimator.k_emf", "rad/A", p.motor.inductance_q / p.motor.k_e, turns, 15, 15);
  word("estimator.k_si", "rad/A", p.voltage_model.k_si * p.motor.inductance_q * p.pwm.period, turns, 23, 15);
}

void speed_config(ScaledQuantiser& word, const Parameters& p, const Scales& f) {
  const double current = kRoot * f.current, period = p.pwm.period;
  const auto speed = [&](const char* name, double w) { word(name, "rad/s", w, f.speed, 15, 15); };
  word("speed.target", "rad/s", p.speed.target, f.speed, 25, 25);
  word("speed.slew", "rad/s^2", p.speed.slew, f.speed / period, 25, 15);
  word("speed.filter", "per sample", -std::expm1(-p.speed.filter * period), 1, 15, 15);
  word("speed.k_p", "A/(rad/s)", p.speed.kp, current / f.speed, 8, 15);
  word("speed.k_i", "A/rad", p.speed.ki, current / f.speed / period, 17, 15);
  word("speed.limit", "A", p.speed.limit, current, 15, 15);
  word("speed.start_current", "A", p.speed.start_current, current, 15, 15);
  speed("speed.lock", p.start.lock_speed);
  speed("speed.slow", p.protection.slow_speed);
  speed("speed.stop", p.start.stop_speed);
  word("speed.emf_low", "", p.protection.emf_low, 1, 13, 15);
  word("speed.emf_high", "", p.protection.emf_high, 1, 13, 15);
}

void control_config(ScaledQuantiser& word, const Parameters& p, const Scales& f) {
  const double ohm = f.voltage / f.current;
  const bool sine = p.pwm.modulation == Modulation::kSine;
  const double longest = sine ? 0.5 : 1 / std::numbers::sqrt3;
  word("control.set_gamma", "A", p.current.i_gamma, kRoot * f.current, 15, 15);
  word("control.k_p", "V/A", p.current.kp_delta, ohm, 12, 15);
  word("control.k_i", "V/(A s)", p.current.ki_delta, ohm / p.pwm.period, 15, 15);
  word("control.inductance", "H", p.motor.inductance_q, ohm / f.speed, 10, 15);
  word("control.emf", "V s/rad", p.motor.k_e, kRoot * f.voltage / f.speed, 10, 15);
  word("control.limit", "", longest, 1, 15, 15);
}

// A pulse is chopped over whole periods, at most four fifths of them: the length that is wanted is
// the on-time of all together, each longer by the dead time that it loses.
struct PilotPlan {
  double short_periods, on_share, long_periods;
};

PilotPlan plan_pilot(const Parameters& p) {
  const double n = std::ceil(p.pilot.short_s / (0.8 * p.pwm.period));
  const double share = p.pilot.short_s / (n * p.pwm.period);
  return {n, share, std::max(n, std::round(p.pilot.long_s / (share * p.pwm.period)))};
}

void pilot_config(ScaledQuantiser& word, const Parameters& p, const Scales& f) {
  const Pilot& o = p.pilot;
  const PilotPlan plan = plan_pilot(p);
  // Half the rounds give one part of the sum, each of its six pulses as much as the saliency.
  const double sum = 3 * o.repeats * o.short_s * o.amperes_per_second;
  word("pilot.short_periods", "periods", plan.short_periods, 1, 0, 6);
  word("pilot.long_periods", "periods", plan.long_periods, 1, 0, 6);
  word("pilot.rounds", "", o.repeats, 1, 0, 5);
  word("pilot.decayed", "A", o.decayed, f.current, 15, 15);
  word("pilot.saliency", "A", o.least_saliency * sum, f.current, 15, 15);
  word("pilot.polarity", "A", o.least_polarity * 2 * o.long_s * o.amperes_per_second, f.current, 15, 15);
}

void sequence_config(ScaledQuantiser& word, const Parameters& p, const Settings& s, const Scales& f) {
  const Start& t = p.start;
  const bool pilot = t.by == StartBy::kPilot;
  const PilotPlan plan = plan_pilot(p);
  const double dead = std::max(p.pwm.dead_time, kDeadTimeFloor * f.clock);
  const double hold = pilot ? (plan.on_share + dead / p.pwm.period) * s.inverter.bus_v
                            : 1.5 * p.motor.resistance * t.pattern_current;
  // Each pulse with its decay and the samples between; and one that does not decay.
  const double pulses = 6 * p.pilot.repeats * (2 * plan.short_periods + 6) +
                        2 * (2 * plan.long_periods + 6) + 20;
  const double pattern = pilot ? pulses * p.pwm.period + p.pilot.decay_s : t.pattern_s / 3;
  word.choose("sequence.arbitrary", t.by == StartBy::kArbitrary);
  word.choose("sequence.pilot", pilot);
  word("sequence.hold_voltage", "V", hold, f.voltage, 15, 15);
  word.periods("sequence.pattern", pattern, f);
  word.periods("sequence.lock", t.lock_s, f);
  word.periods("sequence.give_up", t.give_up_s, f);
  word.periods("sequence.brake", t.brake_s, f);
  word.periods("sequence.retry_delay", t.retry_delay_s, f);
  word("sequence.retries", "", t.retries, 1, 0, 4);
}

void refuse_pilot(std::vector<std::string>& lines, const Settings& s, const Design& d) {
  const Pilot& o = d.parameters.pilot;
  const auto add = [&](const auto&... parts) {
    std::ostringstream line;
    (line << ... << parts);
    lines.push_back(line.str());
  };
  if (o.repeats % 2 != 0) {
    add("sinusoidal_start.pilot_repeats is ", o.repeats, "; must be even for this engine");
  }
  const double shortest = 2 * std::max(d.parameters.pwm.dead_time, d.parameters.pwm.minimum);
  if (o.short_s < shortest) {
    add("sinusoidal_start.pilot_short_s is ", o.short_s, " s; must be at least ", shortest,
        " s, twice the dead time and the shortest pulse");
  }
  // A quarter is left to what iron adds to the saliency.
  const double once = 3 * d.saliency * o.short_s * o.amperes_per_second;
  const double most = 0.75 * current_range(s);
  if (o.repeats * once > most) {
    add("sinusoidal_start.pilot_repeats is ", o.repeats, "; must be at most ",
        2 * int(most / once / 2), " for this engine, whose sum has the ADC's range");
  }
}

void refuse(std::vector<std::string>& lines, const Settings& s, const Design& d) {
  const auto& p = d.parameters;
  if (p.start.by == StartBy::kPilot) refuse_pilot(lines, s, d);
  if (s.control.clock_hz < kSampleClocks * s.control.pwm_hz) {
    std::ostringstream line;
    line << "control.pwm_hz is " << s.control.pwm_hz << " Hz; must be at most "
         << s.control.clock_hz / kSampleClocks << " Hz for this engine, which takes "
         << kSampleClocks << " clocks a sample";
    lines.push_back(line.str());
  }
  if (p.estimator == Estimator::kVoltage && p.voltage_model.samples != 1 &&
      p.voltage_model.samples != 8) {
    std::ostringstream line;
    line << "sinusoidal.moving_average is " << p.voltage_model.samples
         << "; must be 1 or 8 for this engine";
    lines.push_back(line.str());
  }
  if (s.adc.bits != 12) {
    std::ostringstream line;
    line << "adc.bits is " << s.adc.bits << "; must be 12 for this engine";
    lines.push_back(line.str());
  }
}

}  // namespace

Quantised quantise(const Settings& s) {
  Quantised q;
  const Design d = design_drive(s);
  const Parameters& p = d.parameters;
  refuse(q.problems, s, d);
  const Scales f = scales(s);
  ScaledQuantiser word(q);
  bridge_config(word, p, s, f);
  estimator_config(word, p, f);
  speed_config(word, p, f);
  control_config(word, p, f);
  sequence_config(word, p, s, f);
  if (p.start.by == StartBy::kPilot) pilot_config(word, p, f);
  const auto& g = p.protection;
  word("fault.over_current", "A", g.over_current, f.current, 15, 15);
  word.periods("fault.saturated", g.saturated_s, f);
  word.periods("fault.slow", g.slow_s, f);
  word.periods("fault.emf", g.emf_s, f);
  word("fault.lost_samples", "", g.lost_samples, 1, 0, 4);
  return q;
}

Word target_word(const Settings& s, double rpm) {
  const double word = std::round(std::ldexp(speed_of(s, rpm) / scales(s).speed, 25));
  return Word(std::min(std::max(word, 0.0), std::ldexp(1.0, 25) - 1));
}

}  // namespace steplock::design::sinusoidal
