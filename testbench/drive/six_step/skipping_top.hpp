// The whole drive, for simulation: the clocks in which it does nothing but count, many at once; and those in which the slow blocks
// do no more than that, without asking them.
//
//     slow     follower, start, detector, filter, speed control, protection, telemetry: busy for a few hundred clocks after a
//              crossing, a step or a tick
//     quick    pins, Hall decoder, comparator, VCO, divider, PWM, limit, commutation, gate guard: busy at each edge of a pin or gate
//
//     A tick of all in which the slow ones do nothing but count is the first of `calm_` such clocks, until their next event
//     or until the quick ones have news for them.  In those the quick ones alone are ticked, or skipped where they, too, count.
//
// docs/theory.md, "Quiet clocks", says why this is exact.  Each counting block knows for how many clocks its counter reaches no
// event (quiet) and can take that many (skip).
//
// Doc: docs/theory.md   Test: tests/testbench/skipping_top_test.cpp
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "hls/six_step/six_step_top.hpp"

namespace steplock {

class SkippingTop : public SixStepTop {
  // Blocks and registers of each kind, to be copied, put back and compared as one.
  auto quick() {
    return std::tie(synchroniser_, hall_, divide_, bemf_, vco_, pwm_, limit_, guard_, divided_, legs_, tick_, chop_, limited_);
  }
  auto slow() {
    return std::tie(rotor_, filter_, speed_, start_, detector_, protection_, telemetry_, still_, fast_, update_, good_,
                    lags_, slow_, follow_, steady_, reverse_, crossing_, masked_lead_, freewheels_, lost_, fatal_, cause_);
  }
  template <class... Part>
  static std::tuple<Part...> copy(const std::tuple<Part&...>& parts) {
    return parts;
  }

 public:
  // With any inputs.  What is below takes another command or other words only after such a tick; pins may change at any time.
  Out tick(const In& in) {
    settle();
    return tick_with(in, wires_);
  }
  // How many ticks, with the inputs of the last one, whose outputs were `last`, would do nothing but count.
  std::uint64_t quiet(const In& in, const Out& last) const {
    SkippingTop ticked = *this;
    ticked.settle();
    const std::uint64_t clocks = std::min(ticked.to_slow_event(in, last), ticked.to_quick_event(in, last));
    if (clocks < kWorthwhile) return 0;
    SkippingTop counted = ticked;
    counted.skip(in, last, 1);
    Out out = ticked.tick(in);
    out.step_phase = last.step_phase;
    return out == last && ticked == counted ? clocks : 0;
  }
  // That many at once; step_phase as the last of them shows it.
  Phase skip(const In& in, const Out& last, std::uint64_t clocks) {
    const Phase shown = shows(in, last, clocks);
    skip_quick(in, last, clocks);
    if (clocks < calm_) {
      pass(clocks);
    } else {
      settle();
      skip_slow(in.config.bemf.sample_every, last.frequency, clocks);
    }
    return shown;
  }
  // What step_phase shows in the n-th of them, from 1: alone of all outputs it counts as well.
  Phase shows(const In& in, const Out& last, std::uint64_t n) const {
    if (n == 1) return divided_.phase;
    return divide_.step_phase(vco_.shown(turning(last), n - 1), in.config.loop.divide);
  }
  // A tick; `out`, which was that of the last one, becomes its.  How many more, at most `most`, are quiet.
  std::uint64_t tick_and_foresee(const In& in, Out& out, std::uint64_t most) {
    if (calm_ > 0) {
      const std::uint64_t clocks = std::min({to_quick_event(in, out), calm_, most + 1});
      const auto before = copy(quick());
      if (clocks < kWorthwhile) {
        if (tick_quick(in, out, before)) return 0;
      } else {
        const Out last = out;
        skip_quick(in, last, 1);
        const auto counted = copy(quick());
        quick() = before;
        if (tick_quick(in, out, before)) return same(last, out) && quick() == counted ? std::min(clocks - 1, calm_) : 0;
      }
    }
    settle();
    const std::uint64_t clocks = to_slow_event(in, out);
    if (clocks < kWorthwhile) {
      tick_all(in, out);
      return 0;
    }
    auto counted = copy(slow());
    count(std::get<RotorFollower>(counted), std::get<LoopFilter>(counted), std::get<SpeedControl>(counted), in.config.bemf.sample_every,
          out.frequency, 1);
    const bool chop = chop_;
    tick_all(in, out);
    if (slow() == counted && !tells(chop)) {
      calm_ = clocks - 1;
      sample_every_ = in.config.bemf.sample_every;
    }
    return 0;
  }
  // From 1 to `most` ticks, as many as are quiet: the same as tick() so often.
  std::uint64_t advance(const In& in, Out& out, std::uint64_t most) {
    const std::uint64_t more = tick_and_foresee(in, out, most - 1);
    if (more > 0) out.step_phase = skip(in, out, more);
    return 1 + more;
  }
  // What speed control is told in the next clock beside the frequency.
  bool at_tick() const { return tick_; }
  bool limited() const { return limited_; }
  bool without_crossing() const { return update_ && !good_; }
  bool masked_lead() const { return masked_lead_; }
  bool freewheels() const { return freewheels_; }
  bool operator==(const SkippingTop& other) const {
    SkippingTop one = *this, two = other;
    one.settle();
    two.settle();
    return static_cast<const SixStepTop&>(one) == static_cast<const SixStepTop&>(two);
  }

