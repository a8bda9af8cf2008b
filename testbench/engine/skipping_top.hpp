// The whole drive, for simulation: the clocks in which it does nothing but count, many at once.
//
//     docs/theory.md, "Quiet clocks", says why this is exact.  Each counting block knows for how many
//     clocks its counter reaches no event (quiet) and can take that many (skip); here they are put
//     together.  Outputs and state are those of SixStepTop::tick() so many times.
//
// Doc: docs/theory.md   Test: tests/testbench/skipping_top_test.cpp
#pragma once

#include <algorithm>
#include <cstdint>

#include "hls/six_step/six_step_top.hpp"

namespace steplock {

class SkippingTop : public SixStepTop {
 public:
  // How many ticks, with the inputs of the last one, whose outputs were `last`, would do nothing but count.
  std::uint64_t quiet(const In& in, const Out& last) const {
    const std::uint64_t clocks = to_event(in, last);
    if (clocks < kWorthwhile) return 0;
    SkippingTop ticked = *this;
    Out out = last;
    return ticked.counts(in, out) ? clocks : 0;
  }
  // That many at once; step_phase as the last of them shows it.
  Phase skip(const In& in, const Out& last, std::uint64_t clocks) {
    const Phase shown = shows(in, last, clocks);
    if (const auto sampled = bemf_.skip(sensed(in, last), clocks); sampled != 0) {
      bemf_.remember(shows(in, last, sampled));
    }
    divided_.phase = shows(in, last, clocks + 1);
    const auto vco = turning(last);
    vco_.skip(vco, clocks);
    hall_.skip(clocks);
    rotor_.skip(follows(in), clocks);
    filter_.skip(clocks);
    speed_.skip(last.frequency, clocks);
    pwm_.skip(clocks);
    limit_.skip(chop_, clocks);
    guard_.skip(clocks);
    return shown;
  }
  // What step_phase shows in the n-th of them, from 1: alone of all outputs it counts as well.
  Phase shows(const In& in, const Out& last, std::uint64_t n) const {
    if (n == 1) return divided_.phase;
    return divide_.step_phase(vco_.shown(turning(last), n - 1), in.words.loop.divide);
  }
  // A tick; `out`, which was that of the last one, becomes its.  How many more, at most `most`, are quiet.
  std::uint64_t tick_and_foresee(const In& in, Out& out, std::uint64_t most) {
    const std::uint64_t clocks = std::min(to_event(in, out), most + 1);
    if (clocks >= kWorthwhile) return counts(in, out) ? clocks - 1 : 0;
    ticks(in, out);
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
  bool hurries() const { return hurries_; }
  bool freewheels() const { return freewheels_; }
  bool operator==(const SkippingTop&) const = default;

 private:
  // One copy of the whole drive: with one at each of three places the instruction cache holds none.
  [[gnu::noinline, gnu::flatten]] void ticks(const In& in, Out& out) { out = tick(in); }
  static constexpr std::uint64_t kWorthwhile = 4;  // clocks; below, looking costs more than ticking
  // Clocks until the first counter reaches its event; 0 where more than counters is at work.
  std::uint64_t to_event(const In& in, const Out& last) const {
    if (tick_ || limited_ || divided_.commutate || divided_.elapsed || update_) return 0;
    if (!synchroniser_.settled(in.pins)) return 0;
    std::uint64_t clocks = std::min(filter_.quiet(), speed_.quiet());
    if (clocks == 0) return 0;
    clocks = std::min(clocks, vco_.quiet(turning(last)));
    clocks = std::min(clocks, hall_.quiet(code(in)));
    clocks = std::min(clocks, rotor_.quiet(follows(in)));
    if (crossing_) return 0;
    if (follow_) clocks = std::min(clocks, to_quarter(last));
    clocks = std::min(clocks, bemf_.quiet(sensed(in, last)));
    clocks = std::min(clocks, pwm_.quiet());
    clocks = std::min(clocks, limit_.quiet(chop_));
    return std::min(clocks, guard_.quiet());
  }
  // A tick.  If it changes counters alone, as skip() says, so does each one up to the next event.
  bool counts(const In& in, Out& out) {
    SkippingTop counted = *this;
    counted.skip(in, out, 1);
    const Out last = out;
    ticks(in, out);
    const Phase shown = out.step_phase;
    out.step_phase = last.step_phase;
    const bool same = out == last && *this == counted;
    out.step_phase = shown;
    return same;
  }

  RotorFollower::In follows(const In& in) const {
    RotorFollower::In now;
    now.on = follow_;
    now.sample_every = in.words.bemf.sample_every;
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
    const bool hall = in.with.hall_decoder && in.words.source == Source::kHall;
    return UInt<3>(hall ? p.hall_u : p.comparator_u) << 2 | UInt<3>(hall ? p.hall_v : p.comparator_v) << 1 |
           UInt<3>(hall ? p.hall_w : p.comparator_w);
  }
  VcoCounter::In turning(const Out& last) const {
    const bool held = last.state == State::kIdle || last.state == State::kBrake ||
                      last.state == State::kSettle || last.state == State::kReset ||
                      last.state == State::kRest || last.state == State::kFault;
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
            .words = in.words.bemf};
  }
};

}  // namespace steplock
