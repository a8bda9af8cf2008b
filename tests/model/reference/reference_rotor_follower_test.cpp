// The follower in doubles: it says of every belief what the table in docs/blocks/rotor_follower.md says, in time.
#include "model/reference/rotor_follower.hpp"

#include <gtest/gtest.h>

#include <random>

#include "hls/six_step/follow_law.hpp"

namespace steplock::reference {
namespace {

constexpr double kEvery = 1e-6;
constexpr std::array<std::array<bool, 3>, 6> kCodes = {{{1, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}};

struct Bench {
  design::StartParameters p{.method = design::Method::kFollow, .look = 100e-6, .probe = 500e-6, .still = 20};
  RotorFollower follower{p, kEvery};
  RotorFollower::In in;
  double t = 0;

  explicit Bench(bool reverse = false) {
    in.reverse = reverse;
    follower.begin(0);
  }
  // Until the next drive, with this code at each look; returns the step that was loaded, or -1.
  int look(int sector) {
    in.comparator = kCodes[std::size_t((sector % 6 + 6) % 6)];
    while (follower.drives()) step_once();
    int loaded = -1;
    while (!follower.drives()) {
      step_once();
      if (follower.loaded()) in.step = loaded = *follower.loaded();
    }
    return loaded;
  }
  void step_once() {
    // One that is followed ends a drive by the caller's word alone.
    t = follower.drives() ? std::min(follower.next(), t + 400e-6) : follower.next();
    in.overdue = follower.drives() && follower.sure();
    in.update = follower.changed();
    follower.update(t, in);
    in.overdue = false;
  }
};

TEST(ReferenceRotorFollower, GatesAreOffForTheLookAndItsSamplesAndOnForTheProbe) {
  Bench b;
  while (!b.follower.drives()) b.step_once();
  EXPECT_NEAR(b.t, 100e-6 + 14 * kEvery, 1e-9);
  const double began = b.t;
  while (b.follower.drives()) b.step_once();
  EXPECT_NEAR(b.t - began, 500e-6 + 15 * kEvery, 1e-9);
}

// Rest, then one sector after the other: real, edge, edge, measured; either way round.
TEST(ReferenceRotorFollower, FollowsARotorEitherWay) {
  for (const bool reverse : {false, true}) {
    Bench b(reverse);
    const int way = reverse ? -1 : 1, first = reverse ? -1 : 0;
    b.look(0);
    for (int k = 1; k <= 8; ++k) {
      EXPECT_EQ(b.look(way * k), ((way * k + first) % 6 + 6) % 6) << k;
      EXPECT_EQ(b.follower.sure(), k >= 3);
    }
  }
}

// Behind the first edge of a rotor that passed it within three drives, each of them a probe later, not a look.
TEST(ReferenceRotorFollower, LooksThreeTimesMoreAfterANewStepTheWantedWay) {
  for (const int idle : {0, 2, 3}) {
    Bench b;
    const auto gates_off = [&](int sector) {
      while (b.follower.drives()) b.step_once();
      const double began = b.t;
      b.look(sector);
      return b.t - began;
    };
    const double look = 100e-6 + 14 * kEvery, long_look = 500e-6 + 14 * kEvery;
    b.look(0);
    EXPECT_NEAR(gates_off(0), look, 1e-9);
    EXPECT_NEAR(gates_off(1), 4 * look, 1e-9) << "real";
    for (int k = 0; k < idle; ++k) EXPECT_NEAR(gates_off(1), look, 1e-9) << "no news";
    EXPECT_NEAR(gates_off(2), look + 3 * (idle < 3 ? long_look : look), 1e-9) << "an edge, after drives: " << idle;
    EXPECT_NEAR(gates_off(3), look, 1e-9) << "followed";
  }
}

TEST(ReferenceRotorFollower, BrakesARotorThatTurnsTheOtherWayAndTurnsWithIt) {
  Bench b;
  b.look(0);
  EXPECT_EQ(b.look(5), 5);      // real, and taken for one that turns the wanted way
  EXPECT_EQ(b.look(4), 1);      // no: the opposite of step 4
  EXPECT_EQ(b.look(3), 0);      // on backwards
  EXPECT_EQ(b.look(0), -1);     // the code is inverted: it turned round, and step 0 is right
  EXPECT_EQ(b.look(1), 1);
  EXPECT_FALSE(b.follower.sure());
  EXPECT_EQ(b.look(2), 2);
  EXPECT_TRUE(b.follower.sure());
}

TEST(ReferenceRotorFollower, BrakesARotorThatPassesTwoEdgesBackwardsBetweenTwoLooks) {
  Bench b;
  b.look(0);
  EXPECT_EQ(b.look(5), 5);
  EXPECT_EQ(b.look(3), 3);  // once tells nothing
  EXPECT_EQ(b.look(1), 4);  // twice does: the opposite of step 1
  EXPECT_EQ(b.look(5), 2);  // two more
  EXPECT_EQ(b.look(4), 1);  // and one
  EXPECT_FALSE(b.follower.sure());
}

TEST(ReferenceRotorFollower, MovesTheFieldOnWithoutNews) {
  Bench b;
  b.look(2);
  for (int k = 1; k < 20; ++k) ASSERT_EQ(b.look(2), -1) << k;
  EXPECT_EQ(b.look(2), 3);
}

TEST(ReferenceRotorFollower, HandsOverAtACrossingOfARotorThatIsReady) {
  Bench b;
  for (int k = 0; k < 5; ++k) b.look(k);
  ASSERT_TRUE(b.follower.sure());
  b.in.crossing = b.in.ready = true;
  b.follower.update(b.t + 1e-6, b.in);
  EXPECT_FALSE(b.follower.caught()) << "too early in the drive";
  b.follower.update(b.t + 100e-6, b.in);
  EXPECT_TRUE(b.follower.caught());
  EXPECT_TRUE(b.follower.drives());
}

// Two programs of one table, the law's in bits and this one in directions: of random codes, clear or not, of rotors that
// wander, jump and stand, both load the same steps and believe the same, look by look.
TEST(ReferenceRotorFollower, SaysAtEachLookWhatTheLawSays) {
  constexpr int kRotors = 300, kLooks = 400;
  std::mt19937 random(20261127);
  const auto below = [&](int n) { return int(random() % unsigned(n)); };
  int looks = 0, flips = 0, followed = 0, stood = 0, gave_up = 0;
  for (int rotor = 0; rotor < kRotors; ++rotor) {
    Bench b(rotor % 2 != 0);
    FollowLaw::Belief belief;
    const int likely = below(3) - 1, still = 20;
    int sector = below(6);
    for (int k = 0; k < kLooks; ++k) {
      const int mood = likely == 0 && below(5) > 0 ? 0 : below(20);  // most of those that stand do so for long
      sector = (sector + (mood < 9 ? likely : mood == 9 ? below(6) : mood < 12 ? below(3) - 1 : 0) + 6) % 6;
      const bool illegal = below(25) == 0, clear = below(8) != 0;
      std::array<bool, 3> code = illegal ? std::array<bool, 3>{} : kCodes[std::size_t(sector)];
      while (b.follower.drives()) b.step_once();
      // A comparator that says otherwise five times of fifteen is not clear, and its bit is the majority's.
      for (int sample = 0; sample < 15; ++sample) {
        b.in.comparator = code;
        b.in.comparator[0] = code[0] != (!clear && sample < 5);
        b.step_once();
      }
      const auto bits = FollowLaw::bits(code[0], code[1], code[2]);
      const Step step = Step(b.in.step);
      const auto news = FollowLaw::judge(belief, FollowLaw::see(bits, clear, step, b.in.reverse, belief, still), bits);
      flips += news.belief.back != belief.back, stood += news.stands, followed += news.changed, gave_up += news.blocked;
      belief = news.belief;
      const auto loaded = b.follower.loaded();
      ASSERT_EQ(loaded.has_value(), news.goes) << rotor << " " << k;
      if (loaded) {
        ASSERT_EQ(Step(*loaded), FollowLaw::step_after(news, bits, step, b.in.reverse)) << rotor << " " << k;
        b.in.step = *loaded;
      }
      ASSERT_EQ(b.follower.changed(), news.changed) << rotor << " " << k;
      ASSERT_EQ(b.follower.blocked(), news.blocked) << rotor << " " << k;
      ASSERT_EQ(b.follower.sure(), belief.sure()) << rotor << " " << k;
      ASSERT_EQ(b.follower.moves(), belief.moved) << rotor << " " << k;
      ASSERT_EQ(b.follower.drives(), belief.coast == 0) << rotor << " " << k;
      if (belief.coast != 0) {
        ASSERT_NEAR(b.follower.next() - b.t, belief.light() ? b.p.probe : b.p.look, 1e-12) << rotor << " " << k;
      }
      ++looks;
      if (news.blocked) break;  // the attempt is over
    }
  }
  EXPECT_GT(looks, kRotors * kLooks / 2);
  EXPECT_GT(flips, 1000);
  EXPECT_GT(followed, 1000);
  EXPECT_GT(stood, 100);
  EXPECT_GT(gave_up, 10);
}

}  // namespace
}  // namespace steplock::reference
