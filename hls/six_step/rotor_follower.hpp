// Rotor follower: a start whose steps follow the rotor, from standstill or from any motion.
//
//     drive    one step for `probe`, or until its crossing; what brakes a rotor that turns the other way for `probe`
//     look     gates off for `look`, until no current flows; then the majority of 15 samples of each
//              comparator is the code of the back-EMFs
//     judge    FollowLaw: what this code says, after those before it, and the step to drive next
//
// A rotor at (theta, forward) and one at (theta + 180, backward) show the same code: the order of the codes
// tells them apart, so one edge must be passed before the direction is known.  A rotor that turns the wanted way is driven
// with the step whose crossing ends its sector: 30 degrees of advance.  One that turns the other way is driven with the
// opposite one, which brakes it and turns it round.  Nothing is timed but by the rotor, so inertia does not matter.
//
// Two edges in a row the wanted way: the rotor is followed (`sure`); from the next one on `changed` measures the
// intervals.  `caught`, at a crossing: fast enough for the PLL, before the last interval already, and that was as long as the
// one before.
//
// Until then a drive follows three looks later where a new step was loaded: a rotor that is fast passes an edge meanwhile.
// Behind the first edge of a light one (FollowLaw) gates stay off for `probe` before each of them, not for `look`.
//
//     times        in units of sample_every clocks: look + 1; 15 before a crossing counts; then probe + 1, or, once
//                  an interval was measured, until the expected one is over by a quarter
//     latency      1 clock: outputs are registers
//     registers    98 bits     multipliers  none
//
// Doc: docs/blocks/rotor_follower.md   Test: tests/hls/rotor_follower_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/one_hot.hpp"
#include "hls/numeric/parameter.hpp"
#include "hls/six_step/divide_by_n.hpp"
#include "hls/six_step/follow_law.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

class RotorFollower {
 public:
  struct In {
    Parameter<true> follows;  // else it is left out: no drive, no news
    bool on = false;          // the start is at it
    bool u = false;           // synchronised comparators: terminal above the reference
    bool v = false;           // see u
    bool w = false;           // see u
    bool crossing = false;    // strobe: the driven step's
    bool elapsed = false;     // strobe: the expected interval is over
    bool quarter = false;     // a quarter of the next one is
    bool update = false;      // strobe: an interval was measured
    bool good = false;        // with `update`: within 1/8 of the one before
    bool fast = false;        // the VCO's frequency is hand_over or more
    bool slow = false;        // it is below stall
    bool steady = false;      // good intervals in a row, almost as many as a lock takes
    Step step = 0;            // 0 to 5: the present one
    bool reverse = false;     // the wanted way: the step counts down
    UInt<8> sample_every = 1; // clocks, the unit of look and probe; 0 counts as 1
    UInt<16> look = 0;        // samples
    UInt<16> probe = 0;       // samples
    UInt<8> still = 0;        // looks
  };

  struct Out {
    bool drive = false;    // gates may be on
    bool load = false;     // strobe: `step` is to be driven next
    Step step = 0;         // 0 to 5
    bool changed = false;  // strobe, with `load`: a rotor that is followed went on to the next sector
    bool restart = false;  // strobe: a drive begins
    bool caught = false;   // strobe: hand over, the crossing is now
    bool sure = false;     // the rotor is followed
    bool moves = false;    // it passed an edge, the way that is believed
    bool blocked = false;  // strobe: three steps in a row moved nothing
    bool operator==(const Out&) const = default;
  };

  Out tick(const In& in) {
    const Out out = out_;
    const bool sure = belief_.sure();
    const bool coasts = at_.holds(Stage::kTurn) && belief_.coast != 0;
    const bool over = strobe_ && none_;
    const bool crossed = at_.holds(Stage::kDrive) && in.crossing && belief_.real && !belief_.back;
    const bool ready = good_ && (in.fast || (in.steady && !in.slow));
    const bool caught = crossed && sure && ready;  // the drive goes on
    const bool late = sure && overdue_ && in.quarter;
    const bool ends = drives() && !caught && (crossed || late || (over && !timed_ && at_.holds(Stage::kDrive)));

    // A look's three questions, a clock each: what it shows, what that means, and which step follows.  The last one
    // stands first, so that each finds what the clock before left.
    const bool loads = at_.holds(Stage::kLoad) && goes_;
    if (at_.holds(Stage::kLoad)) {
      out_.step = FollowLaw::step_after({.belief = belief_, .stands = stands_}, code(), in.step, in.reverse);
    }
    out_.load = loads;
    out_.changed = loads && changes_;
    out_.blocked = false;
    if (at_.holds(Stage::kJudge)) {
      const auto news = FollowLaw::judge(belief_, sight_, code());
      belief_ = news.belief;
      goes_ = news.goes;
      stands_ = news.stands;
      changes_ = news.changed;
      out_.blocked = news.blocked;
    }
    if (at_.holds(Stage::kSee)) sight_ = FollowLaw::see(code(), clear(), in.step, in.reverse, belief_, in.still);
    out_.restart = at_.holds(Stage::kTurn) && !coasts;
    out_.caught = caught;

    sample(in);
    count(in, over, ends, coasts);
    // The expected interval is over: said once, for a look to be taken.
    overdue_ = !loads && !ends && (overdue_ || in.elapsed);
    good_ = sure && (in.update ? in.good && (in.fast || in.steady) : good_);
    timed_ = sure && (in.update || timed_);

    const auto to = [](Stage stage, bool yes) { return Stages(stage).when(yes); };
    const bool drove = drives();
    at_ = to(Stage::kDecay, ends || (at_.holds(Stage::kDecay) && !over) || at_.holds(Stage::kOff) || coasts) |
          to(Stage::kSample, over ? at_.holds(Stage::kDecay) : at_.holds(Stage::kSample)) |
          to(Stage::kSee, at_.holds(Stage::kSample) && over) |
          to(Stage::kJudge, at_.holds(Stage::kSee)) |
          to(Stage::kLoad, at_.holds(Stage::kJudge)) |
          to(Stage::kTurn, at_.holds(Stage::kLoad)) |
          to(Stage::kHold, (at_.holds(Stage::kTurn) && !coasts) || (at_.holds(Stage::kHold) && !over && !ends)) |
          to(Stage::kDrive, (at_.holds(Stage::kHold) && over && !ends) || (at_.holds(Stage::kDrive) && !ends));
    out_.drive = drives() && drove;  // a clock late, when the new step has come to the gates
    out_.sure = sure;
    out_.moves = belief_.moved;
    if (!in.on || !in.follows) *this = RotorFollower{};
    return out;
  }

