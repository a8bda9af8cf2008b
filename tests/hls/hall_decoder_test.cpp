#include "hls/six_step/hall_decoder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace steplock {
namespace {

// The code of the back-EMF's signs at an electrical angle, straight from its definition.
HallDecoder::In signs_at(double degrees, unsigned hold = 0) {
  const auto sign = [](double angle) { return std::sin(angle * M_PI / 180) > 0; };
  return {.u = sign(degrees), .v = sign(degrees - 120), .w = sign(degrees - 240), .hold = hold};
}

// Clocks a block until a code has come through, and returns what it said on the way.
struct Seen {
  HallDecoder::Out last;
  int moves = 0;
  int jumps = 0;
};
Seen settle(HallDecoder& dut, const HallDecoder::In& in, int clocks = 4) {
  Seen seen;
  for (int i = 0; i < clocks; ++i) {
    seen.last = dut.tick(in);
    seen.moves += seen.last.moved;
    seen.jumps += seen.last.jumped;
    EXPECT_EQ(seen.last.changed, seen.last.moved || seen.last.jumped);
  }
  return seen;
}

TEST(HallDecoder, SectorSIsWhereTheSignsSayThetaLiesBetween60SAnd60SPlus60) {
  for (int s = 0; s < 6; ++s) {
    HallDecoder dut;
    const auto seen = settle(dut, signs_at(60 * s + 17));
    EXPECT_TRUE(seen.last.legal);
    EXPECT_EQ(seen.last.sector, UInt<3>(s));
  }
}

TEST(HallDecoder, ATurnForwardIsSixMovesUp) {
  HallDecoder dut;
  settle(dut, signs_at(17));
  for (int s = 1; s <= 6; ++s) {
    const auto seen = settle(dut, signs_at(60 * s + 17));
    EXPECT_EQ(seen.moves, 1);
    EXPECT_EQ(seen.jumps, 0);
    EXPECT_FALSE(seen.last.reverse);
    EXPECT_EQ(seen.last.sector, UInt<3>(s % 6));
  }
}

TEST(HallDecoder, ATurnBackIsSixMovesDown) {
  HallDecoder dut;
  settle(dut, signs_at(17));
  for (int s = 5; s >= 0; --s) {
    const auto seen = settle(dut, signs_at(60 * s + 17));
    EXPECT_EQ(seen.moves, 1);
    EXPECT_TRUE(seen.last.reverse);
    EXPECT_EQ(seen.last.sector, UInt<3>(s));
  }
}

TEST(HallDecoder, TheFirstCodeAfterResetIsAJumpEvenIntoSectorZero) {
  for (int s = 0; s < 6; ++s) {
    HallDecoder dut;
    const auto seen = settle(dut, signs_at(60 * s + 17));
    EXPECT_EQ(seen.jumps, 1);
    EXPECT_EQ(seen.moves, 0);
  }
}

TEST(HallDecoder, ANonNeighbourIsAJump) {
  for (int s = 0; s < 6; ++s) {
    for (int away : {2, 3, 4}) {
      HallDecoder dut;
      settle(dut, signs_at(60 * s + 17));
      const auto seen = settle(dut, signs_at(60 * (s + away) + 17));
      EXPECT_EQ(seen.jumps, 1);
      EXPECT_EQ(seen.moves, 0);
      EXPECT_EQ(seen.last.sector, UInt<3>((s + away) % 6));
    }
  }
}

TEST(HallDecoder, AnIllegalCodeKeepsTheSectorAndTheNextLegalOneIsAJump) {
  for (const bool level : {false, true}) {
    HallDecoder dut;
    settle(dut, signs_at(137));
    const auto bad = settle(dut, {.u = level, .v = level, .w = level});
    EXPECT_FALSE(bad.last.legal);
    EXPECT_EQ(bad.last.sector, UInt<3>(2));
    EXPECT_EQ(bad.moves + bad.jumps, 0);
    const auto good = settle(dut, signs_at(197));
    EXPECT_TRUE(good.last.legal);
    EXPECT_EQ(good.jumps, 1);
    EXPECT_EQ(good.moves, 0);
  }
}

TEST(HallDecoder, ACodeCountsHoldPlusTwoClocksAfterItCame) {
  for (const unsigned hold : {0u, 1u, 7u, 1023u}) {
    HallDecoder dut;
    settle(dut, signs_at(17, hold), 1100);
    for (unsigned i = 0; i < hold + 2; ++i) {
      ASSERT_FALSE(dut.tick(signs_at(77, hold)).moved) << hold;
    }
    EXPECT_TRUE(dut.tick(signs_at(77, hold)).moved) << hold;
    EXPECT_FALSE(dut.tick(signs_at(77, hold)).moved) << hold;
  }
}

// However an edge chatters, with less than the hold between its changes it is one move.
RC_GTEST_PROP(HallDecoder, AChatteringEdgeIsOneMove, ()) {
  HallDecoder dut;
  settle(dut, signs_at(17, 20), 50);
  const auto runs = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 20));
  int moves = 0;
  bool there = true;
  for (const int run : runs) {
    moves += settle(dut, signs_at(there ? 77 : 17, 20), run).moves;
    there = !there;
  }
  RC_ASSERT(moves == 0);
  const auto seen = settle(dut, signs_at(77, 20), 50);
  RC_ASSERT(seen.moves == 1);
  RC_ASSERT(seen.jumps == 0);
}

