// The blocks and the reference in doubles on the same pins; the blocks drive the motor.
//
// Test: tests/testbench/compare_test.cpp
#pragma once

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/float_engine.hpp"

namespace steplock {

// A commutation of either drive, and what it held for true then.
struct StepChange {
  double time = 0;
  int step = 0;
  DriveView view;
};

// The blocks drive, the reference looks over their shoulder.  It could not start with them, because a
// start needs gates that act; so it joins, soon after clock `from`, at which the blocks must be locked.
// Its speed control acts on nothing either, so that whatever duty it begins with stays wrong for ever:
// it joins at a change of the blocks' duty, when that and the frequency belong together, unless the slew
// limit cut the change, with the set speed slewed as far as theirs, from the frequency at which they
// locked.
class ShadowEngine {
 public:
  ShadowEngine(const SixStepConfig& config, const design::Parameters& parameters, double clock_hz,
               std::uint64_t from)
      : fixed_(config, clock_hz), float_(parameters, clock_hz), speed_(parameters.speed),
        clock_hz_(clock_hz), most_(config.speed.duty_slew.raw()), from_(from),
        latest_(from + kPatience * config.pwm.period.raw() * config.pwm.tick_periods.raw()) {}

  void set_pins(const plant::Pins& pins) {
    fixed_.set_pins(pins);
    float_.set_pins(pins);
  }
  void set_command(const HostCommand& c) {
    fixed_.set_command(c);
    command_ = c;
    if (joined_) float_.set_command(c);
  }
  void tick() {
    fixed_.tick();
    float_.set_bridge({fixed_.watch().step(), fixed_.output().chop});
    float_.tick();
    look();
    if (!fixed_.watch().locked()) {
      lock_clock_ = clock_;
      lock_frequency_ = fixed_.view().steps_per_second;
    }
    const int move = std::abs(static_cast<int>(fixed_.output().duty.raw()) - duty_);
    const bool moved = move != 0 && move < most_;
    duty_ = static_cast<int>(fixed_.output().duty.raw());
    if (!joined_ && (clock_ >= latest_ || (clock_ > from_ && moved))) join();
    ++clock_;
  }
  std::uint64_t quiet() const {
    const std::uint64_t most = joined_ ? kNever : latest_ - clock_;
    return std::min({most, fixed_.quiet(), float_.quiet()});
  }
  void skip(std::uint64_t clocks) {
    fixed_.skip(clocks);
    float_.skip(clocks);
    clock_ += clocks;
  }
  Watch watch() const { return fixed_.watch(); }
  DriveView view() const { return fixed_.view(); }

  const std::vector<StepChange>& fixed_commutations() const { return fixed_steps_; }
  const std::vector<StepChange>& float_commutations() const { return float_steps_; }

  // Speed control's ticks without such a change.  A duty that stays may be joined at any time; one that
  // noise slews at every tick has been free at one of so many, unless it is no longer controlled.
  static constexpr std::uint64_t kPatience = 16;

 private:
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};

  void join() {
    joined_ = true;
    float_.set_command(command_);
    const double seconds = static_cast<double>(clock_ - lock_clock_) / clock_hz_;
    const double most = speed_.slew * seconds;
    const double reference =
        lock_frequency_ + std::clamp(speed_.target - lock_frequency_, -most, most);
    float_.join(fixed_.view(), reference, fixed_.watch().step(), fixed_.output().reverse);
  }
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
  design::SpeedParameters speed_;
  double clock_hz_;
  int most_;  // u1.15, that the duty may move by at a tick
  std::uint64_t clock_ = 0, from_, latest_;
  bool joined_ = false;
  int duty_ = 0;  // u1.15
  std::uint64_t lock_clock_ = 0;
  double lock_frequency_ = 0;
  HostCommand command_;
  int fixed_step_ = 0, float_step_ = 0;
  std::vector<StepChange> fixed_steps_, float_steps_;
};

}  // namespace steplock
