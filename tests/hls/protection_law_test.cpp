// Protection's machine against its law, bit for bit: random words, levels and strobes, every reason.
#include "hls/six_step/protection_law.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "model/reference/protection.hpp"
#include "tests/hls/random_config.hpp"

namespace steplock {
namespace {

using In = Protection::In;
using Out = Protection::Out;

bool equal(const Out& a, const Out& b) {
  return a.lost == b.lost && a.fatal == b.fatal && a.freewheel_long == b.freewheel_long &&
         (a.reason == b.reason || !(a.lost || a.fatal));
}

class Story : public RandomConfig {
 public:
  explicit Story(std::uint32_t seed) : RandomConfig(seed) { config(); }

  // Levels hold for three clocks before a clock with strobes, and stay in it.
  void levels() {
    // An attempt that ended is followed by a rest.
    in.running = running_ ? in.running && !one_in(200) : one_in(20);
    running_ = in.running;
    if (one_in(400) || (!running_ && one_in(20))) config();
    if (one_in(30)) in.hall = one_in(4);
    if (one_in(40)) kind_ = below(5);
    in.slow = kind_ == 1 && !one_in(20);
    in.slips = kind_ == 2 && !one_in(4);
    in.freewheel = one_in(3) ? in.config.freewheel : wrap<Phase>(in.config.freewheel + UInt<16>::of(below(3)));
    if (kind_ != 3) in.freewheel = 0;
    in.hall_illegal = one_in(3);
    in.stuck = one_in(50) ? UInt<4>::of(below(16)) : UInt<4>(0);
    in.fault_pin = one_in(300);
    quiet();
  }
  void quiet() { in.update = in.tick = in.commutate = in.missed = in.good = in.lags = false; }
  void strobes() {
    in.update = one_in(2);
    in.missed = in.update && one_in(kind_ == 4 ? 2 : 5);
    in.lags = one_in(3);
    in.good = in.update && !in.missed && !one_in(4);
    in.commutate = one_in(2);
    in.tick = one_in(3);
  }
  In in;

