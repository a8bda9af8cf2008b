// See config.hpp for the formats.
#include "model/design/config.hpp"

#include <algorithm>
#include <cmath>

#include "model/design/quantiser.hpp"
#include "model/design/rules.hpp"

namespace steplock::design {
namespace {

constexpr double kDuty = 1.0 / 32768, kPhase = 1.0 / 65536;
constexpr double kDutyMost = 65535;

void loop_config(Quantiser& word, Config& config, const LoopParameters& p, double tick, double clock, double hertz) {
  word.choose("loop.detector", p.detector);
  word.choose("loop.bandwidth", p.form);
  word.choose("loop.divide", p.divide);
  word("loop.expected", "step", p.expected, kPhase, 16);
  word("loop.lead_error", "step", p.lead_error, kPhase, 16);
  word("loop.delay", "s", p.delay + kPinClocks / clock, 1 / clock, 10);
  Word pole = 0;
  if (p.form == LoopForm::kPerStep) {
    word("loop.ki", "per step", p.integral, std::ldexp(1, -14), 16);
    word("loop.kp", "per step", p.proportional, std::ldexp(1, -14), 16);
    pole = word("loop.alpha", "per step", p.pole, 2 * kDuty, 15);
  } else {
    // Ours to choose, so that kp fills its word; the filter reads its upper 22 bits.
    const double chosen = 16 * hertz * std::round(p.proportional / 3.9 / (16 * hertz));
    const double scale = word("loop.scale", "steps/s", chosen, hertz, 26) * hertz;
    word("loop.ki", "1/s^2", p.integral, scale / tick * std::ldexp(1, -14), 16);
    word("loop.kp", "1/s", p.proportional, scale * std::ldexp(1, -14), 16);
    pole = word("loop.alpha", "per tick", 1 - std::exp(-p.pole * tick), 2 * kDuty, 15);
  }
  config.set("loop.alpha", 2 * pole);
  word("loop.minimum", "steps/s", p.minimum, hertz, 26);
  word("loop.maximum", "steps/s", p.maximum, hertz, 26);
}

void start_config(Quantiser& word, const StartParameters& p, double tick, double hertz, double sample) {
  word.choose("start.method", p.method);
  word("start.pre_align", "s", p.pre_align, tick, 12);
  word("start.align", "s", p.align, tick, 12);
  word("start.align_duty", "", p.align_duty, kDuty, 16, kDutyMost);
  word("start.start_duty", "", p.start_duty, kDuty, 16, kDutyMost);
  word("start.ramp", "steps/s^2", p.ramp, hertz / tick, 20);
  word("start.hand_over", "steps/s", p.hand_over, hertz, 26);
  word("start.window", "step", p.window, kPhase, 16);
  word("start.good_crossings", "", p.good_crossings, 1, 6);
  word("start.pull_in", "s", p.pull_in, tick, 12);
  word("start.detect_spin", "s", p.detect_spin, tick, 12);
  word("start.slow_down", "s", p.slow_down, tick, 12);
  word("start.brake", "s", p.brake, tick, 12);
  word("start.brake_duty", "", p.brake_duty, kDuty, 16, kDutyMost);
  word("start.retry_delay", "s", p.retry_delay, tick, 12);
  word("start.retries", "", p.retries, 1, 4);
  word("start.look", "s", p.look, sample, 16);
  word("start.probe", "s", p.probe, sample, 16);
  word("start.still", "", p.still, 1, 8);
}

Word speed_shift(Word fastest) {
  Word shift = 0;
  while ((fastest >> shift) > 32767) ++shift;
  return shift;
}

double hertz_of(const LoopParameters& p, double clock_hz) {  // steps/s per LSB of a frequency
  return std::ldexp(clock_hz, -32 - p.divide);
}

// 1/(step/s) per LSB of kp, with the steps/s per LSB of frequency >> shift.
double kp_lsb(double normalised) { return kDuty / normalised / 4096; }

void speed_config(Quantiser& word, const SpeedParameters& p, Word fastest, double tick, double hertz) {
  const Word shift = speed_shift(fastest);
  word.choose("speed.shift", shift);
  const double normalised = std::ldexp(hertz, int(shift));  // steps/s per LSB of frequency >> shift
  word("speed.target", "steps/s", p.target, hertz, 26);
  word("speed.slew", "steps/s^2", p.slew, hertz / tick, 20);
  word("speed.kp", "1/(step/s)", p.kp, kp_lsb(normalised), 16);
  word("speed.ki", "1/step", p.ki, kDuty / normalised / 65536 / tick, 16);
  word("speed.bemf", "1/(step/s)", p.bemf, kp_lsb(normalised), 16);
  word("speed.loaded", "1/(step/s)", p.loaded, kp_lsb(normalised), 16);
  word("speed.minimum", "", p.minimum, kDuty, 16, kDutyMost);
  word("speed.maximum", "", p.maximum, kDuty, 16, kDutyMost);
  word("speed.duty_slew", "1/s", p.duty_slew, kDuty / tick, 12);
}

}  // namespace

double most_frequency(const LoopParameters& p, double clock_hz) { return (std::ldexp(1, 26) - 1) * hertz_of(p, clock_hz); }

double most_ramp(const LoopParameters& p, double tick, double clock_hz) {
  return (std::ldexp(1, 20) - 1) * hertz_of(p, clock_hz) / tick;
}

double most_duty_per_speed(const LoopParameters& p, double clock_hz) {
  const double hertz = hertz_of(p, clock_hz);
  const double fastest = std::clamp(std::round(p.maximum / hertz), 0.0, std::ldexp(1.0, 26) - 1);
  return 65535 * kp_lsb(std::ldexp(hertz, int(speed_shift(Word(fastest)))));
}

Quantised quantise(const Parameters& p, double clock_hz) {
  Quantised q;
  Quantiser word(q.config, q.rows, q.problems);
  const double clock = 1 / clock_hz;

  word.choose("source", p.source);
  const Word period = word("pwm.period", "s", p.pwm.period, clock, 14);
  word("pwm.minimum", "s", p.pwm.minimum, clock, 14);
  word.choose("pwm.centred", p.pwm.centred);
  word.choose("pwm.complementary", p.pwm.complementary);
  word("pwm.dead_time", "s", p.pwm.dead_time, clock, 8);
  const Word periods = word("pwm.tick_periods", "", p.pwm.tick_periods, 1, 8);
  word("limit.blanking", "s", p.limit.blanking, clock, 8);
  word("limit.off_time", "s", p.limit.off_time, clock, 12);
  word.choose("bemf.sampling", p.bemf.sampling);
  word("bemf.blanking", "s", p.bemf.blanking, clock, 10);
  const Word every = word("bemf.sample_every", "s", p.bemf.sample_every, clock, 8);
  word("bemf.samples", "", p.bemf.samples, 1, 4);

  // Times are counted in the ticks that the words make, not in those that were wanted.
  const double tick = period * clock * periods;
  const double hertz = hertz_of(p.loop, clock_hz);
  loop_config(word, q.config, p.loop, tick, clock_hz, hertz);
  start_config(word, p.start, tick, hertz, std::max<Word>(every, 1) * clock);
  speed_config(word, p.speed, q.config["loop.maximum"], tick, hertz);
  const auto& g = p.protection;
  word("protection.misses", "", g.misses, 1, 6);
  word("protection.stall", "steps/s", g.stall, hertz, 26);
  word("protection.slip", "", g.slip, kDuty, 16, kDutyMost);
  word("protection.freewheel", "step", g.freewheel, kPhase, 16);
  word("protection.wrong_lock", "s", g.wrong_lock, tick, 12);
  word("protection.over_current", "", g.over_current, 1, 4);
  return q;
}

}  // namespace steplock::design
