// The sinusoidal blocks, compiled natively, behind the engines' interface, with their ADCs:
// the same calls as FloatEngine.
//
// Test: tests/testbench/sinusoidal_engines_test.cpp
#pragma once

#include <numbers>

#include "hls/sinusoidal/sinusoidal_top.hpp"
#include "model/plant/adc.hpp"
#include "testbench/engine/host_command.hpp"
#include "testbench/run/units.hpp"
#include "testbench/drive/sinusoidal/skipping_top.hpp"
#include "testbench/drive/sinusoidal/watch.hpp"
#include "testbench/drive/sinusoidal/config.hpp"

namespace steplock::sinusoidal {

inline Watch watch_of(const SinusoidalTop::Out& o) {
  const Gates& g = o.gates;
  return {std::uint32_t{g.uh} | std::uint32_t{g.ul} << 1 | std::uint32_t{g.vh} << 2 |
          std::uint32_t{g.vl} << 3 | std::uint32_t{g.wh} << 4 | std::uint32_t{g.wl} << 5 |
          static_cast<std::uint32_t>(o.state) << Watch::kState |
          static_cast<std::uint32_t>(o.reason) << Watch::kReason |
          std::uint32_t{o.sample} << Watch::kSample | std::uint32_t{o.locked} << Watch::kLocked};
}

// The scales of what the drive shows.
struct Showing {
  double current, rpm;  // of full scale: A, r/min

  explicit Showing(const design::Settings& s)
      : current(design::sinusoidal::current_range(s)),
        rpm(60 * s.control.pwm_hz / 16 / s.motor.pole_pairs) {}

  View view(const SinusoidalTop::Out& o, bool reverse) const {
    const auto part = [](Int<16> x) { return static_cast<double>(x.raw()) / 32768; };
    return {.estimating = o.estimating,
            .angle_deg = 360 * static_cast<double>(o.angle.raw()) / (1 << 24),
            .speed_rpm = rpm * part(o.speed),
            .reference_rpm = (reverse ? -rpm : rpm) * part(o.reference),
            .i_gamma = current * part(o.i_gamma),
            .i_delta = current * part(o.i_delta),
            .i_wanted = current * part(o.wanted),
            .pilot_deg = 360 * static_cast<double>(o.initial.raw()) / (1 << 24)};
  }
};

// What every engine with registers shares: inputs, and the ADCs behind them.
class Inputs {
 public:
  Inputs(const design::Settings& s, const plant::AdcParameters& adc) : settings_(s), adc_(adc) {
    in.config = config_of(s);
  }

  void command(const HostCommand& c) {
    in.command = {.configured = true, .run = c.run, .reverse = c.reverse,
                  .brake_to_stop = c.brake_to_stop, .clear_fault = c.clear_fault};
    in.fault = c.fault_pin;
    if (c.set_speed != 0) target_rpm(rpm_of_steps(c.set_speed, settings_.motor.pole_pairs));
  }
  void target_rpm(double rpm) {
    in.config.speed.target = design::sinusoidal::target_word(settings_, rpm);
  }
  void lose(bool lose) { lose_ = lose; }
  void reading(const plant::State& s) {
    const plant::AdcCodes codes = adc_.sample(s, samples_++);
    if (lose_) return;
    in.codes = {.valid = true, .u = codes.current[0], .v = codes.current[1], .dc = codes.bus};
  }

  SinusoidalTop::In in;

 private:
  design::Settings settings_;
  plant::Adc adc_;
  std::int64_t samples_ = 0;
  bool lose_ = false;
};

class FixedEngine {
 public:
  using Out = SinusoidalTop::Out;
  static void spoil(Out& out) { out.on_u = out.on_u ^ LegClocks(1); }  // one wrong bit
  static constexpr const char* kName = "fixed";

  FixedEngine(const design::Settings& s, const plant::AdcParameters& adc)
      : inputs_(s, adc), showing_(s) {}

  void set_pins(const plant::Pins&) {}  // comparators and Halls serve the six-step drive
  void set_command(const HostCommand& c) { inputs_.command(c); }
  void set_target_rpm(double rpm) { inputs_.target_rpm(rpm); }
  void lose_samples(bool lose) { inputs_.lose(lose); }
  void set_reading(const plant::State& s) { inputs_.reading(s); }

  void tick();
  // Some clocks, at most `most`: up to the next one after which an output may change.
  std::uint64_t run(std::uint64_t most);

  // The same for one who looks at each of the clocks: see(output) for every one of them, skipped or not.
  template <class See>
  std::uint64_t each(std::uint64_t most, See&& see) {
    const std::uint64_t taken = run(most);
    for (std::uint64_t n = 0; n < taken; ++n) see(out_);
    return taken;
  }

  Watch watch() const { return watch_of(out_); }
  View view() const { return showing_.view(out_, inputs_.in.command.reverse); }
  const SinusoidalTop::Out& output() const { return out_; }

 private:
  Inputs inputs_;
  Showing showing_;
  SkippingSinusoidalTop top_;
  SinusoidalTop::Out out_;
};

}  // namespace steplock::sinusoidal