 private:
  void config() {
    auto& w = in.config;
    w.misses = one_in(8) ? UInt<6>(0) : UInt<6>::of(1 + below(20));
    w.wrong_lock = one_in(8) ? Ticks(0) : Ticks::of(1 + below(40));
    w.over_current = one_in(4) ? decltype(w.over_current)(0) : decltype(w.over_current)::of(8 + below(8));
    w.freewheel = Phase::of(below(0xfff0));
  }
  unsigned kind_ = 0;
  bool running_ = false;  // before this change of levels
};

int differences(std::uint32_t seed, int strobes, std::map<Reason, int>* reasons = nullptr,
                const std::function<void(In&)>& spoil = [](In&) {}) {
  Story story(seed);
  Protection dut;
  ProtectionLaw law;
  int differ = 0;
  for (int k = 0; k < strobes; ++k) {
    const auto clock = [&](bool compare) {
      In other = story.in;
      spoil(other);
      const Out is = dut.tick(story.in), wanted = law.clock(other);
      if (compare) differ += !equal(is, wanted);
      if (compare && reasons != nullptr && wanted.reason != Reason::kNone) ++(*reasons)[wanted.reason];
      return wanted.lost;
    };
    story.levels();
    bool lost = false;  // by a word that changed
    for (int i = 0; i < 3; ++i) lost = clock(i == 2);
    if (!lost) story.strobes();
    if (!clock(true)) continue;
    // The verdict stands until the attempt has ended.
    story.quiet();
    for (int i = 0; i < 3; ++i) clock(i == 2);
    story.in.running = false;
  }
  return differ;
}

TEST(ProtectionLaw, IsWhatTheMachineDoes) {
  std::map<Reason, int> reasons;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) ASSERT_EQ(differences(seed, 20000, &reasons), 0) << seed;
  for (const Reason r : {Reason::kFaultPin, Reason::kOverCurrent, Reason::kStepOut, Reason::kStall, Reason::kWrongLock,
                         Reason::kHallCode}) {
    EXPECT_GT(reasons[r], 100) << int(r);
  }
}

TEST(ProtectionLaw, ADifferenceOfOneIsFound) {
  const auto found = [](const std::function<void(In&)>& spoil) { return differences(7, 20000, nullptr, spoil) > 0; };
  EXPECT_TRUE(found([](In& in) { if (in.config.misses != 0) in.config.misses = in.config.misses ^ UInt<6>(1); }));
  EXPECT_TRUE(found([](In& in) { if (in.config.misses == 0) in.config.misses = 1; }));
  EXPECT_TRUE(found([](In& in) { in.config.wrong_lock = in.config.wrong_lock ^ Ticks(1); }));
  EXPECT_TRUE(found([](In& in) { in.config.freewheel = wrap<Phase>(in.config.freewheel + UInt<16>(1)); }));
  EXPECT_TRUE(found([](In& in) { in.config.over_current = wrap<UInt<4>>(in.config.over_current + UInt<4>(1)); }));
  EXPECT_TRUE(found([](In& in) { in.lags = false; }));
  EXPECT_TRUE(found([](In& in) { in.good = false; }));
  EXPECT_TRUE(found([](In& in) { in.hall = false; }));
  EXPECT_TRUE(found([](In& in) { in.commutate = true; })) << "freewheeling is long in the clock of a commutation";
}

// The reference counts the same events, so its verdict is the law's in every clock of an attempt, up to the one that ends it.
// How many differ, of attempts by a story whose words last as long as the attempt; what both see is spoilt for the reference.
int verdicts_beside_the_reference(std::uint32_t seed, int attempts, std::map<Reason, int>* reasons = nullptr,
                                  const std::function<void(design::ProtectionParameters&)>& spoil = [](design::ProtectionParameters&) {}) {
  constexpr double kTurn = 0x1p-16;  // of a phase's last bit
  int differ = 0;
  for (int k = 0; k < attempts; ++k) {
    Story story(seed + std::uint32_t(k));
    ProtectionLaw law;
    In idle = story.in;
    idle.running = false;
    law.clock(idle);
    const auto w = story.in.config;
    design::ProtectionParameters p{.misses = int(w.misses.raw()), .stall = 1, .slip = 0.5, .freewheel = double(w.freewheel.raw()) * kTurn,
                                   .wrong_lock = double(w.wrong_lock.raw()), .over_current = int(w.over_current.raw())};
    spoil(p);
    reference::Protection reference(p, 1);
    for (int i = 0; i < 400; ++i) {
      story.levels();
      story.strobes();
      In in = story.in;
      in.running = true, in.config = w;
      const Out is = law.clock(in);
      reference.update({.running = true, .tick = in.tick, .commutated = in.commutate, .updated = in.update, .good = in.good,
                        .missed = in.missed, .lags = in.lags, .hall = in.hall, .hall_illegal = in.hall_illegal,
                        .fault_pin = in.fault_pin, .frequency = in.slow ? 0.5 : 1.5, .slip = in.slips ? 0.75 : 0.25,
                        .freewheel = double(in.freewheel.raw()) * kTurn, .stuck = int(in.stuck.raw())});
      // Both number the reasons alike; one that is fatal comes first.
      const auto wanted = reference.fatal() != reference::Reason::kNone ? reference.fatal() : reference.lost();
      differ += is.lost != (reference.lost() != reference::Reason::kNone) || is.fatal != (reference.fatal() != reference::Reason::kNone) ||
                int(is.reason) != int(wanted);
      if (is.lost || is.fatal) {
        if (reasons != nullptr) ++(*reasons)[is.reason];
        break;
      }
    }
  }
  return differ;
}

TEST(ProtectionLaw, EqualsTheReferenceInEveryVerdict) {
  std::map<Reason, int> reasons;
  EXPECT_EQ(verdicts_beside_the_reference(1, 4000, &reasons), 0);
  for (const Reason r : {Reason::kFaultPin, Reason::kOverCurrent, Reason::kStepOut, Reason::kStall, Reason::kWrongLock,
                         Reason::kHallCode}) {
    EXPECT_GT(reasons[r], 20) << int(r);
  }
  const auto found = [](const std::function<void(design::ProtectionParameters&)>& spoil) {
    return verdicts_beside_the_reference(1, 4000, nullptr, spoil) > 0;
  };
  EXPECT_TRUE(found([](design::ProtectionParameters& p) { p.misses += p.misses > 0; }));
  EXPECT_TRUE(found([](design::ProtectionParameters& p) { p.wrong_lock += p.wrong_lock > 0; }));
  EXPECT_TRUE(found([](design::ProtectionParameters& p) { p.over_current += p.over_current > 0; }));
  EXPECT_TRUE(found([](design::ProtectionParameters& p) { p.freewheel += 0x1p-16; }));
}

}  // namespace
}  // namespace steplock
