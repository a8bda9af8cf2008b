// The RTL of the sinusoidal drive with its source beside it: the same inputs, and every output in
// every clock.  The source drives the motor, and skips its quiet clocks; the RTL takes each of them.
//
// Test: tests/testbench/sinusoidal_engines_test.cpp
#pragma once

#include "testbench/sinusoidal/rtl_engine.hpp"

namespace steplock::sinusoidal {

class Lockstep {
 public:
  Lockstep(const design::Settings& s, const plant::AdcParameters& adc)
      : rtl_(s, adc), cpp_(s, adc) {}

  void set_pins(const plant::Pins&) {}
  void set_command(const HostCommand& c) { rtl_.set_command(c), cpp_.set_command(c); }
  void set_reading(const plant::State& s) { rtl_.set_reading(s), cpp_.set_reading(s); }
  // From 1 to `most` clocks, all of the same outputs if more than one.
  std::uint64_t run(std::uint64_t most) {
    const std::uint64_t taken = cpp_.run(most);
    for (std::uint64_t k = 0; k < taken; ++k) compare();
    return taken;
  }
  Watch watch() const { return cpp_.watch(); }
  View view() const { return cpp_.view(); }

  const char* first = nullptr;  // the first port that differed
  std::uint64_t clocks = 0, at = 0;
  std::uint64_t spoil = ~std::uint64_t{0};  // a negative control: one wrong bit in this clock

 private:
  void compare() {
    rtl_.tick();
    auto out = cpp_.output();
    if (clocks == spoil) out.on_u = out.on_u ^ LegClocks(1);
    if (const char* port = rtl_.differs(out); port != nullptr && first == nullptr) {
      first = port;
      at = clocks;
    }
    ++clocks;
  }

  RtlEngine rtl_;
  FixedEngine cpp_;
};

}  // namespace steplock::sinusoidal