  // Quiet clocks (docs/theory.md): until this block does more than count, and that many at once.
  std::uint64_t quiet(const In& in) const {
    if (!in.on) return at_.holds(Stage::kOff) ? ~std::uint64_t{0} : 0;
    if (at_.holds_one_of(Stage::kOff, Stage::kSee, Stage::kJudge, Stage::kLoad, Stage::kTurn) || out_.restart || out_.caught) return 0;
    if (drives() != out_.drive) return 0;
    if (strobe_ || prescale_ < 2) return 0;
    const bool last = left_ == 0 || none_ || at_.holds(Stage::kSample);
    return prescale_.raw() - 1 + (last ? 0 : (left_.raw() - 1) * every(in).raw());
  }
  void skip(const In& in, std::uint64_t clocks) {
    if (at_.holds(Stage::kOff)) return;
    const std::uint64_t first = prescale_.raw() - 1;
    if (clocks > first) {
      const std::uint64_t more = clocks - first - 1, period = every(in).raw();
      left_ = wrap<UInt<16>>(left_ - UInt<16>::of(more / period + 1));
      prescale_ = UInt<8>::of(period - more % period);
      strobe_ = prescale_ < 2;
      return;
    }
    prescale_ = UInt<8>::of(prescale_.raw() - clocks);
    strobe_ = prescale_ < 2;
  }
  bool operator==(const RotorFollower&) const = default;

 private:
  enum class Stage : std::uint8_t { kOff, kDecay, kSample, kSee, kJudge, kLoad, kTurn, kHold, kDrive };
  using Stages = OneHot<Stage, 9>;
  static constexpr int kSamples = 15;

  bool drives() const { return at_.holds_one_of(Stage::kHold, Stage::kDrive); }
  static UInt<8> every(const In& in) { return in.sample_every == 0 ? UInt<8>(1) : in.sample_every; }
  // Eight of fifteen: the upper bit.
  UInt<3> code() const { return UInt<3>(u_.bit(3)) << 2 | UInt<3>(v_.bit(3)) << 1 | UInt<3>(w_.bit(3)); }

  // Fewer than four of fifteen said otherwise.
  static bool clear(UInt<4> high) { return high.bit(3) == high.bit(2); }
  bool clear() const { return clear(u_) && clear(v_) && clear(w_); }

  void sample(const In& in) {
    if (at_.holds(Stage::kDecay)) {
      u_ = v_ = w_ = 0;
    } else if (at_.holds(Stage::kSample) && strobe_) {
      u_ = wrap<UInt<4>>(u_ + UInt<1>(in.u));
      v_ = wrap<UInt<4>>(v_ + UInt<1>(in.v));
      w_ = wrap<UInt<4>>(w_ + UInt<1>(in.w));
    }
  }

  // What a stage counts is loaded in the clock that ends the one before it.
  void count(const In& in, bool over, bool ends, bool coasts) {
    const bool loads = at_.holds_one_of(Stage::kOff, Stage::kTurn) || ends ||
                       (over && at_.holds_one_of(Stage::kDecay, Stage::kHold));
    none_ = !loads && left_ == 0;
    if (loads) {
      const bool waits = coasts && belief_.light();
      const bool look = at_.holds(Stage::kOff) || ends || (coasts && !waits);
      left_ = look ? in.look : waits || at_.holds(Stage::kHold) ? in.probe : UInt<16>(kSamples - 1);
    } else if (strobe_ && !none_) {
      left_ = wrap<UInt<16>>(left_ - 1);
    }
    prescale_ = strobe_ ? every(in) : wrap<UInt<8>>(prescale_ - 1);
    strobe_ = prescale_ < 2;
  }

  Stages at_ = Stage::kOff;
  UInt<8> prescale_ = 0;  // clocks to the next strobe
  bool strobe_ = true;    // it is 1 or 0
  UInt<16> left_ = 0;     // strobes left of the stage
  bool none_ = false;     // there were none, a clock ago
  UInt<4> u_ = 0;         // samples of this look that were high
  UInt<4> v_ = 0;         // see u_
  UInt<4> w_ = 0;         // see u_
  FollowLaw::Belief belief_;
  FollowLaw::Sight sight_;  // of this look
  bool goes_ = false;       // what was judged of it: another step
  bool stands_ = false;     // a neighbour, for want of news
  bool changes_ = false;    // a rotor that is followed passed an edge
  bool overdue_ = false;  // the expected interval is over
  bool timed_ = false;    // an interval was measured: there is one to expect
  bool good_ = false;     // the last interval was as long as the one before
  Out out_;
};

}  // namespace steplock
