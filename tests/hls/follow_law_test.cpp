// What a look says, line by line of FollowLaw's table.
#include "hls/six_step/follow_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "hls/six_step/hall_decoder.hpp"

namespace steplock {
namespace {

using Belief = FollowLaw::Belief;

constexpr UInt<8> kStill = 20;
constexpr std::array<int, 6> kCodes = {0b101, 0b100, 0b110, 0b010, 0b011, 0b001};  // of sectors 0 to 5

struct Look : FollowLaw::News {
  Step step = 0;
};
Look look(const Belief& was, int code, int step, bool reverse = false, bool clear = true) {
  const auto news = FollowLaw::judge(was, FollowLaw::see(code, clear, step, reverse, was, kStill), code);
  return {news, FollowLaw::step_after(news, code, step, reverse)};
}
Belief real(Belief b = {}) {
  b.looked = b.real = true;
  return b;
}

TEST(FollowLaw, StepAndSectorHaveOneNumberForwardAndTheStepIsOneLessBackwards) {
  for (int s = 0; s < 6; ++s) {
    EXPECT_EQ(FollowLaw::step_of(kCodes[s], false), Step(s));
    EXPECT_EQ(FollowLaw::step_of(kCodes[s], true), Step((s + 5) % 6));
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

TEST(FollowLaw, WithoutNewsForLongTheStepMovesOn) {
  Belief b = look({}, kCodes[2], 0).belief;
  for (int i = 1; i < 20; ++i) {
    const auto news = look(b, kCodes[2], 2);
    ASSERT_FALSE(news.goes) << i;
    b = news.belief;
  }
  const auto news = look(b, kCodes[2], 2);
  EXPECT_TRUE(news.goes);
  EXPECT_EQ(news.step, Step(3));
  EXPECT_FALSE(news.belief.real);
  EXPECT_EQ(news.belief.idle, UInt<8>(0));
}

// A rotor that friction holds opposite to its step goes the wrong way with the next one, and there it is held again.
TEST(FollowLaw, EachTimeThatTheStepMovesOnItGoesTheOtherWay) {
  for (const bool reverse : {false, true}) {
    const UInt<3> code = FollowLaw::code_of(2, reverse);
    Belief b;
    for (const int expected : {+1, -1, +1}) {
      FollowLaw::News news;
      for (int i = 0; i < 21 && !news.stands; ++i) {
        news = FollowLaw::judge(b, FollowLaw::see(code, true, 2, reverse, b, 20), code);
        b = news.belief;
      }
      const int way = reverse ? -1 : 1;
      EXPECT_EQ(FollowLaw::step_after(news, code, 2, reverse), Step((2 + way * expected + 6) % 6)) << expected;
      b = {.looked = true, .real = true, .edges = 1, .onward = b.onward};  // it turned meanwhile
    }
  }
}

// Of three steps in a row of the ring one pulls a rotor, one way or the other, by 0.87 of all at any angle; of two, half.
TEST(FollowLaw, OfThreeStepsThatMoveNothingTheThirdIsTheFirstOnesOtherNeighbour) {
  for (const bool reverse : {false, true}) {
    for (const bool onward : {false, true}) {
      Belief b{.looked = true, .onward = onward};
      std::vector<int> driven;
      Step step = 2;
      bool blocked = false;
      while (!blocked) {
        driven.push_back(int(step.raw()));
        FollowLaw::News news;
        do {
          b = (news = look(b, 0, int(step.raw()), reverse)).belief;
          ASSERT_LT(b.idle, kStill);
        } while (!news.stands);
        step = FollowLaw::step_after(news, 0, step, reverse);
        blocked = news.blocked;
      }
      ASSERT_EQ(driven.size(), 3u);
      EXPECT_EQ(driven[1], reverse == onward ? 3 : 1);
      EXPECT_EQ(driven[2], reverse == onward ? 1 : 3);
      for (int angle = 0; angle < 360; ++angle) {
        const auto pull = [&](int k) { return std::abs(std::sin((angle - 60 * k) * std::numbers::pi / 180)); };
        EXPECT_GE(std::max({pull(driven[0]), pull(driven[1]), pull(driven[2])}), std::sqrt(0.75) - 1e-12) << angle;
      }
    }
  }
}

TEST(FollowLaw, ThreeStepsInARowThatMoveNothingAreABlockedRotor) {
  const auto still = [](Belief b, int code) {
    FollowLaw::News news;
    for (int i = 0; i < 20; ++i) {
      EXPECT_FALSE(news.blocked);
      b = (news = look(b, code, 2)).belief;
    }
    return news;
  };
  Belief b = look({}, kCodes[2], 2).belief;
  for (int step = 1; step <= 3; ++step) {
    const auto news = still(b, kCodes[2]);
    EXPECT_TRUE(news.stands);
    EXPECT_EQ(news.blocked, step == 3);
    b = news.belief;
  }
  // News in between, and all three are to come again.
  b = still(still(look({}, kCodes[2], 2).belief, kCodes[2]).belief, kCodes[2]).belief;
  b = look(b, kCodes[3], 2).belief;
  EXPECT_EQ(b.stood, UInt<2>(0));
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
                 .stood = bits % 4};
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
