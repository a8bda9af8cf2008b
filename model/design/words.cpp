// See words.hpp for the formats.
#include "model/design/words.hpp"

#include <algorithm>
#include <cmath>

#include "model/design/quantiser.hpp"

namespace steplock::design {
namespace {

constexpr double kDuty = 1.0 / 32768, kPhase = 1.0 / 65536;
constexpr double kDutyMost = 65535;

LoopWords loop_words(Quantiser& word, const LoopParameters& p, double tick, double clock,
                     double hertz) {
  LoopWords w{.detector = p.detector, .bandwidth = p.form, .divide = Word(p.divide)};
  w.expected = word("loop.expected", "step", p.expected, kPhase, 16);
  w.lead_error = word("loop.lead_error", "step", p.lead_error, kPhase, 16);
  w.delay = word("loop.delay", "s", p.delay + kPinClocks / clock, 1 / clock, 10);
  if (p.form == LoopForm::kPerStep) {
    w.ki = word("loop.ki", "per step", p.integral, std::ldexp(1, -14), 16);
    w.kp = word("loop.kp", "per step", p.proportional, std::ldexp(1, -14), 16);
    w.pole = 2 * word("loop.pole", "per step", p.pole, 2 * kDuty, 15);
  } else {
    // Ours to choose, so that kp fills its word; the filter reads its upper 22 bits.
    const double chosen = 16 * hertz * std::round(p.proportional / 3.9 / (16 * hertz));
    w.scale = word("loop.scale", "steps/s", chosen, hertz, 26);
    const double scale = w.scale * hertz;
    w.ki = word("loop.ki", "1/s^2", p.integral, scale / tick * std::ldexp(1, -14), 16);
    w.kp = word("loop.kp", "1/s", p.proportional, scale * std::ldexp(1, -14), 16);
    w.pole = 2 * word("loop.pole", "per tick", 1 - std::exp(-p.pole * tick), 2 * kDuty, 15);
  }
  w.minimum = word("loop.minimum", "steps/s", p.minimum, hertz, 26);
  w.maximum = word("loop.maximum", "steps/s", p.maximum, hertz, 26);
  return w;
}

StartWords start_words(Quantiser& word, const StartParameters& p, double tick, double hertz,
                       double sample) {
  StartWords w{.method = p.method};
  w.pre_align = word("start.pre_align", "s", p.pre_align, tick, 12);
  w.align = word("start.align", "s", p.align, tick, 12);
  w.align_duty = word("start.align_duty", "", p.align_duty, kDuty, 16, kDutyMost);
  w.start_duty = word("start.start_duty", "", p.start_duty, kDuty, 16, kDutyMost);
  w.ramp = word("start.ramp", "steps/s^2", p.ramp, hertz / tick, 20);
  w.hand_over = word("start.hand_over", "steps/s", p.hand_over, hertz, 26);
  w.window = word("start.window", "step", p.window, kPhase, 16);
  w.good_crossings = word("start.good_crossings", "", p.good_crossings, 1, 6);
  w.pull_in = word("start.pull_in", "s", p.pull_in, tick, 12);
  w.detect_spin = word("start.detect_spin", "s", p.detect_spin, tick, 12);
  w.slow_down = word("start.slow_down", "s", p.slow_down, tick, 12);
  w.brake = word("start.brake", "s", p.brake, tick, 12);
  w.brake_duty = word("start.brake_duty", "", p.brake_duty, kDuty, 16, kDutyMost);
  w.retry_delay = word("start.retry_delay", "s", p.retry_delay, tick, 12);
  w.retries = word("start.retries", "", p.retries, 1, 4);
  w.look = word("start.look", "s", p.look, sample, 16);
  w.probe = word("start.probe", "s", p.probe, sample, 16);
  w.still = word("start.still", "", p.still, 1, 8);
  return w;
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

SpeedWords speed_words(Quantiser& word, const SpeedParameters& p, Word fastest, double tick,
                       double hertz) {
  SpeedWords w{.shift = speed_shift(fastest)};
  const double normalised =
      std::ldexp(hertz, int(w.shift));  // steps/s per LSB of frequency >> shift
  w.target = word("speed.target", "steps/s", p.target, hertz, 26);
  w.slew = word("speed.slew", "steps/s^2", p.slew, hertz / tick, 20);
  w.kp = word("speed.kp", "1/(step/s)", p.kp, kp_lsb(normalised), 16);
  w.ki = word("speed.ki", "1/step", p.ki, kDuty / normalised / 65536 / tick, 16);
  w.bemf = word("speed.bemf", "1/(step/s)", p.bemf, kp_lsb(normalised), 16);
  w.loaded = word("speed.loaded", "1/(step/s)", p.loaded, kp_lsb(normalised), 16);
  w.minimum = word("speed.minimum", "", p.minimum, kDuty, 16, kDutyMost);
  w.maximum = word("speed.maximum", "", p.maximum, kDuty, 16, kDutyMost);
  w.duty_slew = word("speed.duty_slew", "1/s", p.duty_slew, kDuty / tick, 12);
  return w;
}

}  // namespace

double most_speed_kp(const LoopParameters& p, double clock_hz) {
  const double hertz = hertz_of(p, clock_hz);
  const double fastest = std::clamp(std::round(p.maximum / hertz), 0.0, std::ldexp(1.0, 26) - 1);
  return 65535 * kp_lsb(std::ldexp(hertz, int(speed_shift(Word(fastest)))));
}

Quantised quantise(const Parameters& p, double clock_hz) {
  Quantised q;
  Quantiser word(q.rows, q.problems);
  Words& w = q.words;
  const double clock = 1 / clock_hz;

  w.source = p.source;
  w.pwm = {.period = word("pwm.period", "s", p.pwm.period, clock, 14),
           .minimum = word("pwm.minimum", "s", p.pwm.minimum, clock, 14),
           .centred = p.pwm.centred,
           .complementary = p.pwm.complementary,
           .dead_time = word("pwm.dead_time", "s", p.pwm.dead_time, clock, 8),
           .tick_periods = word("pwm.tick_periods", "", p.pwm.tick_periods, 1, 8)};
  w.limit = {.blanking = word("limit.blanking", "s", p.limit.blanking, clock, 8),
             .off_time = word("limit.off_time", "s", p.limit.off_time, clock, 12)};
  w.bemf = {.sampling = p.bemf.sampling,
            .blanking = word("bemf.blanking", "s", p.bemf.blanking, clock, 10),
            .sample_every = word("bemf.sample_every", "s", p.bemf.sample_every, clock, 8),
            .samples = word("bemf.samples", "", p.bemf.samples, 1, 4)};

  // Times are counted in the ticks that the words make, not in those that were wanted.
  const double tick = w.pwm.period * clock * w.pwm.tick_periods;
  const double hertz = hertz_of(p.loop, clock_hz);
  w.loop = loop_words(word, p.loop, tick, clock_hz, hertz);
  const double sample = std::max<Word>(w.bemf.sample_every, 1) * clock;
  w.start = start_words(word, p.start, tick, hertz, sample);
  w.speed = speed_words(word, p.speed, w.loop.maximum, tick, hertz);
  const auto& g = p.protection;
  w.protection = {.misses = word("protection.misses", "", g.misses, 1, 6),
                  .stall = word("protection.stall", "steps/s", g.stall, hertz, 26),
                  .slip = word("protection.slip", "", g.slip, kDuty, 16, kDutyMost),
                  .freewheel = word("protection.freewheel", "step", g.freewheel, kPhase, 16),
                  .wrong_lock = word("protection.wrong_lock", "s", g.wrong_lock, tick, 12),
                  .over_current = word("protection.over_current", "", g.over_current, 1, 4)};
  return q;
}

}  // namespace steplock::design
