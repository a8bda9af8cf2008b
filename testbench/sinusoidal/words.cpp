#include "testbench/sinusoidal/words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "hls/sinusoidal/sinusoidal_standalone.hpp"
#include "testbench/sinusoidal/watch.hpp"

namespace steplock::sinusoidal {
namespace {

// Enumerators have the same order on both sides.
static_assert(int(State::kPattern) == int(SinusoidalState::kPattern));
static_assert(int(State::kRun) == int(SinusoidalState::kRun));
static_assert(int(State::kFault) == int(SinusoidalState::kFault));
static_assert(int(Reason::kSaturated) == int(SinusoidalReason::kSaturated));
static_assert(int(Reason::kNoLock) == int(SinusoidalReason::kNoLock));
static_assert(int(Reason::kNoPolarity) == int(SinusoidalReason::kNoPolarity));

}  // namespace

SinusoidalWords hls_words(const design::sinusoidal::Words& d) {
  return {.bridge = {.period = d.bridge.period, .minimum = d.bridge.minimum,
                     .dead_time = d.bridge.dead_time, .dead_time_loss = d.bridge.dead_time_loss,
                     .compensate = d.bridge.compensate, .sine_pwm = d.bridge.sine_pwm,
                     .reciprocal = d.bridge.reciprocal},
          .estimator = {.voltage = d.estimator.voltage, .average = d.estimator.average,
                        .decay = d.estimator.decay, .gain = d.estimator.gain,
                        .k_theta = d.estimator.k_theta, .k_e = d.estimator.k_e,
                        .k_speed = d.estimator.k_speed, .k_emf = d.estimator.k_emf,
                        .k_si = d.estimator.k_si},
          .speed = {.target = d.speed.target, .slew = d.speed.slew, .filter = d.speed.filter,
                    .k_p = d.speed.k_p, .k_i = d.speed.k_i, .limit = d.speed.limit,
                    .start_current = d.speed.start_current,
                    .lock = d.speed.lock, .slow = d.speed.slow, .stop = d.speed.stop,
                    .emf_low = d.speed.emf_low, .emf_high = d.speed.emf_high},
          .control = {.set_gamma = d.control.set_gamma, .k_p = d.control.k_p,
                      .k_i = d.control.k_i, .inductance = d.control.inductance,
                      .emf = d.control.emf, .limit = d.control.limit},
          .sequence = {.arbitrary = d.sequence.arbitrary,
                       .pilot = d.sequence.pilot,
                       .hold_voltage = d.sequence.hold_voltage, .pattern = d.sequence.pattern,
                       .lock = d.sequence.lock, .give_up = d.sequence.give_up,
                       .brake = d.sequence.brake, .retry_delay = d.sequence.retry_delay,
                       .retries = d.sequence.retries},
          .pilot = {.short_periods = d.pilot.short_periods,
                    .long_periods = d.pilot.long_periods, .rounds = d.pilot.rounds,
                    .decayed = d.pilot.decayed, .saliency = d.pilot.saliency,
                    .polarity = d.pilot.polarity},
          .fault = {.over_current = d.fault.over_current, .saturated = d.fault.saturated,
                    .slow = d.fault.slow, .emf = d.fault.emf,
                    .lost_samples = d.fault.lost_samples}};
}

SinusoidalWords words_of(const design::Settings& s) {
  const auto q = design::sinusoidal::quantise(s);
  std::string lines;
  for (const std::string& line : q.problems) lines += (lines.empty() ? "" : "\n") + line;
  if (!lines.empty()) throw std::invalid_argument(lines);
  return hls_words(q.words);
}

SpiAdcWords adc_words_of(const design::Settings& s) {
  constexpr double kFastest = 20e6, kAcquire = 300e-9;  // Hz, s: data sheet of the AD7928
  const double clock_hz = s.control.clock_hz;
  const auto clocks = [](double wanted) { return static_cast<int>(std::ceil(wanted - 1e-6)); };
  const int half = clocks(clock_hz / 2 / kFastest), quiet = clocks(kAcquire * clock_hz);
  const int needed = SinusoidalStandalone::clocks_of_a_sample(half, quiet);
  const int period = static_cast<int>(std::lround(clock_hz / s.control.pwm_hz));
  if (needed > period) {
    throw std::invalid_argument(
        fmt::format("control.pwm_hz is {:g} Hz, {} clocks; must be {} or more, which a sample takes over "
                    "SPI: lower it, or raise control.clock_hz",
                    s.control.pwm_hz, period, needed));
  }
  return {.half = half, .quiet = quiet, .u = 0, .v = 1, .dc = 2};
}

}  // namespace steplock::sinusoidal
