// Two engines on the same pins in one closed loop; the first one drives the motor.
//
// Test: tests/testbench/compare_test.cpp
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "testbench/engine/fixed.hpp"
#include "testbench/engine/float.hpp"
#include "testbench/engine/rtl.hpp"

namespace steplock {

// The blocks and their generated RTL, all outputs compared on every clock.
class LockstepEngine {
 public:
  LockstepEngine(const Words& words, double clock_hz)
      : fixed_(words, clock_hz), rtl_(words, clock_hz) {}

  void set_pins(const plant::Pins& pins) {
    fixed_.set_pins(pins);
    plant::Pins other = pins;
    // A negative control: the pair must notice that the RTL saw another comparator for one clock.
    if (clock_ >= flip_at_) {
      other.comparator[0] = !other.comparator[0];
      flip_at_ = ~std::uint64_t{0};
    }
    rtl_.set_pins(other);
  }
  void set_command(const HostCommand& c) {
    fixed_.set_command(c);
    rtl_.set_command(c);
  }
  void tick() {
    fixed_.tick();
    rtl_.tick();
    if (const char* port = rtl_.differs(fixed_.output()); port != nullptr) {
      if (differing_clocks_++ == 0) {
        first_clock_ = clock_;
        first_port_ = port;
      }
    }
    ++clock_;
  }
  std::uint64_t quiet() const { return 0; }
  void skip(std::uint64_t) {}
  Watch watch() const { return fixed_.watch(); }
  DriveView view() const { return fixed_.view(); }

  std::uint64_t differing_clocks() const { return differing_clocks_; }
  std::uint64_t first_clock() const { return first_clock_; }
  const std::string& first_port() const { return first_port_; }
  void flip_a_comparator_after(std::uint64_t clock) { flip_at_ = clock; }

 private:
  FixedEngine fixed_;
  RtlEngine rtl_;
  std::uint64_t clock_ = 0, differing_clocks_ = 0, first_clock_ = 0;
  std::uint64_t flip_at_ = ~std::uint64_t{0};
  std::string first_port_;
};

// A commutation of either drive, and what it held for true then.
struct StepChange {
  double time = 0;
  int step = 0;
  DriveView view;
};

// The blocks drive, the reference looks over their shoulder.
class ShadowEngine {
 public:
  ShadowEngine(const Words& words, const design::Parameters& parameters, double clock_hz)
      : fixed_(words, clock_hz), float_(parameters, clock_hz), clock_hz_(clock_hz) {}

  void set_pins(const plant::Pins& pins) {
    fixed_.set_pins(pins);
    float_.set_pins(pins);
  }
  void set_command(const HostCommand& c) {
    fixed_.set_command(c);
    float_.set_command(c);
  }
  void tick() {
    fixed_.tick();
    float_.tick();
    look();
    ++clock_;
  }
  std::uint64_t quiet() const { return std::min(fixed_.quiet(), float_.quiet()); }
  void skip(std::uint64_t clocks) {
    fixed_.skip(clocks);
    float_.skip(clocks);
    clock_ += clocks;
  }
  Watch watch() const { return fixed_.watch(); }
  DriveView view() const { return fixed_.view(); }
  Watch shadow() const { return float_.watch(); }

  const std::vector<StepChange>& fixed_commutations() const { return fixed_steps_; }
  const std::vector<StepChange>& float_commutations() const { return float_steps_; }

 private:
  void look() {
    const double now = static_cast<double>(clock_) / clock_hz_;
    if (fixed_.watch().step() != fixed_step_) {
      fixed_step_ = fixed_.watch().step();
      fixed_steps_.push_back({now, fixed_step_, fixed_.view()});
    }
    if (float_.watch().step() != float_step_) {
      float_step_ = float_.watch().step();
      float_steps_.push_back({float_.commutated_at(), float_step_, float_.view()});
    }
  }

  FixedEngine fixed_;
  FloatEngine float_;
  double clock_hz_;
  std::uint64_t clock_ = 0;
  int fixed_step_ = 0, float_step_ = 0;
  std::vector<StepChange> fixed_steps_, float_steps_;
};

}  // namespace steplock
