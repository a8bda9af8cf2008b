// What a look says, line by line of FollowLaw's table.
#include "hls/six_step/follow_law.hpp"

#include <gtest/gtest.h>

#include "hls/six_step/hall_decoder.hpp"
#include "tests/hls/follow_law_look.hpp"

namespace steplock {
namespace {

using namespace test;

TEST(FollowLaw, StepAndSectorHaveOneNumberForwardAndTheStepIsOneLessBackwards) {
  for (int s = 0; s < 6; ++s) {
    EXPECT_EQ(FollowLaw::step_of(kCodes[s], false), Step(s));
    EXPECT_EQ(FollowLaw::step_of(kCodes[s], true), Step((s + 5) % 6));
  }
}

// Looks without news are counted on through the first edge of a rotor, which anything may have feigned.
TEST(FollowLaw, TheFirstEdgeForwardIsNoNewsAndEachFurtherOneIs) {
  for (const bool back : {false, true}) {
    for (int edges = 0; edges < 4; ++edges) {
      const FollowLaw::Belief was{.looked = true, .real = true, .back = back, .edges = edges, .idle = 7};
      const auto news = FollowLaw::judge(was, {.legal = true, .on = true}, kCodes[1]);
      EXPECT_EQ(news.belief.idle, edges == 0 && !back ? 8 : 0) << edges << back;
      EXPECT_TRUE(news.goes);
    }
  }
}

// A belief that lasted for four looks or more turns with a wait: what comes next is counted anew.
TEST(FollowLaw, ABeliefThatLastedFourLooksTurnsOnceWithAWait) {
  for (const int idle : {0, 3, 4, 5, 200}) {
    const FollowLaw::Belief was{.looked = true, .real = true, .idle = idle};
    const auto news = FollowLaw::judge(was, {.legal = true, .contrary = true}, kCodes[5]);
    EXPECT_TRUE(news.belief.back) << idle;
    EXPECT_EQ(news.belief.turned, idle >= 4) << idle;
    EXPECT_EQ(news.belief.idle, idle >= 4 ? 0 : idle + 1) << idle;
  }
}

// One edge the wanted way, few drives after the rotor was seen to move: not before it, and not once it is followed.
TEST(FollowLaw, ARotorIsLightThatPassedItsFirstEdgeWithinFourLooks) {
  for (int edges = 0; edges < 4; ++edges) {
    for (const int idle : {0, 1, 3, 4, 7, 8, 255}) {
      const FollowLaw::Belief belief{.edges = edges, .idle = idle};
      EXPECT_EQ(belief.light(), edges == 1 && idle < 4) << edges << " " << idle;
    }
  }
}

// Of every code, step, direction and belief: what see() tells from bits is the difference of steps, modulo six.
TEST(FollowLaw, TheBitsThatDifferTellTheTurns) {
  for (int k = 0; k < 1 << 10; ++k) {
    const bool reverse = (k & 1) != 0, back = (k & 2) != 0, moved = (k & 4) != 0, far = k >> 9 != 0;
    const int step = k >> 3 & 7, sector = k >> 6 & 7;
    if (step > 5 || sector > 5) continue;
    const int code = back ? kCodes[sector] ^ 7 : kCodes[sector];
    const int seen = reverse ? (sector + 5) % 6 : sector;
    const int turns = ((reverse ? step - seen : seen - step) + 6) % 6;
    const auto sight = FollowLaw::see(code, true, step, reverse, {.back = back, .moved = moved, .far = far}, kStill);
    EXPECT_TRUE(sight.legal);
    EXPECT_EQ(sight.here, turns == 0) << k;
    EXPECT_EQ(sight.on, turns == (back ? 5 : 1)) << k;
    EXPECT_EQ(sight.contrary, turns == (back ? 1 : 5)) << k;
    EXPECT_EQ(sight.skipped, back ? turns == 4 && far : turns == 2 && moved) << k;
    EXPECT_EQ(sight.far, turns == 4) << k;
    EXPECT_EQ(sight.across, turns == 3) << k;
  }
}

// The codes are the Hall decoder's: the same pins, the same sectors.
TEST(FollowLaw, ReadsCodesAsTheHallDecoderDoes) {
  for (const int code : kCodes) {
    HallDecoder decoder;
    HallDecoder::Out out;
    HallDecoder::In in;
    in.u = (code & 4) != 0, in.v = (code & 2) != 0, in.w = (code & 1) != 0;
    for (int i = 0; i < 4; ++i) out = decoder.tick(in);
    EXPECT_EQ(FollowLaw::step_of(code, false), out.sector);
  }
}

TEST(FollowLaw, TheFirstCodeIsThatOfARotorAtRestAndGivesTheStep) {
  const auto news = look({}, kCodes[4], 1);
  EXPECT_TRUE(news.goes);
  EXPECT_EQ(news.step, Step(4));
  EXPECT_TRUE(news.belief.looked);
  EXPECT_FALSE(news.belief.real);
  EXPECT_EQ(news.belief.rest, UInt<3>(kCodes[4]));
}

TEST(FollowLaw, TheSameCodeAgainIsNoNewsAndAnotherOneIsReal) {
  const Belief rest = look({}, kCodes[4], 1).belief;
  const auto same = look(rest, kCodes[4], 4);
  EXPECT_FALSE(same.goes);
  EXPECT_EQ(same.belief.idle, UInt<8>(1));
  const auto other = look(rest, kCodes[5], 4);
  EXPECT_TRUE(other.goes && other.belief.real);
  EXPECT_EQ(other.step, Step(5));
  EXPECT_FALSE(other.belief.sure());
}

TEST(FollowLaw, IllegalCodesAreARestsCodeOrNoNews) {
  for (const int code : {0, 7}) {
    const auto first = look({}, code, 2);
    EXPECT_FALSE(first.goes);
    EXPECT_TRUE(look(first.belief, kCodes[3], 2).belief.real) << "the first legal one behind it is another one";
    const auto later = look(real({.moved = true, .edges = 3}), code, 2);
    EXPECT_FALSE(later.goes);
    EXPECT_EQ(later.belief.edges, UInt<2>(3));
  }
}

// Noise on comparators of a rotor at rest: whatever it shows, the field stays, and the first clear code is real.
TEST(FollowLaw, ACodeThatIsNotClearIsNoNewsUntilAnEdgeWasPassed) {
  Belief b;
  for (int k = 0; k < 6; ++k) {
    const auto news = look(b, kCodes[k], 1, false, false);
    EXPECT_FALSE(news.goes);
    EXPECT_EQ(news.belief.rest, UInt<3>(0)) << "no sector's";
    b = news.belief;
  }
  EXPECT_TRUE(look(b, kCodes[5], 1).belief.real);
  for (const int edges : {0, 1, 3}) {
    const auto news = look(real({.moved = true, .edges = edges}), kCodes[3], 2, false, false);
    EXPECT_EQ(news.goes, edges > 0) << "a rotor that turns is seen near its crossings, too";
  }
}

TEST(FollowLaw, TwoEdgesTheWantedWayAreEnoughAndTheSecondIsMeasured) {
  Belief b = real();
  for (int edge = 1; edge <= 5; ++edge) {
    const auto news = look(b, kCodes[edge], edge - 1);
    EXPECT_TRUE(news.goes);
    EXPECT_EQ(news.step, Step(edge));
    EXPECT_EQ(news.belief.sure(), edge >= 2);
    EXPECT_EQ(news.changed, edge >= 2);
    b = news.belief;
  }
}

TEST(FollowLaw, AnEdgeTheOtherWayTurnsTheBeliefRoundAndDrivesTheOppositeStep) {
  const auto news = look(real(), kCodes[1], 2);
  EXPECT_TRUE(news.goes && news.belief.back);
  EXPECT_EQ(news.step, Step(4)) << "sector 1 and three on";
}

TEST(FollowLaw, BackOverTheEdgeJustPassedIsChatter) {
  const Belief b = real({.moved = true, .edges = 2});
  const auto news = look(b, kCodes[1], 2);
  EXPECT_FALSE(news.goes || news.belief.back);
  EXPECT_EQ(news.belief.edges, UInt<2>(2));
}

// An offset feigned the edge of a rotor near standstill: after the drive behind it, an edge back is a real one.
TEST(FollowLaw, OfARotorThatIsNotFollowedItIsChatterOnlyWhileThatCoasts) {
  for (const int coast : {1, 3}) {
    const auto news = look(real({.moved = true, .edges = 1, .coast = UInt<2>(coast)}), kCodes[1], 2);
    EXPECT_FALSE(news.goes || news.belief.back) << coast;
  }
  const auto driven = look(real({.moved = true, .edges = 1, .coast = 0}), kCodes[1], 2);
  EXPECT_TRUE(driven.goes && driven.belief.back);
  EXPECT_EQ(driven.step, Step(4)) << "sector 1 and three on";
}

// A rotor that stands again while it coasts shows its comparators' offsets, the code of before the start, as an edge: a drive later the
// same code is believed.
TEST(FollowLaw, TheCodeAtRestIsNoEdgeWhileTheRotorCoasts) {
  for (const int coast : {0, 1, 3}) {
    for (const int sector : {2, 0}) {  // one edge on, and one back
      const auto news = look(real({.rest = kCodes[sector], .coast = UInt<2>(coast)}), kCodes[sector], 1);
      EXPECT_EQ(news.goes, coast == 0) << sector;
      EXPECT_EQ(news.belief.moved || news.belief.back, coast == 0) << sector;
      if (coast != 0) {
        EXPECT_EQ(news.belief.coast, UInt<2>(coast - 1));
      }
    }
    const auto another = look(real({.rest = kCodes[0], .coast = UInt<2>(coast)}), kCodes[2], 1);
    EXPECT_TRUE(another.goes && another.belief.moved) << coast;
  }
}

// It must last there: a belief that turned with every code of a rotor at rest would never move that one.
TEST(FollowLaw, BehindAnEdgeBackwardsItIsChatterHoweverLongItLasts) {
  Belief b = real({.back = true, .moved = true});
  for (int k = 0; k + 1 < int(kStill.raw()); ++k) {
    const auto news = look(b, kCodes[2], 4);  // driven with step 4 for sector 1
    EXPECT_FALSE(news.goes) << k;
    EXPECT_TRUE(news.belief.back) << k;
    b = news.belief;
  }
  EXPECT_TRUE(look(b, kCodes[2], 4).stands);
}

TEST(FollowLaw, ARotorThatGoesOnBackwardsIsFollowedDownwardsAndNeverHandedOver) {
  // Driven with step 4, it is in sector 1; in sector 0 the braking step is 3.
  const auto news = look(real({.back = true}), kCodes[0], 4);
  EXPECT_TRUE(news.goes && news.belief.back && news.belief.moved);
  EXPECT_EQ(news.step, Step(3));
  EXPECT_FALSE(news.belief.sure() || news.changed);
}

TEST(FollowLaw, ACodeThatIsInvertedMeansThatItTurnedRoundAndTheStepStays) {
  for (const bool back : {false, true}) {
    const int sector = back ? 4 : 1;  // whose opposite is the step's
    const auto news = look(real({.back = back}), kCodes[sector], 4);
    EXPECT_FALSE(news.goes);
    EXPECT_EQ(news.belief.back, !back);
  }
}

TEST(FollowLaw, AnEdgeThatWentByUnseenCountsOnlyOfARotorThatMoves) {
  const auto moving = look(real({.moved = true, .edges = 2}), kCodes[4], 2);
  EXPECT_TRUE(moving.goes && moving.belief.sure());
  EXPECT_FALSE(moving.changed) << "two steps are no interval";
  EXPECT_EQ(moving.step, Step(4));
  const auto standing = look(real({.edges = 2}), kCodes[4], 2);
  EXPECT_TRUE(standing.goes);
  EXPECT_FALSE(standing.belief.sure());
}

// A light rotor that its first step drove backwards: two edges between two looks.  Taken for one that turns the wanted
// way, its step would drive it on backwards, look by look.  Once alone tells nothing: a first code may have been noise.
TEST(FollowLaw, TwoEdgesBackwardsBetweenTwoLooksAreBrakedTheSecondTime) {
  for (const bool moved : {false, true}) {
    const auto first = look(real({.moved = moved, .edges = moved ? 2 : 0}), kCodes[0], 2);
    EXPECT_TRUE(first.goes && !first.belief.back);
    EXPECT_EQ(first.step, Step(0));
    const auto second = look(first.belief, kCodes[4], 0);
    EXPECT_TRUE(second.goes && second.belief.back);
    EXPECT_EQ(second.step, Step(1));
    EXPECT_EQ(second.belief.edges, UInt<2>(0));
    const auto third = look(second.belief, kCodes[2], 1);
    EXPECT_TRUE(third.goes && third.belief.back && third.belief.moved);
    EXPECT_EQ(third.step, Step(5));
    EXPECT_FALSE(third.belief.sure() || third.changed);
  }
}

TEST(FollowLaw, AnotherCodeBetweenTwoJumpsBackwardsForgetsTheFirst) {
  Belief b = look(real(), kCodes[0], 2).belief;
  b = look(b, kCodes[1], 0).belief;
  const auto again = look(b, kCodes[5], 1);
  EXPECT_FALSE(again.belief.back);
  EXPECT_FALSE(look(real({.back = true}), kCodes[0], 5).belief.back) << "nor is the first one of a rotor thought to turn back";
}

// Of every belief, code and step: backwards is forward in the mirror, where sectors count down, u and w have changed
// places, and the step's number is 5 less.
TEST(FollowLaw, ReverseIsForwardInTheMirror) {
  const auto mirrored = [](int code) { return (code & 1) << 2 | (code & 2) | (code & 4) >> 2; };
  int cases = 0;
  for (int bits = 0; bits < 1 << 11; ++bits) {
    for (int code = 0; code < 8; ++code) {
      for (int step = 0; step < 6; ++step) {
        Belief b{.looked = (bits & 1) != 0, .real = (bits & 2) != 0, .back = (bits & 4) != 0, .moved = (bits & 8) != 0,
                 .far = (bits & 1 << 10) != 0, .edges = bits >> 4 & 3, .rest = bits >> 6 & 7, .idle = bits % 3 == 0 ? 19 : 3,
                 .stood = bits % 4, .turned = bits % 5 < 2, .coast = bits % 7 % 4};
        const bool clear = (bits & 1 << 9) == 0;
        const auto forward = look(b, code, step, false, clear);
        b.rest = mirrored(bits >> 6 & 7);
        auto back = look(b, mirrored(code), 5 - step, true, clear);
        back.belief.rest = mirrored(int(back.belief.rest.raw()));
        ASSERT_EQ(back.belief, forward.belief) << bits << ' ' << code << ' ' << step;
        ASSERT_EQ(back.goes, forward.goes);
        ASSERT_EQ(back.changed, forward.changed);
        ASSERT_EQ(back.blocked, forward.blocked);
        if (forward.goes) {
          ASSERT_EQ(int(back.step.raw()), 5 - int(forward.step.raw()));
        }
        ASSERT_LT(forward.step, Step(6));
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 2048 * 48);
}

}  // namespace
}  // namespace steplock