 private:
  static constexpr std::uint64_t kWorthwhile = 4;  // clocks; below, looking costs more than ticking

  void count(RotorFollower& rotor, LoopFilter& filter, SpeedControl& speed, UInt<8> sample_every, Frequency frequency,
             std::uint64_t clocks) const {
    rotor.skip(follows(sample_every), clocks);
    filter.skip(clocks);
    speed.skip(frequency, clocks);
  }
  void skip_slow(UInt<8> sample_every, Frequency frequency, std::uint64_t clocks) {
    count(rotor_, filter_, speed_, sample_every, frequency, clocks);
  }
  // The slow blocks have counted that far, and are told so by settle().
  void pass(std::uint64_t clocks) {
    owed_ += clocks;
    calm_ -= clocks;
  }
  void settle() {
    if (owed_ > 0) skip_slow(sample_every_, wires_.filter.frequency, owed_);
    owed_ = calm_ = 0;
  }

  // One copy of the whole drive: with one at each of three places the instruction cache holds none.
  [[gnu::noinline, gnu::flatten]] void tick_all(const In& in, Out& out) { out = tick_with(in, wires_); }
  // A tick of the quick blocks, which were `before`, with what the slow ones say in every calm clock.  False, and nothing done, where
  // they have news for those in this very clock.
  template <class Quick>
  [[gnu::noinline, gnu::flatten]] bool tick_quick(const In& in, Out& out, const Quick& before) {
    const auto sectors = wires_.sectors;
    const auto bemf = wires_.bemf;
    const bool fault = wires_.pins.fault;
    const auto stuck = wires_.limit.stuck;
    sense(in, wires_);
    bool news = wires_.sectors != sectors || wires_.pins.fault != fault;
    if (!news) {
      listen(in, wires_);
      news = wires_.bemf != bemf;
    }
    if (!news) {
      turn(in, wires_);
      drive(in, wires_);
      news = wires_.limit.hit || wires_.limit.stuck != stuck;
    }
    if (news) {
      quick() = before;
      return false;
    }
    const bool chop = chop_;
    keep(wires_);
    out.gates = wires_.gates;
    out.step = wires_.step;
    out.chop = wires_.limit.on;
    out.turn = DivideByN::turn(wires_.divider.step);
    out.step_phase = wires_.divider.phase;
    pass(1);
    if (tells(chop)) settle();
    return true;
  }
  // News of the quick blocks for the slow ones, in the next clock; `chop` was theirs in the last one.
  bool tells() const { return tick_ || limited_ || divided_.commutate || divided_.elapsed; }
  bool tells(bool chop) const { return tells() || (follow_ && !wires_.rotor.sure && chop != chop_); }
  static bool same(const Out& last, Out out) {
    out.step_phase = last.step_phase;
    return out == last;
  }

