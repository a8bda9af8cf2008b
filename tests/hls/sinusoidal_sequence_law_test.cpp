// The sinusoidal sequence against its law, in every clock: random hosts, rotors and words, until every arrow was taken.  The law is written
// by source state, from docs/sinusoidal.md; counters are plain numbers that do not go below zero.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "hls/sinusoidal/sinusoidal_sequence.hpp"
#include "tests/hls/random_config.hpp"

namespace steplock {
namespace {

using S = SinusoidalState;
using R = SinusoidalReason;
using In = SinusoidalSequence::In;
using Out = SinusoidalSequence::Out;

struct Law {
  S at = S::kIdle;
  R reason = R::kNone;
  int timer = 0, trust = 0, retries = 0, periods_of_loop = 0, place = 0;
  bool on_times = false, reverse = false, refused = false, entered = false;

  static bool regulates(S s) { return s == S::kStarting || s == S::kRun || s == S::kSlowDown; }

  Out shown() const {
    Out out;
    out.state = at, out.reason = reason, out.entered = entered, out.reverse = reverse, out.retries = UInt<4>(retries);
    out.slow_down = at == S::kSlowDown;
    switch (at) {
      case S::kCalibrate: out.calibrate = true; break;
      case S::kPilot: out.pilot = out.hold = out.hold_u = true; break;
      case S::kPattern:
        out.hold = out.modulate = true;
        out.hold_u = place > 0;                 // of three places the last two
        (reverse ? out.hold_v : out.hold_w) = place < 2;
        break;
      case S::kBrake: out.brake = true; break;
      default: break;
    }
    if (regulates(at)) {
      out.regulate = true;
      out.modulate = periods_of_loop >= 1;
      out.estimate = periods_of_loop >= 2;
      out.locked = at != S::kStarting;
    }
    return out;
  }

  void enter(S s, R why) { at = s, reason = why, entered = true; }
  void enter(S s) { enter(s, reason); }
  void wait(S s, Periods periods) { timer = int(periods.raw()), enter(s); }
  void fail(R why, const SequenceConfig& w) {
    const bool last = retries >= int(w.retries.raw());
    timer = int(w.retry_delay.raw());
    retries += !last;
    enter(last ? S::kFault : S::kRetryDelay, why);
  }
  void turn(const SequenceConfig& w) {
    wait(S::kStarting, w.give_up);
    trust = int(w.lock.raw()), periods_of_loop = 0, on_times = false;
  }

  void clock(const In& in) {
    const SequenceConfig& w = in.config;
    const bool over = timer == 0, trusted = trust == 0;
    entered = false;
    timer -= in.period && timer > 0;
    periods_of_loop = std::min(3, periods_of_loop + (in.period && on_times));
    on_times = on_times || (in.sampled && regulates(at));
    if (in.sampled && (!in.fast || !in.plausible)) trust = int(w.lock.raw());
    trust -= in.period && trust > 0;
    refused = in.command.run && (refused || !in.command.configured);

    const bool run = in.command.run && in.command.configured && !refused && !in.still;
    const bool leave = !run || in.command.reverse != reverse;
    if (at == S::kFault) {
      if (in.command.clear_fault && !in.command.run && !in.fault_pin) enter(S::kIdle);
      return;
    }
    if (in.fault_pin) return enter(S::kFault, R::kFaultPin);
    if (in.fatal != R::kNone) return enter(S::kFault, in.fatal);
    if (!in.command.configured) {
      if (at != S::kIdle) enter(S::kIdle);
      return;
    }
    switch (at) {
      case S::kIdle:
        if (run) reverse = in.command.reverse, retries = 0, enter(S::kCalibrate, R::kNone);
        return;
      case S::kCalibrate:
        if (!run) return enter(S::kIdle);
        if (!in.measured) return;
        if (w.arbitrary) return turn(w);
        place = 0;
        return wait(w.pilot ? S::kPilot : S::kPattern, w.pattern);
      case S::kPilot:
        return !run                     ? enter(S::kIdle)
               : in.failed != R::kNone ? fail(in.failed, w)
               : in.found              ? turn(w)
               : over                  ? fail(R::kNoDecay, w)
                                       : void();
      case S::kPattern:
        if (!run) return enter(S::kIdle);
        if (!over) return;
        if (place == 2) return turn(w);
        ++place, timer = int(w.pattern.raw());
        return;
      case S::kStarting:
        return leave                    ? wait(S::kBrake, w.brake)
               : in.failed != R::kNone ? fail(in.failed, w)
               : trusted               ? enter(S::kRun)
               : over                  ? fail(R::kNoLock, w)
                                       : void();
      case S::kRun:
        if (in.failed != R::kNone) return fail(in.failed, w);
        if (leave) enter(run || in.command.brake_to_stop || in.still ? S::kSlowDown : S::kIdle);
        return;
      case S::kSlowDown: return !leave ? enter(S::kRun) : in.stopping ? wait(S::kBrake, w.brake) : void();
      case S::kBrake: return over ? enter(S::kIdle) : void();
      case S::kRetryDelay: return !run ? enter(S::kIdle) : over ? enter(S::kCalibrate) : void();
      default: return;
    }
  }
};

class Stimulus : public RandomConfig {
 public:
  using RandomConfig::RandomConfig;

