// The blocks, compiled natively: the bit-exact model behind the engines' interface.
//
// Test: tests/testbench/engine_test.cpp
#pragma once

#include <cmath>

#include "testbench/drive/six_step/skipping_top.hpp"
#include "testbench/drive/six_step/watch.hpp"

namespace steplock {

inline Watch watch_of(const SixStepTop::Out& o) {
  const Gates& g = o.gates;
  return {std::uint32_t{g.uh} | std::uint32_t{g.ul} << 1 | std::uint32_t{g.vh} << 2 |
          std::uint32_t{g.vl} << 3 | std::uint32_t{g.wh} << 4 | std::uint32_t{g.wl} << 5 |
          std::uint32_t(o.step.raw()) << Watch::kStep |
          static_cast<std::uint32_t>(o.state) << Watch::kState |
          static_cast<std::uint32_t>(o.reason) << Watch::kReason |
          std::uint32_t{o.crossing} << Watch::kCrossing | std::uint32_t{o.missed} << Watch::kMissed |
          std::uint32_t{o.locked} << Watch::kLocked};
}

inline DriveView view_of(const SixStepTop::Out& o, double clock_hz, int divide) {
  const auto number = [](auto bits) { return static_cast<double>(bits.raw()); };
  return {.steps_per_second = number(o.frequency) * clock_hz / 4294967296.0 / (1 << divide),
          .duty = number(o.duty) / 0x8000,
          .phase_error_deg = 60 * number(o.phase_error) / 0x10000,
          .step_phase_deg = 60 * number(o.step_phase) / 0x10000,
          .crossings = static_cast<int>(o.counts.crossings.raw()),
          .missed = static_cast<int>(o.counts.missed.raw()),
          .freewheel_long = static_cast<int>(o.counts.freewheel_long.raw()),
          .limit_hits = static_cast<int>(o.counts.limit_hits.raw()),
          .retries = static_cast<int>(o.counts.retries.raw())};
}

inline void put_pins(Synchroniser::Pins& to, const plant::Pins& pins) {
  to.comparator_u = pins.comparator[0];
  to.comparator_v = pins.comparator[1];
  to.comparator_w = pins.comparator[2];
  to.limit = pins.limit;
  to.hall_u = pins.hall[0];
  to.hall_v = pins.hall[1];
  to.hall_w = pins.hall[2];
}

inline Command command_of(const HostCommand& c) {
  return {.configured = true, .run = c.run, .reverse = c.reverse, .brake_to_stop = c.brake_to_stop,
          .clear_fault = c.clear_fault};
}

// The target's word, as the design library rounds it.
inline Frequency target_of(const HostCommand& c, const SixStepConfig& config, double clock_hz) {
  if (c.set_speed == 0) return config.speed.target;
  const double turns = std::ldexp(c.set_speed / clock_hz, 32 + static_cast<int>(config.loop.divide.raw()));
  return Frequency::of(static_cast<std::uint64_t>(std::llround(turns)));
}

class FixedEngine {
 public:
  using Out = SixStepTop::Out;
  static constexpr const char* kName = "fixed";
  static void spoil(Out& out) { out.step_phase = out.step_phase ^ Phase(1); }  // one wrong bit

  FixedEngine(const SixStepConfig& config, double clock_hz) : config_(config), clock_hz_(clock_hz) {
    in_.config = config;
  }

  void set_pins(const plant::Pins& pins) {
    put_pins(in_.pins, pins);
  }
  void set_command(const HostCommand& c) {
    in_.command = command_of(c);
    in_.pins.fault = c.fault_pin;
    in_.config.speed.target = target_of(c, config_, clock_hz_);
    ticked_ = false;
  }

  void tick();
  // Some clocks, at most `most`: up to the next one after which an output may change.
  std::uint64_t run(std::uint64_t most);
  // The same for one who looks at each of the clocks: see(output) for every one of them, skipped or not.
  // While it skips, the output stays, but for step_phase.
  template <class See>
  std::uint64_t each(std::uint64_t most, See&& see) {
    const std::uint64_t more = tick_and_foresee(most - 1);
    see(out_);
    if (more == 0) return 1;
    Out shown = out_;
    for (std::uint64_t n = 1; n <= more; ++n) {
      shown.step_phase = top_.shows(in_, out_, n);
      see(shown);
    }
    skip_quiet(more);
    return 1 + more;
  }
  // For two engines that must stop at the same clocks.
  std::uint64_t quiet() const;
  void skip(std::uint64_t clocks);

  Watch watch() const { return watch_of(out_); }
  DriveView view() const {
    return view_of(out_, clock_hz_, static_cast<int>(in_.config.loop.divide.raw()));
  }
  const SixStepTop::Out& output() const { return out_; }
  const SkippingTop& top() const { return top_; }
  const SixStepConfig& config() const { return in_.config; }  // with the set speed of now

 private:
  // A tick and how many more are quiet, at most `most`.
  std::uint64_t tick_and_foresee(std::uint64_t most);
  // So many clocks, of which it was foreseen that they are quiet.
  void skip_quiet(std::uint64_t clocks);

  SixStepConfig config_;
  SkippingTop top_;
  SixStepTop::In in_;
  SixStepTop::Out out_;
  double clock_hz_;
  bool ticked_ = false;  // with the present command
};

}  // namespace steplock
