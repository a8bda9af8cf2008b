// Follow law: what a look at the three back-EMFs says of a rotor, after the looks before it.
//
//     seen   = the step to drive a rotor in the code's sector, as believed: code u v w of the wanted way, inverted
//              of the other
//     turns  = (seen - step) mod 6, counted the wanted way
//
// A code that is not clear, the samples of a terminal near half and half, is no news either until an edge was passed: at
// rest the comparators show their noise.
//
//     belief                 code, turns            then
//     a rotor at rest        000, 111; its code     no news: the comparators' offsets show that code
//                            another one            real; the step is the code's
//     real                   000, 111; 0            no news
//                            at rest, coasting      no news: a rotor that stopped shows its comparators' offsets again
//       the wanted way       +1                     on: one edge passed
//                            -1, just passed one    no news: it chatters on that edge, while it coasts or is followed
//                            -1                     it turns the other way; the opposite step
//       the other way        -1                     on: one edge passed, backwards
//                            +1, just passed one    no news
//                            +1                     it turns the wanted way
//       the wanted way       +2, just passed one    on: an edge went by unseen
//                            -2, for a second time  it turns the other way, two edges between two looks
//       the other way        -2, -2 before          on, backwards: an edge went by unseen
//       either               3                      it turned round: the same step is right as it is
//                            all else               the wanted way; the code's step
//     no news `still` times                         a dead centre: a neighbour of this step, as with a rotor at rest, the one
//                                                   after it and the one before it in turn.  For a second time in a row:
//                                                   its other neighbour, two steps from the last.  For a third: blocked
//
// So a rotor that nothing moves gets three steps in a row of the ring, and whatever its angle one of them gives at least
// 0.87 of the current's torque.  One way or the other: a rotor held opposite to its step needs the step before.
//
// "Just passed one": since the belief began.  A drive ends it for a rotor that has passed one edge the wanted way: near standstill
// an offset may have feigned that one, and an edge back is a real one then.  Two edges on the wanted way in a row: the rotor is
// followed.  From the second on `changed` tells that the time since the one before is an interval.
//
// Until then a new step the wanted way is not driven at once: kCoast looks follow each other first, and count for no `still`.
// A rotor that is fast after its first sector tells its direction in that time and is not made faster; to a slow one three looks
// are a moment, and a sector more may carry even a light one past its set speed.  So one that passed its first edge after few
// drives is `light`: RotorFollower gives it more time to show its second.  A heavy one takes long to be turned round: where a
// belief turns that had lasted for kLasts looks, `still` begins anew, once between two news, since codes that quiver turn it for
// ever.
//
//     latency      none     registers    those of Belief: 24 bits     multipliers  none
//
// Doc: docs/blocks/rotor_follower.md   Test: tests/hls/follow_law_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/divide_by_n.hpp"

namespace steplock {

struct FollowLaw {
  static constexpr int kCoast = 3, kLasts = 4;  // looks

  struct Belief {
    bool looked = false;  // there was a look, and `rest` is its code
    bool real = false;    // a code was seen that is not that of a rotor at rest
    bool back = false;    // it turns the other way
    bool moved = false;   // and passed an edge since that is believed
    bool far = false;     // the code before this one was two edges the other way
    UInt<2> edges = 0;    // passed the wanted way in a row, up to 3
    UInt<3> rest = 0;     // code u v w of the rotor at rest
    UInt<8> idle = 0;     // looks without news
    UInt<2> stood = 0;    // times that it was too many of them, in a row
    bool onward = false;  // the last time the way onward was taken, not the way back
    bool turned = false;  // since the last news a belief that had lasted turned
    UInt<2> coast = 0;    // looks to come before a drive, up to kCoast
    bool sure() const { return edges.bit(1); }
    // It passed one edge the wanted way, after few drives.
    bool light() const { return edges == 1 && idle < kLasts; }
    bool operator==(const Belief&) const = default;
  };

  // What a code is beside the step that was driven, as believed.
  struct Sight {
    bool legal = false;     // neither 000 nor 111, and clear or of a rotor that has passed an edge
    bool clear = false;     // hardly a sample said otherwise
    bool rests = false;     // the code of the rotor at rest
    bool here = false;      // turns are 0
    bool on = false;        // one edge as believed
    bool skipped = false;   // or two: of a rotor that moves, or that did so before the other way
    bool far = false;       // two the other way
    bool contrary = false;  // one the other way
    bool across = false;    // three
    bool tired = false;     // no news once more would be `still`
    bool operator==(const Sight&) const = default;
  };

  struct News {
    Belief belief;
    bool goes = false;     // another step is to be driven
    bool stands = false;   // a neighbour, without news
    bool changed = false;  // a rotor that is followed passed an edge
    bool blocked = false;  // three steps in a row moved nothing
  };

