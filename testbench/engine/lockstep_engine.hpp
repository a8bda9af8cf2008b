// The blocks and their generated RTL on the same pins in one closed loop; the blocks drive the motor.
//
// Test: tests/testbench/engine_test.cpp, compare_test.cpp
#pragma once

#include "testbench/engine/fixed.hpp"
#include "testbench/engine/lockstep.hpp"
#include "testbench/engine/rtl.hpp"

namespace steplock {

// All outputs compared on every clock.  The blocks skip their quiet clocks; the RTL takes each of them.
class LockstepEngine {
 public:
  LockstepEngine(const Words& words, double clock_hz)
      : fixed_(words, clock_hz), rtl_(words, clock_hz) {
    rtl_.look_always();
  }

  void set_pins(const plant::Pins& pins) {
    pins_ = pins;
    fixed_.set_pins(pins);
    show_rtl();
  }
  void set_command(const HostCommand& c) {
    fixed_.set_command(c);
    rtl_.set_command(c);
  }
  // From 1 to `most` clocks; in those after the first watch() does not change, because they are quiet.
  std::uint64_t run(std::uint64_t most) {
    const std::uint64_t more = fixed_.tick_and_foresee(most - 1);
    SixStepTop::Out expected = fixed_.output();
    compare(expected);
    for (std::uint64_t n = 1; n <= more; ++n) {
      expected.step_phase = fixed_.shows(n);
      compare(expected);
    }
    fixed_.take(more);
    return 1 + more;
  }
  Watch watch() const { return fixed_.watch(); }
  DriveView view() const { return fixed_.view(); }

  const Lockstep& found() const { return found_; }

  // Negative controls: in these clocks the RTL sees its comparators inverted; in this one it is asked for
  // a step phase that is wrong by its last bit.
  void invert_comparators(std::uint64_t from, std::uint64_t to) {
    wrong_from_ = from;
    wrong_to_ = to;
  }
  void spoil_step_phase(std::uint64_t clock) { spoilt_ = clock; }

 private:
  // The RTL's coming clock.
  void compare(SixStepTop::Out expected) {
    if (found_.clocks == spoilt_) expected.step_phase = expected.step_phase ^ Phase(1);
    if (found_.clocks == wrong_from_ || found_.clocks == wrong_to_) show_rtl();
    rtl_.tick();
    if (const char* port = rtl_.differs(expected); port != nullptr) {
      if (found_.differing_clocks++ == 0) {
        found_.first_clock = found_.clocks;
        found_.first_port = port;
      }
    }
    ++found_.clocks;
  }
  void show_rtl() {
    plant::Pins pins = pins_;
    if (found_.clocks >= wrong_from_ && found_.clocks < wrong_to_) {
      for (bool& level : pins.comparator) level = !level;
    }
    rtl_.set_pins(pins);
  }

  FixedEngine fixed_;
  RtlEngine rtl_;
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};
  std::uint64_t wrong_from_ = kNever, wrong_to_ = kNever, spoilt_ = kNever;
  plant::Pins pins_;
  Lockstep found_;
};

}  // namespace steplock
