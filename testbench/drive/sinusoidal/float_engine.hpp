// The floating-point reference of the sinusoidal drive behind the engines' interface, with its
// ADCs: whoever runs the co-simulation calls set_reading() with the plant's state at the clock
// of a `sample` strobe.  An engine of fixed point or RTL offers the same calls.
//
// Test: tests/testbench/sinusoidal_run_test.cpp
#pragma once

#include <algorithm>
#include <cmath>

#include "model/design/sinusoidal/design.hpp"
#include "model/plant/adc.hpp"
#include "model/reference/sinusoidal/drive.hpp"
#include "testbench/engine/host_command.hpp"
#include "testbench/run/units.hpp"
#include "testbench/drive/sinusoidal/watch.hpp"

namespace steplock::sinusoidal {

class FloatEngine {
 public:
  static constexpr const char* kName = "float";

  FloatEngine(const design::sinusoidal::Parameters& p, const plant::AdcParameters& adc,
              double clock_hz)
      : drive_(p), adc_(adc), pole_pairs_(p.motor.pole_pairs), clock_hz_(clock_hz) {}
  FloatEngine(const design::Settings& s, const plant::AdcParameters& adc)
      : FloatEngine(design::sinusoidal::design_drive(s).parameters, adc, s.control.clock_hz) {}

  void set_pins(const plant::Pins&) {}  // comparators and Halls serve the six-step drive
  void set_command(const HostCommand& c) {
    command_ = {.configured = true, .run = c.run, .reverse = c.reverse,
                .brake_to_stop = c.brake_to_stop, .clear_fault = c.clear_fault};
    pins_.fault = c.fault_pin;
    if (c.set_speed != 0) set_target_rpm(rpm_of_steps(c.set_speed, pole_pairs_));
    touched_ = true;
  }
  void set_target_rpm(double rpm) { drive_.set_target(rpm * pole_pairs_ * std::numbers::pi / 30); }
  void lose_samples(bool lose) { lose_ = lose; }

  // What the plant shows at the strobe.
  void set_reading(const plant::State& s) {
    const plant::AdcCodes codes = adc_.sample(s, samples_++);
    if (lose_) return;
    reference::sinusoidal::Reading reading{.v_dc = codes.bus * adc_.voltage_lsb()};
    for (std::size_t k = 0; k < 3; ++k) reading.current[k] = codes.current[k] * adc_.current_lsb();
    pins_.reading = reading;
    touched_ = true;
  }

  void tick() {
    const double t = static_cast<double>(clock_++) / clock_hz_;
    watch_.bits &= ~Watch::kStrobeMask;  // a strobe is one clock long
    if (touched_ && drive_.next_event() > t) update(t);
    while (drive_.next_event() <= t) update(drive_.next_event());
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

  Watch watch() const { return watch_; }
  View view() const {
    const double peak = std::sqrt(2.0 / 3), to_rpm = 30 / std::numbers::pi / pole_pairs_;
    return {.estimating = out_.estimating,
            .angle_deg = degrees(out_.angle),
            .speed_rpm = out_.speed * to_rpm,
            .reference_rpm = out_.reference * to_rpm,
            .i_gamma = peak * out_.current.x,
            .i_delta = peak * out_.current.y,
            .i_wanted = peak * out_.wanted,
            .pilot_deg = degrees(out_.pilot_angle),
            .pilot_saliency = out_.pilot_saliency,
            .pilot_polarity = out_.pilot_polarity};
  }

 private:
  void update(double t) {
    out_ = drive_.update(t, pins_, command_);
    pins_.reading.reset();
    std::uint32_t bits = watch_.bits & Watch::kStrobeMask;
    for (std::size_t i = 0; i < 6; ++i) bits |= std::uint32_t{out_.gates[i]} << i;
    watch_.bits = bits | static_cast<std::uint32_t>(out_.state) << Watch::kState |
                  static_cast<std::uint32_t>(out_.reason) << Watch::kReason |
                  std::uint32_t{out_.sample} << Watch::kSample |
                  std::uint32_t{out_.locked} << Watch::kLocked;
  }

  reference::sinusoidal::Drive drive_;
  plant::Adc adc_;
  reference::sinusoidal::Pins pins_;
  reference::Command command_;
  reference::sinusoidal::Output out_;
  Watch watch_;
  int pole_pairs_;
  double clock_hz_;
  std::uint64_t clock_ = 0;
  std::int64_t samples_ = 0;
  bool touched_ = true, lose_ = false;
};

}  // namespace steplock::sinusoidal
