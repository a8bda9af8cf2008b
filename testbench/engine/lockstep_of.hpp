// The blocks and their generated RTL on the same pins in one closed loop, of either drive; the blocks drive
// the motor.
//
// All outputs are compared on every clock.  The blocks skip their quiet clocks; the RTL takes each of them.
// `Fixed` and `Rtl` are the engines of one drive, with beside the engines' calls
//
//     Fixed:  uint64_t each(uint64_t most, compare)   1 to `most` clocks, compare(output) for every one
//             using Out                               spoil(Out&): one wrong bit, for a negative control
//     Rtl:    const char* differs(const Out&)         the first port that is not so, after tick()
//
// Test: tests/testbench/engine_test.cpp, compare_test.cpp, sinusoidal_engines_test.cpp
#pragma once

#include <cstdint>

#include "model/plant/plant.hpp"
#include "testbench/engine/host_command.hpp"
#include "testbench/engine/lockstep.hpp"

namespace steplock {

template <class Fixed, class Rtl>
class LockstepOf {
 public:
  // Whatever both engines are made of.
  template <class... Settings>
  explicit LockstepOf(const Settings&... settings) : fixed_(settings...), rtl_(settings...) {
    if constexpr (requires { rtl_.look_always(); }) rtl_.look_always();
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
  // With ADCs only.
  template <class State>
    requires requires(Fixed& fixed, const State& s) { fixed.set_reading(s); }
  void set_reading(const State& s) {
    fixed_.set_reading(s);
    rtl_.set_reading(s);
  }
  // From 1 to `most` clocks; in those after the first watch() does not change, because they are quiet.
  std::uint64_t run(std::uint64_t most) {
    return fixed_.each(most, [this](const typename Fixed::Out& expected) { compare(expected); });
  }
  auto watch() const { return fixed_.watch(); }
  auto view() const { return fixed_.view(); }

  const Lockstep& found() const { return found_; }

  // Negative controls: in these clocks the RTL sees its comparators inverted; in this one it is asked for
  // an output with one wrong bit.
  void invert_comparators(std::uint64_t from, std::uint64_t to) {
    wrong_from_ = from;
    wrong_to_ = to;
  }
  void spoil(std::uint64_t clock) { spoilt_ = clock; }

 private:
  // The RTL's coming clock.
  void compare(typename Fixed::Out expected) {
    if (found_.clocks == spoilt_) Fixed::spoil(expected);
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

  Fixed fixed_;
  Rtl rtl_;
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};
  std::uint64_t wrong_from_ = kNever, wrong_to_ = kNever, spoilt_ = kNever;
  plant::Pins pins_;
  Lockstep found_;
};

}  // namespace steplock