TEST(HallDecoder, AnEdgeThatChattersForLongIsOneMove) {
  HallDecoder dut;
  settle(dut, signs_at(17));
  settle(dut, signs_at(77));
  int moves = settle(dut, signs_at(137)).moves;
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(settle(dut, signs_at(77)).last.sector, UInt<3>(1));
    moves += settle(dut, signs_at(137)).moves;
  }
  EXPECT_EQ(moves, 1);
}

// What a speed measurement counts on: moves follow the rotor like a gear with one sector of play.
RC_GTEST_PROP(HallDecoder, MovesAddUpToTheSectorButForOneOfPlay, ()) {
  const auto steps = *rc::gen::nonEmpty(rc::gen::arbitrary<std::vector<bool>>());
  HallDecoder dut;
  settle(dut, signs_at(17));
  int at = 600;                            // sectors
  int gear = steps.front() ? at : at + 1;  // at or at + 1
  for (const bool up : steps) {
    at += up ? 1 : -1;
    const int next = std::clamp(gear, at, at + 1);
    const auto seen = settle(dut, signs_at(60 * (at % 6) + 17));
    RC_ASSERT(seen.moves == std::abs(next - gear));
    RC_ASSERT(seen.jumps == 0);
    RC_ASSERT(next == gear || seen.last.reverse == (next < gear));
    RC_ASSERT(seen.last.sector == UInt<3>(at % 6));
    gear = next;
  }
}

// At once or clock by clock, with pins that stand: the same.  A code that has not come in yet, or has just stood for long enough, leaves
// no quiet clock.
TEST(HallDecoder, SkippingItsQuietClocksEqualsTickingThem) {
  int skipped = 0, without_end = 0;
  HallDecoder ticked;
  for (int k = 0; k < 4000; ++k) {
    const HallDecoder::In in = signs_at(17 + 60 * (k * 7 % 11), unsigned(k % 23));
    for (int i = 0; i < 2 + k % 5; ++i) ticked.tick(in);
    const UInt<3> code = UInt<3>(in.u) << 2 | UInt<3>(in.v) << 1 | UInt<3>(in.w);
    without_end += ticked.quiet(code) == ~std::uint64_t{0};
    for (UInt<3> other = 1; other != 0; other = wrap<UInt<3>>(other + 1)) EXPECT_EQ(ticked.quiet(code ^ other), 0u) << k;
    const std::uint64_t clocks = std::min<std::uint64_t>(ticked.quiet(code), 30);
    HallDecoder jumped = ticked;
    for (std::uint64_t i = 0; i < clocks; ++i) ticked.tick(in);
    jumped.skip(clocks);
    ASSERT_EQ(jumped, ticked) << k;
    skipped += int(clocks);
  }
  EXPECT_GT(skipped, 10000);
  EXPECT_GT(without_end, 100);
  EXPECT_LT(without_end, 3900);
}

TEST(HallDecoder, LeftOutItSaysNothing) {
  HallDecoder dut;
  for (int degrees = 0; degrees < 720; ++degrees) {
    auto in = signs_at(degrees);
    in.decodes = false;
    const auto out = dut.tick(in);
    EXPECT_FALSE(out.legal || out.moved || out.jumped || out.reverse);
    EXPECT_EQ(out.sector, UInt<3>(0));
    EXPECT_EQ(dut, HallDecoder{});
  }
}

}  // namespace
}  // namespace steplock
