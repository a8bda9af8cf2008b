// What the follower does around its law (follow_law_test.cpp); and that both bring a rotor to hand-over.
#include "hls/six_step/rotor_follower.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <tuple>
#include <utility>

#include "tests/hls/follow_law_look.hpp"

namespace steplock {
namespace {

using test::kCodes, test::kStill;

struct Bench {
  RotorFollower dut;
  RotorFollower::In in;
  RotorFollower::Out out;

  Bench() {
    in.on = true;
    in.sample_every = 4;
    in.look = 5;
    in.probe = 64;
    in.still = kStill;
  }
  RotorFollower::Out clock() { return out = dut.tick(in); }
  void code(int code) { in.u = (code & 4) != 0, in.v = (code & 2) != 0, in.w = (code & 1) != 0; }
  // Clocks until gates may be on, or off again; the loads on the way are obeyed.
  int until(bool drives) {
    int clocks = 0;
    while (clock().drive != drives && clocks < 5000) {
      if (out.load) in.step = out.step;
      ++clocks;
    }
    return clocks;
  }
};

TEST(RotorFollower, GatesAreOffFromTheFirstClockThroughLookAndSamples) {
  Bench b;
  // Six strobes of look, fifteen samples, less what the first period lacks; judge, load, and the step's way to the gates.
  EXPECT_NEAR(b.until(true), (6 + 15) * 4 + 4, 4);
}

TEST(RotorFollower, ADriveLastsForFifteenSamplesAndItsProbe) {
  Bench b;
  b.code(kCodes[2]);
  b.until(true);
  EXPECT_EQ(b.in.step, Step(2));
  EXPECT_NEAR(b.until(false), (15 + 65) * 4, 4);
}

// Real, and an edge: which way it turns is not known yet.  The second edge tells.  Behind the first one of a rotor that passed it
// within three drives each of the three looks comes a probe later, not a look.
TEST(RotorFollower, ANewStepOfARotorThatIsNotFollowedWaitsForThreeLooks) {
  for (const int idle : {0, 1, 2, 3, 10}) {
    Bench b;
    b.code(kCodes[0]);
    b.until(true);
    const int look = (6 + 15) * 4 + 4, long_look = (65 + 15) * 4 + 4;
    const auto goes_on = [&](int sector, int looks, int clocks_of_each) {
      b.until(false);
      b.code(kCodes[sector]);
      int restarts = 0, clocks = 0;
      while (!b.clock().drive) {
        if (b.out.load) b.in.step = b.out.step;
        restarts += b.out.restart;
        ASSERT_LT(++clocks, 5000);
      }
      EXPECT_NEAR(clocks, look + looks * clocks_of_each, 4 * (looks + 1)) << sector;
      EXPECT_EQ(restarts, 1) << "a drive begins once";
    };
    goes_on(0, 0, look);
    goes_on(1, 3, look);
    for (int k = 0; k < idle; ++k) goes_on(1, 0, look);
    goes_on(2, 3, idle < 3 ? long_look : look);
    goes_on(3, 0, look);
  }
}

// Of one that is braked the crossing tells nothing, and near standstill its noise would end each drive when it began.
TEST(RotorFollower, ACrossingEndsADriveButNotOneThatBrakes) {
  for (const bool brakes : {false, true}) {
    Bench b;
    b.code(kCodes[3]);
    b.until(true);
    for (const int sector : {brakes ? 2 : 4, brakes ? 1 : 4}) {
      b.until(false);
      b.code(kCodes[sector]);
      b.until(true);
    }
    ASSERT_EQ(b.in.step, Step(4)) << "the opposite of 1, or that of 4";
    b.in.crossing = true;
    const int clocks = b.until(false);
    EXPECT_NEAR(clocks, (brakes ? 15 + 65 : 15) * 4, 6) << brakes;
  }
}

// Once an edge was passed; before that fewer than four may say otherwise, else there is no step.
TEST(RotorFollower, TwelveOfFifteenSamplesAreAClearCode) {
  for (const int high : {0, 3, 4, 11, 12, 15}) {
    Bench b;
    int step = -1;
    for (int i = 0; i < 200 && !b.out.drive; ++i) {
      // The sixth strobe, in clock 24, ends the look's wait; each fourth clock behind it takes a sample.
      const int sample = i / 4 - 7;
      b.in.u = true;
      b.in.v = sample >= 0 && sample < high;
      b.in.w = !b.in.v;
      b.clock();
      if (b.out.load) step = int(b.out.step.raw());
    }
    // v makes 110, w 101.
    EXPECT_EQ(step, high >= 12 ? 2 : high <= 3 ? 0 : -1) << high;
  }
}

// One pin of three that says now this, now that is enough.
TEST(RotorFollower, ACodeIsAsClearAsItsWorstPin) {
  for (const int pin : {0, 1, 2}) {
    for (const int high : {0, 7, 15}) {
      Bench b;
      bool loaded = false;
      for (int i = 0; i < 200 && !b.out.drive; ++i) {
        const int sample = i / 4 - 7;
        const bool says = sample >= 0 && sample < high;
        b.code(0b100 ^ (0b100 >> pin));  // the two codes between which the pin's edge is
        (pin == 0 ? b.in.u : pin == 1 ? b.in.v : b.in.w) = says;
        if (pin == 0) b.in.w = true;
        b.clock();
        loaded = loaded || b.out.load;
      }
      EXPECT_EQ(loaded, high != 7) << pin << ' ' << high;
    }
  }
}

TEST(RotorFollower, ThreeStepsThatMoveNothingAreToldInOneClock) {
  Bench b;
  b.code(kCodes[2]);
  int told = 0, clocks = 0, loads = 0;
  bool was = false;
  for (int i = 0; i < 4 * kStill * (64 + 40) * 4 && told < 2; ++i) {
    b.clock();
    if (b.out.load) b.in.step = b.out.step, ++loads;
    clocks += b.out.blocked;
    told += b.out.blocked && !was;
    if (told == 1 && clocks == 1) {
      EXPECT_GE(loads, 3);
    }
    was = b.out.blocked;
  }
  EXPECT_GE(told, 1);
  EXPECT_EQ(clocks, told);
}

// Edge, and one that went by unseen: followed, but no interval was measured that could be over.
TEST(RotorFollower, WithoutAnIntervalADriveOfARotorThatIsFollowedEndsAfterItsProbe) {
  Bench b;
  for (const int sector : {0, 1, 2, 3, 5}) {
    b.code(kCodes[sector]);
    b.until(true);
    EXPECT_EQ(b.in.step, Step(sector));
    if (sector < 5) b.until(false);
  }
  b.clock();
  EXPECT_TRUE(b.out.sure);
  EXPECT_NEAR(b.until(false), (15 + 65) * 4, 6) << "no update came";
  b.until(true);
  b.in.update = true;
  b.clock();
  b.in.update = false;
  EXPECT_EQ(b.until(false), 5000) << "until the VCO says that it is over";
}

TEST(RotorFollower, SaysThatTheRotorMovesOnceItHasPassedAnEdgeTheWayThatIsBelieved) {
  Bench b;
  for (const int sector : {3, 2, 1, 0}) {
    b.code(kCodes[sector]);
    b.until(true);
    EXPECT_FALSE(b.out.sure);
    EXPECT_EQ(b.out.moves, sector == 0) << sector;  // 3 at rest, 2 is real, 1 tells which way
    b.until(false);
  }
  for (const int sector : {1, 2, 3, 4, 5}) {  // it turned round
    b.code(kCodes[sector]);
    b.until(true);
    EXPECT_EQ(b.out.moves, sector != 2) << sector;  // 1 may be chatter on the last edge; 2 is none, and a new belief
    b.until(false);
  }
  EXPECT_TRUE(b.out.sure);
}

// A good interval of a rotor that was not fast before may end at any speed: it accelerates.
TEST(RotorFollower, HandsOverOnlyWhatWasFastThroughoutTheLastInterval) {
  for (const bool fast_before : {false, true}) {
    Bench b;
    for (const int sector : {0, 1, 2, 3}) {
      b.code(kCodes[sector]);
      b.until(true);
      if (sector < 3) b.until(false);
    }
    b.in.fast = fast_before;
    b.in.update = b.in.good = true;
    b.clock();
    b.in.update = false;
    b.in.fast = true;
    for (int i = 0; i < 100; ++i) b.clock();
    b.in.crossing = true;
    b.clock();
    b.in.crossing = false;
    EXPECT_EQ(b.clock().caught, fast_before);
  }
}

TEST(RotorFollower, HandsOverWhatIsFastOrSteadyAndNotSlow) {
  for (const auto& [fast, steady, slow] : {std::tuple{false, false, false}, {false, false, true}, {false, true, false}, {false, true, true},
                                           {true, false, false}, {true, false, true}, {true, true, true}}) {
    Bench b;
    for (const int sector : {0, 1, 2, 3}) {
      b.code(kCodes[sector]);
      b.until(true);
      if (sector < 3) b.until(false);
    }
    b.in.update = b.in.good = b.in.steady = true;
    b.clock();
    b.in.update = false;
    b.in.fast = fast, b.in.steady = steady, b.in.slow = slow;
    for (int i = 0; i < 100; ++i) b.clock();
    b.in.crossing = true;
    b.clock();
    b.in.crossing = false;
    EXPECT_EQ(b.clock().caught, fast || (steady && !slow)) << fast << steady << slow;
  }
}

TEST(RotorFollower, LeftOutOrOffItSaysNothing) {
  Bench b;
  b.in.follows = false;
  for (int i = 0; i < 3000; ++i) ASSERT_EQ(b.clock(), RotorFollower::Out{});
  b.in.follows = true;
  b.until(true);
  b.in.on = false;
  b.clock();
  EXPECT_EQ(b.clock(), RotorFollower::Out{});
}

// Whatever the pins say: a step is one of six, is loaded with gates off, and a look has the gates off for its time.
RC_GTEST_PROP(RotorFollower, NeverLoadsAStepThatIsDrivenAndAlwaysLooksInFull, ()) {
  Bench b;
  b.in.reverse = *rc::gen::arbitrary<bool>();
  b.in.step = *rc::gen::inRange(0, 6);
  int off = 1000;
  bool drove = false;
  for (int i = 0; i < 20000; ++i) {
    if (i % 16 == 0) {
      const int pins = *rc::gen::inRange(0, 256);
      b.code(pins & 7);
      b.in.crossing = (pins & 8) != 0;
      b.in.elapsed = (pins & 16) != 0;
      b.in.update = b.in.good = (pins & 96) == 96;
      b.in.fast = (pins & 128) != 0;
      b.in.quarter = !b.in.quarter;
    } else {
      b.in.crossing = b.in.elapsed = b.in.update = false;
    }
    const auto out = b.clock();
    RC_ASSERT(out.step < Step(6));
    RC_ASSERT(!(out.load && out.drive));
    RC_ASSERT(!out.changed || out.load);
    if (out.drive && !drove) RC_ASSERT(off >= (6 + 14) * 4);
    off = out.drive ? 0 : off + 1;
    drove = out.drive;
    if (out.load) b.in.step = out.step;
  }
}

// A rotor of any inertia on ideal comparators: torque of the driven step, no friction, a clock of 1 us.  The back-EMF is
// seen above a thousandth of a turn per millisecond; below, comparators show what their offsets say.
struct Rotor {
  double angle = 0, speed = 0;  // electrical degrees, degrees per us
  double inertia = 1;
  int offsets = kCodes[0];

