// The start sequence's machine against its law, in every clock: random hosts, rotors and words, until every arrow was taken.
#include "hls/six_step/start_sequence_law.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <utility>

#include "tests/hls/random_config.hpp"

namespace steplock {
namespace {

using In = StartSequence::In;

class Stimulus : public RandomConfig {
 public:
  using RandomConfig::RandomConfig;

  StartConfig config() {
    StartConfig w;
    w.method = one_in(2) ? Method::kFollow : Method::kRamp;
    w.pre_align = below(4), w.align = below(4), w.detect_spin = one_in(4) ? 0 : 1 + below(8), w.pull_in = below(8), w.slow_down = below(8);
    w.brake = below(4), w.retry_delay = below(4), w.retries = below(3), w.good_crossings = 1 + below(3);
    return w;
  }
  // Each input for some clocks, most of them as in a start that gets somewhere.
  void change(In& in) {
    if (one_in(200)) in.config = config(), in.source = one_in(4) ? Source::kHall : Source::kBemf;
    if (one_in(60)) in.command.run = !one_in(5);
    if (one_in(60)) in.command.reverse = one_in(3);
    if (one_in(60)) in.command.brake_to_stop = one_in(2);
    if (one_in(60)) in.command.configured = !one_in(10);
    if (one_in(60)) in.still = one_in(8);
    if (one_in(10)) in.command.clear_fault = one_in(3);
    if (one_in(10)) in.fast = one_in(2), in.slow = one_in(4), in.turns_reverse = one_in(3), in.sector = below(6), in.at = below(6);
    in.cause = Reason(1 + below(9));
    in.fatal = one_in(150), in.lost = one_in(80), in.blocked = one_in(60), in.caught = one_in(20);
    in.moves = one_in(2), in.sure = one_in(2), in.follower_drives = one_in(2), in.lags = one_in(2);
    in.tick = one_in(3), in.update = one_in(3), in.good = !one_in(4), in.commutate = one_in(4);
  }
};

// What the phase detector is to look at: decided with the state, from the words of the clock before.  A rotor that is followed is
// looked at from the second clock on.
struct Looks {
  State from = State::kIdle;
  bool hall = false, follows = false;  // of the clock before

