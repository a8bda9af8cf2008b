// See words.hpp for the full scales; formats are those of hls/sinusoidal/words.hpp.
#include "model/design/sinusoidal/words.hpp"

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
  explicit ScaledQuantiser(Quantised& q) : word_(q.rows, q.problems) {}

  Word operator()(const char* name, const char* unit, double wanted, double scale, int fraction,
                  int bits) {
    return word_(name, unit, wanted, std::ldexp(scale, -fraction), bits);
  }
  Word periods(const char* name, double seconds, const Scales& f) {
    return (*this)(name, "s", seconds, f.period, 0, 20);
  }

 private:
  Quantiser word_;
};

BridgeWords bridge_words(ScaledQuantiser& word, const Parameters& p, const Settings& s,
                         const Scales& f) {
  BridgeWords w{.compensate = p.applied.compensate,
                .sine = p.pwm.modulation == Modulation::kSine};
  w.period = word("bridge.period", "s", p.pwm.period, f.clock, 0, 14);
  // The guard's floor is dead time that is really there.
  const double dead = std::max(p.pwm.dead_time, kDeadTimeFloor * f.clock);
  w.dead_time = word("bridge.dead_time", "s", dead, f.clock, 0, 8);
  // A pulse shorter than its dead time would be none.
  w.minimum = word("bridge.minimum", "s", std::max(p.pwm.minimum, dead), f.clock, 0, 14);
  const double lost = dead * (1 + 2 * p.applied.diode_drop / s.inverter.bus_v);
  w.lost = word("bridge.lost", "s", lost, f.clock, 4, 12);
  w.inverse = word("bridge.inverse", "1/clocks", 1 / (3.0 * w.period), 1, 26, 15);
  return w;
}

EstimatorWords estimator_words(ScaledQuantiser& word, const Parameters& p, const Scales& f) {
  const double per_voltage = p.pwm.period / p.motor.inductance_q;  // A/V
  const double turns = 2 * kPi / (kRoot * f.current);  // rad/A of a turn per full scale
  return {.voltage = p.estimator == Estimator::kVoltage,
          .average = p.voltage_model.samples != 1,
          .decay = word("estimator.decay", "", p.motor.resistance * per_voltage, 1, 15, 15),
          .gain = word("estimator.gain", "A/V", per_voltage, f.current / f.voltage, 13, 15),
          .k_theta = word("estimator.k_theta", "rad/A", p.current_model.k_theta, turns, 14, 15),
          .k_e = word("estimator.k_e", "V/A", p.current_model.k_e, f.voltage / f.current, 13, 15),
          .k_speed = word("estimator.k_speed", "rad/V", p.pwm.period / p.motor.k_e,
                          2 * kPi / (kRoot * f.voltage), 17, 15),
          .k_emf = word("estimator.k_emf", "rad/A", p.motor.inductance_q / p.motor.k_e, turns, 15,
                        15),
          .k_si = word("estimator.k_si", "rad/A",
                       p.voltage_model.k_si * p.motor.inductance_q * p.pwm.period, turns, 23, 15)};
}

RegulatorWords speed_words(ScaledQuantiser& word, const Parameters& p, const Scales& f) {
  const double current = kRoot * f.current, period = p.pwm.period;
  const auto speed = [&](const char* name, double w) {
    return word(name, "rad/s", w, f.speed, 15, 15);
  };
  return {.target = word("speed.target", "rad/s", p.speed.target, f.speed, 25, 25),
          .slew = word("speed.slew", "rad/s^2", p.speed.slew, f.speed / period, 25, 15),
          .filter = word("speed.filter", "per sample", -std::expm1(-p.speed.filter * period), 1, 15,
                         15),
          .k_p = word("speed.k_p", "A/(rad/s)", p.speed.kp, current / f.speed, 8, 15),
          .k_i = word("speed.k_i", "A/rad", p.speed.ki, current / f.speed / period, 17, 15),
          .limit = word("speed.limit", "A", p.speed.limit, current, 15, 15),
          .lock = speed("speed.lock", p.start.lock_speed),
          .slow = speed("speed.slow", p.protection.slow_speed),
          .stop = speed("speed.stop", p.start.stop_speed),
          .emf_low = word("speed.emf_low", "", p.protection.emf_low, 1, 13, 15),
          .emf_high = word("speed.emf_high", "", p.protection.emf_high, 1, 13, 15)};
}

ControlWords control_words(ScaledQuantiser& word, const Parameters& p, const Scales& f) {
  const double ohm = f.voltage / f.current;
  const bool sine = p.pwm.modulation == Modulation::kSine;
  const double longest = sine ? 0.5 : 1 / std::numbers::sqrt3;
  return {.set_gamma = word("control.set_gamma", "A", p.current.i_gamma, kRoot * f.current, 15, 15),
          .k_p = word("control.k_p", "V/A", p.current.kp_delta, ohm, 12, 15),
          .k_i = word("control.k_i", "V/(A s)", p.current.ki_delta, ohm / p.pwm.period, 15, 15),
          .inductance =
              word("control.inductance", "H", p.motor.inductance_q, ohm / f.speed, 12, 15),
          .emf = word("control.emf", "V s/rad", p.motor.k_e, kRoot * f.voltage / f.speed, 12, 15),
          .limit = word("control.limit", "", longest, 1, 15, 15)};
}

void refuse(std::vector<std::string>& lines, const Settings& s, const Design& d) {
  const auto& p = d.parameters;
  if (p.start.by == StartBy::kPilot) {
    lines.push_back(
        "sinusoidal_start.by is \"pilot\"; must be \"pattern\" or \"arbitrary\" for this engine");
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
  if (p.motor.inductance_d != p.motor.inductance_q) {
    lines.push_back(
        "motor.inductance_d_h differs from inductance_q_h; must be the same for this engine");
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
  q.words.bridge = bridge_words(word, p, s, f);
  q.words.estimator = estimator_words(word, p, f);
  q.words.speed = speed_words(word, p, f);
  q.words.control = control_words(word, p, f);
  const auto& t = p.start;
  q.words.sequence = {
      .arbitrary = t.by == StartBy::kArbitrary,
      .hold_voltage = word("sequence.hold_voltage", "V",
                           1.5 * p.motor.resistance * t.pattern_current, f.voltage, 15, 15),
      .pattern = word.periods("sequence.pattern", t.pattern_s / 2, f),
      .lock = word.periods("sequence.lock", t.lock_s, f),
      .give_up = word.periods("sequence.give_up", t.give_up_s, f),
      .brake = word.periods("sequence.brake", t.brake_s, f),
      .rest = word.periods("sequence.rest", t.rest_s, f),
      .retries = word("sequence.retries", "", t.retries, 1, 0, 4)};
  const auto& g = p.protection;
  const Word over = word("fault.over_current", "A", g.over_current, f.current, 15, 15);
  q.words.fault = {.over_current = over,
                   .saturated = word.periods("fault.saturated", g.saturated_s, f),
                   .slow = word.periods("fault.slow", g.slow_s, f),
                   .emf = word.periods("fault.emf", g.emf_s, f),
                   .lost_samples = word("fault.lost_samples", "", g.lost_samples, 1, 0, 4)};
  return q;
}

Word target_word(const Settings& s, double rpm) {
  const double word = std::round(std::ldexp(speed_of(s, rpm) / scales(s).speed, 25));
  return Word(std::min(std::max(word, 0.0), std::ldexp(1.0, 25) - 1));
}

}  // namespace steplock::design::sinusoidal
