// The blocks and their generated RTL on the same pins in one closed loop; the blocks drive the motor.
//
// Test: tests/testbench/compare_test.cpp
#pragma once

#include "testbench/engine/fixed.hpp"
#include "testbench/engine/lockstep.hpp"
#include "testbench/engine/rtl.hpp"

namespace steplock {

// All outputs compared on every clock.
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
  void tick() {
    if (found_.clocks == wrong_from_ || found_.clocks == wrong_to_) show_rtl();
    fixed_.tick();
    rtl_.tick();
    if (const char* port = rtl_.differs(fixed_.output()); port != nullptr) {
      if (found_.differing_clocks++ == 0) {
        found_.first_clock = found_.clocks;
        found_.first_port = port;
      }
    }
    ++found_.clocks;
  }
  Watch watch() const { return fixed_.watch(); }
  DriveView view() const { return fixed_.view(); }

  const Lockstep& found() const { return found_; }

  // A negative control: in these clocks the RTL sees its comparators inverted.
  void invert_comparators(std::uint64_t from, std::uint64_t to) {
    wrong_from_ = from;
    wrong_to_ = to;
  }

 private:
  void show_rtl() {
    plant::Pins pins = pins_;
    if (found_.clocks >= wrong_from_ && found_.clocks < wrong_to_) {
      for (bool& level : pins.comparator) level = !level;
    }
    rtl_.set_pins(pins);
  }

  FixedEngine fixed_;
  RtlEngine rtl_;
  std::uint64_t wrong_from_ = ~std::uint64_t{0}, wrong_to_ = ~std::uint64_t{0};
  plant::Pins pins_;
  Lockstep found_;
};

}  // namespace steplock