  // The step whose crossing ends the sector of this code, for a rotor that turns the wanted way: forward sectors and
  // steps have the same numbers; backwards the step is one less.  Codes and sectors as HallDecoder has them.
  static constexpr Step step_of(UInt<3> code, bool reverse) {
    switch (int(code.raw())) {
      case 0b101: return reverse ? Step(5) : Step(0);
      case 0b100: return reverse ? Step(0) : Step(1);
      case 0b110: return reverse ? Step(1) : Step(2);
      case 0b010: return reverse ? Step(2) : Step(3);
      case 0b011: return reverse ? Step(3) : Step(4);
      default: return reverse ? Step(4) : Step(5);
    }
  }
  // The code for which that is the step.
  static constexpr UInt<3> code_of(Step step, bool reverse) {
    switch (int((reverse ? next_step(step, false) : step).raw())) {
      case 0: return 0b101;
      case 1: return 0b100;
      case 2: return 0b110;
      case 3: return 0b010;
      case 4: return 0b011;
      default: return 0b001;
    }
  }
  static constexpr UInt<3> bits(bool u, bool v, bool w) { return UInt<3>(u) << 2 | UInt<3>(v) << 1 | UInt<3>(w); }
  static constexpr Step step_of(UInt<3> code, bool reverse, bool back) {
    return step_of(back ? code ^ UInt<3>(7) : code, reverse);
  }

  // The codes are a ring of which each edge turns one bit, w, v, u, w, v, u from sector 0 on.  So which bits differ from
  // the code that would be no news tells the turns: that edge's, its neighbour's, both (two edges), none or all.
  static constexpr Sight see(UInt<3> code, bool clear, Step step, bool reverse, const Belief& was, UInt<8> still) {
    const UInt<3> other = code ^ code_of(step, reverse) ^ (was.back ? UInt<3>(7) : UInt<3>(0));
    const bool w = step == 0 || step == 3, v = step == 1 || step == 4, u = !w && !v;
    const UInt<3> ahead = bits(u, v, w), behind = reverse ? bits(v, w, u) : bits(w, u, v);
    return {.legal = code != 0 && code != 7 && (clear || was.edges != 0),
            .clear = clear,
            .rests = code == was.rest,
            .here = other == 0,
            .on = other == (was.back ? behind : ahead),
            .skipped = was.back ? other == (ahead ^ UInt<3>(7)) && was.far : other == (behind ^ UInt<3>(7)) && was.moved,
            .far = other == (ahead ^ UInt<3>(7)),
            .contrary = other == (was.back ? ahead : behind),
            .across = other == 7,
            .tired = was.coast == 0 && was.idle + 1 >= still};
  }

  static constexpr News judge(const Belief& was, const Sight& sight, UInt<3> code) {
    Belief now = was;
    const bool on = sight.on || sight.skipped;
    const bool stopped = sight.rests && was.coast != 0;
    bool news = false, goes = false;
    if (!was.real) {
      const bool first = !was.looked;
      now.looked = true;
      if (first) now.rest = at_rest(sight, code);
      now.real = !first && sight.legal && !sight.rests;
      now.back = now.moved = false;
      news = goes = sight.legal && (first || !sight.rests);
    } else if (sight.legal && !sight.here && !stopped) {
      now.far = sight.far;
      if (on) {
        now.moved = true;
        now.edges = was.back || was.edges == 3 ? was.edges : wrap<UInt<2>>(was.edges + 1);
        news = was.edges != 0 || was.back;
        goes = true;
      } else if (!sight.contrary || !chatters(was)) {
        now.back = (sight.contrary || sight.across || (sight.far && was.far)) && !was.back;
        now.moved = false;
        now.edges = 0;
        goes = !sight.across;
      }
    }
    const bool turns = now.back != was.back;
    const bool waits = turns && !was.turned && was.idle >= kLasts;
    const bool stands = !news && !waits && sight.tired;
    now.coast = goes && now.real && !now.back && !turns && !now.sure() ? UInt<2>(kCoast) : turns ? UInt<2>(0) : less(was.coast);
    now.turned = !news && (waits || was.turned);
    now.idle = news || waits ? UInt<8>(0) : was.coast != 0 ? was.idle : wrap<UInt<8>>(was.idle + 1);
    if (news) now.stood = 0;
    if (stands) now = {.looked = true, .rest = at_rest(sight, code), .stood = wrap<UInt<2>>(was.stood + 1), .onward = !was.onward};
    return {.belief = now,
            .goes = goes || stands,
            .stands = stands,
            .changed = sight.on && sight.legal && !stopped && was.real && !was.back && was.edges != 0,
            .blocked = stands && was.stood == 2};
  }

  // The edge just passed may be seen once more.  An offset may have feigned it to a rotor near standstill, and the drive
  // that followed turned that one back: so no longer than it coasts.
  static constexpr bool chatters(const Belief& was) {
    return was.moved && (was.sure() || was.back || was.coast != 0);
  }
  static constexpr UInt<2> less(UInt<2> looks) { return looks == 0 ? looks : wrap<UInt<2>>(looks - 1); }

  // What is not clear is the code of no sector.
  static constexpr UInt<3> at_rest(const Sight& sight, UInt<3> code) { return sight.clear ? code : UInt<3>(0); }

  // The step to drive after that.
  static constexpr Step step_after(const News& news, UInt<3> code, Step step, bool reverse) {
    if (!news.stands) return step_of(code, reverse, news.belief.back);
    const bool way = reverse == news.belief.onward;
    const Step neighbour = next_step(step, way);
    return news.belief.stood == 2 ? next_step(neighbour, way) : neighbour;
  }
};

}  // namespace steplock