  // Each input for some clocks, most of them as in a start that gets somewhere.
  void change(In& in) {
    if (one_in(200)) {
      SequenceConfig& w = in.config;
      w.pattern = below(4), w.lock = below(4), w.give_up = one_in(4) ? below(3) : 20, w.brake = below(4), w.retry_delay = below(4);
      w.retries = below(3), w.arbitrary = one_in(3), w.pilot = one_in(2);
    }
    if (one_in(40)) in.command.run = !one_in(4);
    if (one_in(300)) in.command.reverse = one_in(2);
    if (one_in(60)) in.command.configured = !one_in(8);
    in.command.brake_to_stop = one_in(2), in.command.clear_fault = one_in(4);
    in.period = one_in(3), in.sampled = one_in(3);
    in.measured = one_in(2);
    if (one_in(20)) in.fast = !one_in(3);
    if (one_in(20)) in.plausible = !one_in(3);
    in.stopping = one_in(6), in.found = one_in(6);
    if (one_in(30)) in.still = one_in(5);
    in.fault_pin = one_in(400);
    in.fatal = one_in(400) ? R::kOverCurrent : R::kNone;
    in.failed = one_in(60) ? R::kEmf : R::kNone;
  }
};

std::string text(const Out& o) {
  std::string t = std::to_string(int(o.state)) + ' ' + std::to_string(int(o.reason)) + ' ';
  for (const bool b : {o.entered, o.reverse, o.calibrate, o.pilot, o.hold, o.hold_u, o.hold_v, o.hold_w, o.regulate, o.estimate, o.modulate,
                       o.brake, o.slow_down, o.locked}) {
    t += b ? '1' : '0';
  }
  return t + ' ' + std::to_string(int(o.retries.raw()));
}

// Clocks until the two differ, of a million; 0 if they never do.
int difference(const std::function<void(Out&, int)>& spoil = {}, std::map<std::pair<S, S>, int>* arrows = nullptr) {
  Stimulus any(1);
  SinusoidalSequence dut;
  Law law;
  In in;
  for (int clock = 1; clock <= 1'000'000; ++clock) {
    any.change(in);
    Out out = dut.tick(in);
    if (spoil) spoil(out, clock);
    if (text(out) != text(law.shown())) return clock;
    const S was = law.at;
    law.clock(in);
    if (arrows != nullptr && law.entered) ++(*arrows)[{was, law.at}];
  }
  return 0;
}

TEST(SinusoidalSequenceLaw, TheMachineIsTheLawInEveryClockAndEveryArrowIsTaken) {
  std::map<std::pair<S, S>, int> arrows;
  EXPECT_EQ(difference({}, &arrows), 0);
  // From idle 2, calibrate 5, pilot 4, pattern 3, starting 5, run 4, slow_down 4, brake 2, retry_delay 3, fault 1.
  for (const auto& [arrow, times] : arrows) EXPECT_GT(times, 5) << int(arrow.first) << " to " << int(arrow.second);
  EXPECT_EQ(arrows.size(), 33u);
}

// The control: one output that is another, in one clock.
TEST(SinusoidalSequenceLaw, AnOutputThatDiffersIsNoticedAtItsClock) {
  EXPECT_EQ(difference([](Out& out, int clock) { out.locked = out.locked != (clock == 123'456); }), 123'456);
}

}  // namespace
}  // namespace steplock
