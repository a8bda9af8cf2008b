// A speed control's words, and one update of it.
#pragma once

#include "hls/six_step/speed_control.hpp"

namespace steplock::test {

inline SpeedControl::In typical() {
  SpeedControl::In in;
  in.period = 1600;
  in.config.shift = 4;
  in.config.slew = 1 << 19;
  in.config.kp = 2 << 12;
  in.config.ki = 6554;  // a tenth per tick
  in.config.bemf = in.config.loaded = 1 << 12;
  in.config.maximum = 0x8000;
  in.config.duty_slew = 4095;
  return in;
}

// Without the integral the duty is what the reference has gained on the frequency, in normalised speed: its slew is 100 a tick.
inline SpeedControl::In reference_as_duty() {
  auto in = typical();
  in.config.ki = 0;
  in.config.kp = 1 << 12;
  in.config.slew = 100 << 4;
  return in;
}

// One tick and the clocks that its products take.
inline SpeedControl::Out update(SpeedControl& dut, SpeedControl::In in) {
  dut.tick(in);  // a new mode or target counts from the next clock on
  in.tick = true;
  dut.tick(in);
  in.tick = false;
  for (int i = 0; i < 140; ++i) dut.tick(in);
  return dut.tick(in);
}

inline int duty_of(const SpeedControl::Out& out) { return static_cast<int>(out.duty.raw()); }

}  // namespace steplock::test