  // Clocks until the first counter reaches its event; 0 where more than counters is at work.
  std::uint64_t to_slow_event(const In& in, const Out& last) const {
    if (tells() || update_ || crossing_) return 0;
    std::uint64_t clocks = std::min(filter_.quiet(), speed_.quiet());
    clocks = std::min(clocks, rotor_.quiet(follows(in.config.bemf.sample_every)));
    return follow_ ? std::min(clocks, to_quarter(last)) : clocks;
  }
  std::uint64_t to_quick_event(const In& in, const Out& last) const {
    if (tells() || !synchroniser_.settled(in.pins)) return 0;
    std::uint64_t clocks = vco_.quiet(turning(last));
    clocks = std::min(clocks, hall_.quiet(code(in)));
    clocks = std::min(clocks, bemf_.quiet(sensed(in, last)));
    clocks = std::min(clocks, pwm_.quiet());
    clocks = std::min(clocks, limit_.quiet(chop_));
    return std::min(clocks, guard_.quiet());
  }
  void skip_quick(const In& in, const Out& last, std::uint64_t clocks) {
    if (const auto sampled = bemf_.skip(sensed(in, last), clocks); sampled != 0) {
      bemf_.remember(shows(in, last, sampled));
    }
    divided_.phase = shows(in, last, clocks + 1);
    vco_.skip(turning(last), clocks);
    hall_.skip(clocks);
    pwm_.skip(clocks);
    limit_.skip(chop_, clocks);
    guard_.skip(clocks);
  }

  RotorFollower::In follows(UInt<8> sample_every) const {
    RotorFollower::In now;
    now.on = follow_;
    now.sample_every = sample_every;
    return now;
  }
  // A rotor that is overdue is looked for once a quarter of the next step is over.
  static std::uint64_t to_quarter(const Out& last) {
    if (last.step_phase >= 0x4000 || last.frequency == 0) return ~std::uint64_t{0};
    return (0x4000 - std::uint64_t{last.step_phase.raw()} - 1) * 0x10000 / last.frequency.raw();
  }

  // Of the pins that the Hall decoder looks at.
  static UInt<3> code(const In& in) {
    const auto& p = in.pins;
    const bool hall = by_hall(in);
    return UInt<3>(hall ? p.hall_u : p.comparator_u) << 2 | UInt<3>(hall ? p.hall_v : p.comparator_v) << 1 |
           UInt<3>(hall ? p.hall_w : p.comparator_w);
  }
  VcoCounter::In turning(const Out& last) const {
    const bool held = last.state == State::kIdle || last.state == State::kBrake ||
                      last.state == State::kPreAlign || last.state == State::kAlign ||
                      last.state == State::kRetryDelay || last.state == State::kFault;
    return {.enable = !held, .frequency = last.frequency};
  }
  BemfComparator::In sensed(const In& in, const Out& last) const {
    return {.u = in.pins.comparator_u,
            .v = in.pins.comparator_v,
            .w = in.pins.comparator_w,
            .step = last.step,
            .reverse = last.reverse,
            .chop = chop_,
            .phase = last.step_phase,
            .config = in.config.bemf};
  }

  Wires wires_;              // of the last clock
  std::uint64_t calm_ = 0;   // clocks to come in which the slow blocks do nothing but count
  std::uint64_t owed_ = 0;   // clocks of that kind that have passed
  UInt<8> sample_every_ = 1; // the follower's, in them
};

}  // namespace steplock
