// What FollowLaw does for want of news: it waits, moves the step on, and gives up.  Line by line of its table:
// follow_law_test.cpp.
#include "hls/six_step/follow_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/hls/follow_law_look.hpp"

namespace steplock {
namespace {

using namespace test;

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

// While it is not known which way it turns, a new step waits; not what brakes, nor a rotor that is followed.
TEST(FollowLaw, AfterANewStepTheWantedWayThreeLooksFollowEachOther) {
  Belief b = look({}, kCodes[0], 0).belief;
  EXPECT_EQ(b.coast, UInt<2>(0)) << "a rotor at rest tells nothing";
  for (const int sector : {1, 2}) {
    b = look(b, kCodes[sector], sector - 1).belief;
    for (const int left : {3, 2, 1, 0, 0}) {
      EXPECT_EQ(b.coast, UInt<2>(left)) << sector;
      b = look(b, kCodes[sector], sector).belief;
    }
  }
  EXPECT_EQ(look(b, kCodes[3], 2).belief.coast, UInt<2>(0)) << "it is followed";
  const Belief coasting = look(look({}, kCodes[3], 3).belief, kCodes[2], 3).belief;
  ASSERT_EQ(coasting.coast, UInt<2>(3));
  const Belief back = look(coasting, kCodes[1], 2).belief;
  EXPECT_TRUE(back.back);
  EXPECT_EQ(back.coast, UInt<2>(0)) << "it is braked";
  EXPECT_EQ(look(back, kCodes[0], 4).belief.coast, UInt<2>(0));
  EXPECT_EQ(look(back, kCodes[5], 4).belief.coast, UInt<2>(0)) << "turned round";
}

TEST(FollowLaw, LooksWhileCoastingCountForNoStill) {
  Belief b = look(look({}, kCodes[0], 0).belief, kCodes[1], 0).belief;
  b.idle = 19;
  for (const int left : {2, 1, 0}) {
    const auto news = look(b, kCodes[1], 1);
    ASSERT_FALSE(news.stands);
    b = news.belief;
    EXPECT_EQ(b.idle, UInt<8>(19));
    EXPECT_EQ(b.coast, UInt<2>(left));
  }
  EXPECT_TRUE(look(b, kCodes[1], 1).stands);
}

// A heavy rotor that its first step drove backwards needs as long again to be braked; codes that quiver turn the belief for ever.
TEST(FollowLaw, ABeliefThatTurnsBeginsStillAnewOnceBetweenTwoNews) {
  const auto first = look(real({.idle = 19}), kCodes[1], 2);
  EXPECT_TRUE(first.goes && first.belief.back && !first.stands);
  EXPECT_EQ(first.belief.idle, UInt<8>(0));
  const auto quiver = look(first.belief, kCodes[2], 4);
  EXPECT_FALSE(quiver.belief.back);
  EXPECT_EQ(quiver.belief.idle, UInt<8>(1));
  Belief b = first.belief;
  b.idle = 19;
  EXPECT_TRUE(look(b, kCodes[2], 4).stands);
  EXPECT_FALSE(look(first.belief, kCodes[0], 4).belief.turned) << "an edge backwards is news";
  const Belief soon = look(real({.idle = 3}), kCodes[1], 2).belief;
  EXPECT_EQ(soon.idle, UInt<8>(4)) << "noise near rest, which leaves it for a belief that lasts";
  EXPECT_FALSE(soon.turned);
  // Codes that turn the belief at every look, or at every fifth.
  for (const int every : {1, 5}) {
    b = real();
    int looks = 0, step = 2;
    bool stands = false;
    for (; !stands && looks < 100; ++looks) {
      const auto news = look(b, kCodes[2 - looks / every % 2], step);
      step = news.goes ? int(news.step.raw()) : step;
      stands = news.stands;
      b = news.belief;
    }
    EXPECT_TRUE(stands) << every;
    EXPECT_LE(looks, 2 * 20 + 4 * FollowLaw::kCoast) << every;
  }
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

}  // namespace
}  // namespace steplock
