// A configuration with short times, and pins and a host that do anything: what the drive's tests share.
#pragma once

#include <optional>
#include <random>

#include "hls/six_step/six_step_top.hpp"

namespace steplock {

// Configuration of a drive with short times, so that a few thousand clocks see all states.
inline SixStepConfig quick_config() {
  SixStepConfig w;
  w.pwm = {.period = 200, .minimum = 4, .complementary = true, .dead_time = 14, .tick_periods = 1};
  w.limit = {.blanking = 10, .off_time = 50};
  w.bemf = {.blanking = 5, .sample_every = 3, .samples = 2};
  w.loop = {.ki = 655, .kp = 6554, .minimum = 1 << 16, .maximum = 1 << 25};
  w.start = {.pre_align = 2, .align = 3, .align_duty = 0x4000, .start_duty = 0x4000, .ramp = 0xFFFFF,
             .look = 2, .probe = 20, .still = 6, .hand_over = 1 << 22, .window = 0x4000, .good_crossings = 2, .pull_in = 20,
             .detect_spin = 4, .slow_down = 4, .brake = 3, .brake_duty = 0x4000, .retry_delay = 2,
             .retries = 15};
  w.speed = {.target = 1 << 23, .slew = 0xFFFFF, .shift = 9, .kp = 4096, .ki = 1000, .bemf = 0x2000,
             .minimum = 0x1000, .maximum = 0x8000, .duty_slew = 0x400};
  return w;
}

// Pins that flicker at all rates, and a host that changes its mind now and then.
struct Chaos {
  std::mt19937 random{1};
  SixStepTop top;
  SixStepTop::In in;

  Chaos() {
    in.config = quick_config();
    in.command.configured = true;
  }

  bool once_in(unsigned n) { return random() % n == 0; }
  void flip(bool& pin, unsigned n) { pin ^= once_in(n); }

  Gates clock() { return clock_of().gates; }
  // All outputs; of one source, if it is given.
  SixStepTop::Out clock_of(std::optional<Source> source = {}) {
    flip(in.pins.comparator_u, 150);
    flip(in.pins.comparator_v, 150);
    flip(in.pins.comparator_w, 150);
    flip(in.pins.limit, 300);
    flip(in.pins.hall_u, 400);
    flip(in.pins.hall_v, 400);
    flip(in.pins.hall_w, 400);
    flip(in.command.run, 50000);
    flip(in.command.reverse, 20000);
    flip(in.command.brake_to_stop, 20000);
    if (once_in(30000)) in.config.source = Source(random() % 2);
    if (once_in(3000)) in.config.pwm.complementary = random() % 2;
    if (once_in(3000)) in.config.pwm.centred = random() % 2;
    if (once_in(3000)) in.config.pwm.dead_time = random() % 40;
    if (once_in(20000)) in.config.start.method = Method(random() % 2);
    if (source) in.config.source = *source;
    return top.tick(in);
  }
};

}  // namespace steplock
