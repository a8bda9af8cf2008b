#include "testbench/engine/words.hpp"

namespace steplock {
namespace {

// Enumerators have the same order on both sides.
static_assert(int(design::Sampling::kOnTime) == int(Sampling::kOnTime));
static_assert(int(design::Sampling::kOffTime) == int(Sampling::kOffTime));
static_assert(int(design::Sampling::kBoth) == int(Sampling::kBoth));
static_assert(int(design::Detector::kOncePerTurn) == int(Detector::kOncePerTurn));
static_assert(int(design::Detector::kEveryStep) == int(Detector::kEveryStep));
static_assert(int(design::LoopForm::kPerSecond) == int(Bandwidth::kPerSecond));
static_assert(int(design::LoopForm::kPerStep) == int(Bandwidth::kPerStep));
static_assert(int(design::Source::kBemf) == int(Source::kBemf));
static_assert(int(design::Source::kHall) == int(Source::kHall));
static_assert(int(design::Method::kRamp) == int(Method::kRamp));
static_assert(int(design::Method::kFollow) == int(Method::kFollow));

}  // namespace

Words hls_words(const design::Words& d) {
  return {.pwm = {.period = d.pwm.period, .minimum = d.pwm.minimum, .centred = d.pwm.centred,
                  .complementary = d.pwm.complementary, .dead_time = d.pwm.dead_time,
                  .tick_periods = d.pwm.tick_periods},
          .limit = {.blanking = d.limit.blanking, .off_time = d.limit.off_time},
          .bemf = {.sampling = static_cast<Sampling>(d.bemf.sampling), .blanking = d.bemf.blanking,
                   .sample_every = d.bemf.sample_every, .samples = d.bemf.samples},
          .loop = {.detector = static_cast<Detector>(d.loop.detector),
                   .bandwidth = static_cast<Bandwidth>(d.loop.bandwidth), .divide = d.loop.divide,
                   .expected = d.loop.expected, .lead_error = d.loop.lead_error,
                   .delay = d.loop.delay, .ki = d.loop.ki, .kp = d.loop.kp, .pole = d.loop.pole,
                   .scale = d.loop.scale, .minimum = d.loop.minimum, .maximum = d.loop.maximum},
          .start = {.method = static_cast<Method>(d.start.method), .pre_align = d.start.pre_align, .align = d.start.align,
                    .align_duty = d.start.align_duty, .start_duty = d.start.start_duty,
                    .ramp = d.start.ramp, .look = d.start.look, .probe = d.start.probe,
                    .still = d.start.still, .hand_over = d.start.hand_over,
                    .window = d.start.window, .good_crossings = d.start.good_crossings,
                    .pull_in = d.start.pull_in, .detect_spin = d.start.detect_spin,
                    .slow_down = d.start.slow_down, .brake = d.start.brake,
                    .brake_duty = d.start.brake_duty, .retry_delay = d.start.retry_delay,
                    .retries = d.start.retries},
          .speed = {.target = d.speed.target, .slew = d.speed.slew, .shift = d.speed.shift,
                    .kp = d.speed.kp, .ki = d.speed.ki, .bemf = d.speed.bemf,
                    .loaded = d.speed.loaded, .minimum = d.speed.minimum, .maximum = d.speed.maximum,
                    .duty_slew = d.speed.duty_slew},
          .protection = {.misses = d.protection.misses, .stall = d.protection.stall,
                         .slip = d.protection.slip, .freewheel = d.protection.freewheel,
                         .wrong_lock = d.protection.wrong_lock,
                         .over_current = d.protection.over_current},
          .source = static_cast<Source>(d.source)};
}

}  // namespace steplock