  void move(bool drives, int step) {
    // Step 0 has its torque's peak where sector 0 ends: 60 degrees, and 30 before its end.
    if (drives) speed += 2e-6 / inertia * std::cos((angle - 60.0 * step - 60) * M_PI / 180);
    angle += speed;
  }
  int code() const {
    if (std::abs(speed) < 0.36e-3) return offsets;
    int s = int(std::floor(angle / 60 - 6 * std::floor(angle / 360))) % 6;
    return speed > 0 ? kCodes[s] : kCodes[(s + 3) % 6];
  }
};

// From twelve angles and five speeds, heavy and light, either way: followed, and brought to five times the speed of
// the fastest one that it was given.
TEST(RotorFollower, FollowsARotorFromAnyAngleAndMotionToHandOver) {
  for (const bool reverse : {false, true}) {
    for (const double inertia : {1.0, 40.0}) {
      for (int start = 0; start < 60; ++start) {
        Rotor rotor{.angle = 30.0 * (start % 12) + 7, .speed = (start / 12 - 2) * 2e-3 / std::sqrt(inertia),
                    .inertia = inertia, .offsets = kCodes[start % 6]};
        RotorFollower dut;
        RotorFollower::In in;
        in.on = true;
        in.sample_every = 2;
        in.look = 20;
        in.probe = 1200;
        in.still = 250;
        in.reverse = reverse;
        const double way = reverse ? -1 : 1;
        const double hand_over = 20e-3 / std::sqrt(inertia);
        int code_before = rotor.code();
        double since = 0, before = 0;
        bool caught = false;
        for (int us = 0; us < 3'000'000 && !caught; ++us) {
          const int code = rotor.code();
          in.u = (code & 4) != 0, in.v = (code & 2) != 0, in.w = (code & 1) != 0;
          // The step's crossing: the edge at its sector's end.
          in.crossing = code != code_before && rotor.speed * way > 0 &&
                        FollowLaw::step_of(code_before, reverse) == in.step;
          code_before = code;
          in.fast = rotor.speed * way >= hand_over;
          const auto out = dut.tick(in);
          in.update = out.changed;
          // Overdue by a quarter, as the VCO says: once.
          in.elapsed = before > 0 && since == std::floor(before);
          in.quarter = since > 1.25 * before;
          in.good = std::abs(since - before) < since / 8;
          if (out.changed) before = since, since = 0;
          since += 1;
          if (out.load) in.step = out.step;
          caught = out.caught;
          rotor.move(out.drive, int(in.step.raw()));
        }
        EXPECT_TRUE(caught) << reverse << ' ' << inertia << ' ' << start << ": " << rotor.angle << ' ' << rotor.speed;
        EXPECT_GT(rotor.speed * way, 0.9 * hand_over);
      }
    }
  }
}

}  // namespace
}  // namespace steplock
