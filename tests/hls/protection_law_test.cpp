// Protection's machine against its law, bit for bit: random words, levels and strobes, every reason.
#include "hls/six_step/protection_law.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "tests/hls/random_words.hpp"

namespace steplock {
namespace {

using In = Protection::In;
using Out = Protection::Out;

bool equal(const Out& a, const Out& b) {
  return a.lost == b.lost && a.fatal == b.fatal && a.freewheel_long == b.freewheel_long &&
         (a.reason == b.reason || !(a.lost || a.fatal));
}

class Story : public RandomWords {
 public:
  explicit Story(std::uint32_t seed) : RandomWords(seed) { words(); }

  // Levels hold for three clocks before a clock with strobes, and stay in it.
  void levels() {
    // An attempt that ended is followed by a rest.
    in.running = running_ ? in.running && !one_in(200) : one_in(20);
    running_ = in.running;
    if (one_in(400) || (!running_ && one_in(20))) words();
    if (one_in(30)) in.hall = one_in(4);
    if (one_in(40)) kind_ = below(5);
    in.slow = kind_ == 1 && !one_in(20);
    in.slips = kind_ == 2 && !one_in(4);
    in.freewheel = one_in(3) ? in.words.freewheel : wrap<Phase>(in.words.freewheel + UInt<16>::of(below(3)));
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
  void words() {
    auto& w = in.words;
    w.misses = one_in(8) ? UInt<6>(0) : UInt<6>::of(1 + below(20));
    w.wrong_lock = one_in(8) ? Ticks(0) : Ticks::of(1 + below(40));
    w.over_current = one_in(4) ? decltype(w.over_current)(0) : decltype(w.over_current)::of(8 + below(8));
    w.freewheel = Phase::of(below(0xfff0));
  }
  unsigned kind_ = 0;
  bool running_ = false;  // before this change of levels
};

int differences(std::uint32_t seed, int strobes, std::map<Reason, int>* reasons = nullptr, const std::function<void(In&)>& spoil = [](In&) {}) {
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
  for (const Reason r : {Reason::kFaultPin, Reason::kOverCurrent, Reason::kStepOut, Reason::kStall, Reason::kWrongLock, Reason::kHallCode}) {
    EXPECT_GT(reasons[r], 100) << int(r);
  }
}

TEST(ProtectionLaw, ADifferenceOfOneIsFound) {
  const auto found = [](const std::function<void(In&)>& spoil) { return differences(7, 20000, nullptr, spoil) > 0; };
  EXPECT_TRUE(found([](In& in) { if (in.words.misses != 0) in.words.misses = in.words.misses ^ UInt<6>(1); }));
  EXPECT_TRUE(found([](In& in) { if (in.words.misses == 0) in.words.misses = 1; }));
  EXPECT_TRUE(found([](In& in) { in.words.wrong_lock = in.words.wrong_lock ^ Ticks(1); }));
  EXPECT_TRUE(found([](In& in) { in.words.freewheel = wrap<Phase>(in.words.freewheel + UInt<16>(1)); }));
  EXPECT_TRUE(found([](In& in) { in.words.over_current = wrap<UInt<4>>(in.words.over_current + UInt<4>(1)); }));
  EXPECT_TRUE(found([](In& in) { in.lags = false; }));
  EXPECT_TRUE(found([](In& in) { in.good = false; }));
  EXPECT_TRUE(found([](In& in) { in.hall = false; }));
  EXPECT_TRUE(found([](In& in) { in.commutate = true; })) << "freewheeling is long in the clock of a commutation";
}

}  // namespace
}  // namespace steplock
