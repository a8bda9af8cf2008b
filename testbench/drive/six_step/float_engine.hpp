// The floating-point reference behind the engines' interface.
//
// The reference lives in continuous time and is walked from event to event, exactly; only what it
// shows to the bench (gates, step, state) is looked at on clocks, up to one clock late.
//
// Test: tests/testbench/engine_test.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/reference/drive.hpp"
#include "testbench/drive/six_step/watch.hpp"

namespace steplock {

class FloatEngine {
 public:
  static constexpr const char* kName = "float";

  FloatEngine(const design::Parameters& parameters, double clock_hz)
      : drive_(parameters), target_(parameters.speed.target), clock_hz_(clock_hz) {}

  void set_pins(const plant::Pins& pins) {
    pins_.comparator = pins.comparator;
    pins_.limit = pins.limit;
    pins_.hall = pins.hall;
    touched_ = true;
  }
  void set_command(const HostCommand& c) {
    command_ = {.configured = true, .run = c.run, .reverse = c.reverse,
                .brake_to_stop = c.brake_to_stop, .clear_fault = c.clear_fault};
    pins_.fault = c.fault_pin;
    drive_.set_target(c.set_speed == 0 ? target_ : c.set_speed);
    touched_ = true;
  }

  // Another drive holds the bridge, and this is what it does there.
  void set_bridge(reference::Bridge bridge) {
    touched_ = touched_ || bridge_ != bridge;
    bridge_ = bridge;
  }

  void tick() {
    const double t = static_cast<double>(clock_++) / clock_hz_;
    // A strobe is one clock long, whatever happens within it.
    watch_.bits &= ~Watch::kStrobeMask;
    while (drive_.next_event() <= t) update(drive_.next_event());
    if (touched_) update(t);
    touched_ = false;
  }

  // Clocks for which tick() would do nothing at all.
  std::uint64_t quiet() const {
    if (touched_ || (watch_.bits & Watch::kStrobeMask) != 0) return 0;
    const double clocks = std::ceil(drive_.next_event() * clock_hz_) - 1;
    const auto first = static_cast<double>(clock_);
    return clocks > first ? static_cast<std::uint64_t>(std::min(clocks - first, 1e9)) : 0;
  }
  void skip(std::uint64_t clocks) { clock_ += clocks; }

  // From the coming clock on in speed control, where the other drive stands.
  // `reference`: steps/s, the other's slewed set speed.
  void join(const DriveView& v, double reference, int step, bool reverse) {
    drive_.join(static_cast<double>(clock_) / clock_hz_,
                {.step = step,
                 .step_phase = v.step_phase_deg / 60,
                 .phase_error = v.phase_error_deg / 60,
                 .frequency = v.steps_per_second,
                 .reference = reference,
                 .duty = v.duty,
                 .reverse = reverse});
  }

  Watch watch() const { return watch_; }
  double commutated_at() const { return commutated_at_; }  // s, to the last digit
  DriveView view() const {
    return {.steps_per_second = out_.frequency,
            .duty = out_.duty,
            .phase_error_deg = 60 * out_.phase_error,
            .step_phase_deg = 60 * out_.step_phase,
            .crossings = crossings_,
            .missed = missed_};
  }

 private:
  void update(double t) {
    out_ = drive_.update(t, pins_, command_, bridge_);
    if (out_.commutate) commutated_at_ = t;
    if (command_.run && !ran_) crossings_ = missed_ = 0;
    ran_ = command_.run;
    crossings_ += out_.crossing;
    missed_ += out_.missed;
    std::uint32_t bits = watch_.bits & Watch::kStrobeMask;
    for (int i = 0; i < 6; ++i) bits |= std::uint32_t{out_.gates[static_cast<std::size_t>(i)]} << i;
    watch_.bits = bits | static_cast<std::uint32_t>(out_.step) << Watch::kStep |
                  static_cast<std::uint32_t>(out_.state) << Watch::kState |
                  static_cast<std::uint32_t>(out_.reason) << Watch::kReason |
                  std::uint32_t{out_.crossing} << Watch::kCrossing |
                  std::uint32_t{out_.missed} << Watch::kMissed |
                  std::uint32_t{out_.locked} << Watch::kLocked;
  }

  reference::Drive drive_;
  reference::Pins pins_;
  reference::Command command_;
  std::optional<reference::Bridge> bridge_;
  reference::Output out_;
  Watch watch_;
  double target_, clock_hz_;
  std::uint64_t clock_ = 0;
  bool touched_ = true, ran_ = false;
  double commutated_at_ = 0;
  int crossings_ = 0, missed_ = 0;
};

}  // namespace steplock