  DetectorSource at(State now) const {
    const bool runs = now == State::kRun || now == State::kSlowDown;
    if (now == State::kDetectSpin || (runs && hall)) return DetectorSource::kSectors;
    if (now == State::kAccelerate && from == State::kAccelerate && follows) return DetectorSource::kSectors;
    return now == State::kPullIn || runs ? DetectorSource::kCrossings : DetectorSource::kNone;
  }
};

// The VCO counts while a spin is detected, and while the bridge commutates.
bool turns(State s) {
  return s == State::kDetectSpin || s == State::kAccelerate || s == State::kPullIn || s == State::kRun || s == State::kSlowDown;
}

// Clocks in which machine and law differ; `seen` counts what was taken: from, to.
using Arrows = std::map<std::pair<State, State>, int>;
int differences(Stimulus any, int clocks, bool detects_spin, Arrows* seen = nullptr, const std::function<void(In&)>& spoil = [](In&) {}) {
  StartSequence dut;
  StartSequenceLaw law;
  StartCounters counters;
  Looks looks;
  In in;
  in.detects_spin = detects_spin;
  in.config = any.config();
  in.command.configured = true;
  int differ = 0, same = 0;
  for (int k = 0; k < clocks; ++k) {
    any.change(in);
    In other = in;
    spoil(other);
    const State from = law.at;
    const auto counts = counters.tick({.tick = other.tick,
                                       .state = States(law.at),
                                       .entered = law.entered,
                                       .failed = law.failed,
                                       .braking = law.braking,
                                       .update = other.update,
                                       .good = other.good,
                                       .turns_reverse = other.turns_reverse,
                                       .hopeful = other.moves,
                                       .config = other.config});
    const auto out = dut.tick(in);
    differ += out.state != law.at || out.reason != law.reason || out.reverse != law.reverse || out.load_step != law.load_step ||
              out.began != law.began || out.failed != law.failed ||
              out.running != (law.at == State::kRun || law.at == State::kSlowDown) || out.detector_source != looks.at(law.at) ||
              out.turn_vco != turns(law.at);
    looks = {.from = law.at, .hall = other.source == Source::kHall, .follows = other.config.method == Method::kFollow};
    law.clock(other, counts);
    if (seen != nullptr) ++(*seen)[{from, law.at}];
    // A fault that is latched needs a host that knows how to clear it, and a drive that idles one that starts it.
    same = law.at == from ? same + 1 : 0;
    if (same > 200) {
      in.still = in.fatal = false;
      in.command.configured = true;
      in.command.run = law.at != State::kFault;
      in.command.clear_fault = law.at == State::kFault && !in.command.clear_fault;
    }
  }
  return differ;
}

TEST(StartSequenceLaw, IsWhatTheMachineDoesByEveryArrow) {
  Arrows seen;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    ASSERT_EQ(differences(Stimulus(seed), 100'000, true, &seen), 0) << seed;
    ASSERT_EQ(differences(Stimulus(seed), 20'000, false), 0) << seed;
  }
  using S = State;
  const std::pair<S, S> arrows[] = {
      {S::kIdle, S::kDetectSpin}, {S::kIdle, S::kRun}, {S::kIdle, S::kPreAlign}, {S::kIdle, S::kAccelerate},
      {S::kIdle, S::kFault}, {S::kDetectSpin, S::kRun}, {S::kDetectSpin, S::kBrake}, {S::kDetectSpin, S::kPreAlign},
      {S::kDetectSpin, S::kAccelerate}, {S::kDetectSpin, S::kIdle}, {S::kDetectSpin, S::kFault}, {S::kBrake, S::kDetectSpin},
      {S::kBrake, S::kAccelerate}, {S::kBrake, S::kPreAlign}, {S::kBrake, S::kRun}, {S::kBrake, S::kIdle},
      {S::kBrake, S::kFault}, {S::kPreAlign, S::kAlign}, {S::kPreAlign, S::kAccelerate}, {S::kPreAlign, S::kIdle},
      {S::kPreAlign, S::kFault}, {S::kAlign, S::kAccelerate}, {S::kAlign, S::kIdle}, {S::kAlign, S::kFault},
      {S::kAccelerate, S::kPullIn}, {S::kAccelerate, S::kRetryDelay}, {S::kAccelerate, S::kIdle}, {S::kAccelerate, S::kFault},
      {S::kPullIn, S::kRun}, {S::kPullIn, S::kRetryDelay}, {S::kPullIn, S::kIdle}, {S::kPullIn, S::kFault},
      {S::kRun, S::kSlowDown}, {S::kRun, S::kRetryDelay}, {S::kRun, S::kIdle}, {S::kRun, S::kFault}, {S::kSlowDown, S::kRun},
      {S::kSlowDown, S::kBrake}, {S::kSlowDown, S::kRetryDelay}, {S::kSlowDown, S::kIdle}, {S::kSlowDown, S::kFault},
      {S::kRetryDelay, S::kDetectSpin}, {S::kRetryDelay, S::kRun}, {S::kRetryDelay, S::kPreAlign},
      {S::kRetryDelay, S::kAccelerate}, {S::kRetryDelay, S::kIdle}, {S::kRetryDelay, S::kFault}, {S::kFault, S::kIdle}};
  for (const auto& arrow : arrows) EXPECT_GT(seen[arrow], 0) << int(arrow.first) << " to " << int(arrow.second);
  int moves = 0;
  for (const auto& [arrow, count] : seen) moves += count > 0 && arrow.first != arrow.second;
  EXPECT_EQ(moves, int(std::size(arrows))) << "and there is no other";
}

// The comparison sees each input.
TEST(StartSequenceLaw, ADifferenceIsFound) {
  const auto found = [](const std::function<void(In&)>& spoil) { return differences(Stimulus(7), 20'000, true, nullptr, spoil) > 0; };
  EXPECT_TRUE(found([](In& in) { in.command.reverse = false; }));
  EXPECT_TRUE(found([](In& in) { in.command.brake_to_stop = false; }));
  EXPECT_TRUE(found([](In& in) { in.command.configured = true; }));
  EXPECT_TRUE(found([](In& in) { in.command.clear_fault = false; }));
  EXPECT_TRUE(found([](In& in) { in.still = false; }));
  EXPECT_TRUE(found([](In& in) { in.slow = false; }));
  EXPECT_TRUE(found([](In& in) { in.blocked = false; }));
  EXPECT_TRUE(found([](In& in) { in.fatal = false; }));
  EXPECT_TRUE(found([](In& in) { in.lost = false; }));
  EXPECT_TRUE(found([](In& in) { in.caught = false; }));
  EXPECT_TRUE(found([](In& in) { in.cause = Reason::kNone; }));
  EXPECT_TRUE(found([](In& in) { in.source = Source::kBemf; }));
}

}  // namespace
}  // namespace steplock
