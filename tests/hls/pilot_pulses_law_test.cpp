// The machine of the pilot pulses against their law, bit for bit: random currents, corners of each verdict, and every wait.
#include "hls/sinusoidal/pilot_pulses_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "tests/hls/random_config.hpp"

namespace steplock {
namespace {

using R = SinusoidalReason;
using Pulse = PilotPulsesLaw::Pulse;
using Seen = PilotPulsesLaw::Seen;

// What stands for the ADCs and the current control: any currents, but the same for the same question.
class Currents {
 public:
  Currents(std::uint32_t seed, const PilotConfig& config) : seed_(seed), config_(config) {}

  Int<16> peak(int winding, bool reversed, Angle axis, int number) const {
    RandomConfig r = answer(winding * 2 + reversed, int(axis.raw() >> 8), number);
    // The long ones about the bound of polarity, most of the time.
    const int half = int(config_.polarity.raw()) / 2, step = int(r.below(5)) - 2;
    if (number >= 6 * int(config_.rounds.raw()) && !r.one_in(4)) return signed_word((r.one_in(2) ? half : -half) + step);
    return signed_word(int(r.word<16>().raw()));
  }
  Seen seen(Int<16> u, Int<16> v, Angle from) const {
    RandomConfig r = answer(int(u.raw()), int(v.raw()), int(from.raw() >> 8));
    const int along = r.one_in(3) ? int(r.word<16>().raw()) : int(config_.saliency.raw()) + int(r.below(5)) - 1;
    return {signed_word(along), r.one_in(2)};
  }

 private:
  static Int<16> signed_word(int x) { return wrap<Int<16>>(Int<20>(((x + 0x8000) & 0xffff) - 0x8000)); }
  RandomConfig answer(int a, int b, int c) const {
    return RandomConfig((((seed_ * 31337u + unsigned(a)) * 65537u + unsigned(b)) * 40503u + unsigned(c)) * 2654435761u);
  }
  std::uint32_t seed_;
  PilotConfig config_;
};

struct Result {
  Angle angle = 0;
  R failed = R::kNone;
  std::vector<Pulse> pulses;
  bool operator==(const Result&) const = default;
};

PilotConfig random_config(RandomConfig& r) {
  return {.short_periods = UInt<6>::of(r.below(4)),
          .long_periods = UInt<6>::of(r.below(8)),
          .rounds = UInt<5>::of(2 + 2 * r.below(3)),
          .decayed = r.word<15>(),
          .saliency = r.one_in(3) ? UInt<15>::of(r.below(4)) : UInt<15>::of(r.below(0x4000)),
          .polarity = r.one_in(3) ? UInt<15>::of(r.below(4)) : UInt<15>::of(r.below(0x2000))};
}

Result by_law(const PilotConfig& config, const Currents& currents) {
  Result result;
  PilotPulsesLaw law;
  law.find(config,
           [&](Pulse pulse, Angle axis) {
             const auto i = currents.peak(pulse.winding, pulse.reversed, axis, int(result.pulses.size()));
             pulse.periods = std::max(pulse.periods, 1);  // 0 counts as 1
             result.pulses.push_back(pulse);
             return i;
           },
           [&](Int<16> u, Int<16> v, Angle from) { return currents.seen(u, v, from); });
  result.failed = law.failed;
  if (law.failed == R::kNone) result.angle = Angle(law.angle) << 11;
  return result;
}

// Periods of random length, in which a sample is taken and worked through; currents that decay in their own time.
Result by_machine(PilotPulses& dut, const PilotConfig& config, const Currents& currents, RandomConfig r) {
  Result result;
  PilotPulses::In in{.enable = true, .config = config};
  PilotPulses::Out out;
  bool was = false;
  int decays = 0, quiet = 0;  // samples: with a current that has not decayed yet, and in a row without one
  for (int period = 0; period < 2000; ++period) {
    const int taken = 1 + int(r.below(3)), sampled = taken + 2 + int(r.below(3)), clocks = sampled + 2 + int(r.below(3));
    for (int clock = 0; clock < clocks; ++clock) {
      in.period = clock == 0, in.taken = clock == taken, in.sampled = clock == sampled;
      const bool reversed = out.high_u + out.high_v + out.high_w == 2;
      const int winding = out.high_v == reversed && out.high_w == reversed ? 0 : out.high_u == reversed && out.high_w == reversed ? 1 : 2;
      // As a sample is worked through: the sum, or the pulse before.
      const int number = int(result.pulses.size()) - 1;
      if (in.sampled && out.search) {
        const Seen sum = currents.seen(out.a, out.b, out.angle);
        in.i_gamma = sum.along, in.backward = sum.backward;
      } else if (in.sampled && number >= 0) {
        in.i_gamma = currents.peak(winding, reversed, out.angle, number);
      }
      in.over = out.waiting && decays > 0;
      if (in.sampled && out.waiting && !out.search) quiet = in.over ? 0 : quiet + 1;
      if (in.sampled && decays > 0) --decays;
      out = dut.tick(in);
      if (out.found || out.failed != R::kNone) {
        result.failed = out.failed;
        if (out.found) result.angle = out.angle;
        return result;
      }
      if (clock == 1) {
        if (out.pulse && !was) {
          EXPECT_EQ(quiet, 2) << "before each pulse";
          quiet = 0;
          result.pulses.push_back({winding, reversed, 0});
        }
        if (out.pulse) ++result.pulses.back().periods;
        if (!out.pulse && was) decays = int(r.below(4));
        was = out.pulse;
      }
    }
  }
  result.pulses.clear();  // never over
  return result;
}

struct Found {
  int differ = 0, found = 0, turned = 0, no_saliency = 0, no_polarity = 0;
};
Found compare(int seeds, const std::function<void(PilotConfig&)>& spoil = [](PilotConfig&) {}) {
  Found found;
  PilotPulses dut;  // one for all: each begins from a rest
  for (int seed = 1; seed <= seeds; ++seed) {
    RandomConfig r(static_cast<std::uint32_t>(seed));
    const PilotConfig config = random_config(r);
    const Currents currents(static_cast<std::uint32_t>(seed), config);
    PilotConfig other = config;
    spoil(other);
    const Result law = by_law(other, currents);
    PilotPulses::In rest;
    rest.rest = true;
    dut.tick(rest);
    found.differ += !(by_machine(dut, config, currents, r) == law);
    found.found += law.failed == R::kNone;
    found.turned += law.failed == R::kNone && law.angle.bit(23);
    found.no_saliency += law.failed == R::kNoSaliency;
    found.no_polarity += law.failed == R::kNoPolarity;
  }
  return found;
}

TEST(PilotPulsesLaw, IsWhatTheMachineDoes) {
  const Found f = compare(3000);
  EXPECT_EQ(f.differ, 0);
  // Nothing of it was left out.
  EXPECT_GT(f.found, 300);
  EXPECT_GT(f.turned, 100);
  EXPECT_GT(f.no_saliency, 300);
  EXPECT_GT(f.no_polarity, 100);
}

// The comparison sees a last bit of each word, and another sum.
TEST(PilotPulsesLaw, ADifferenceOfOneBitIsFound) {
  const auto found = [](const std::function<void(PilotConfig&)>& spoil) { return compare(1000, spoil).differ > 0; };
  EXPECT_TRUE(found([](PilotConfig& w) { w.short_periods = wrap<UInt<6>>(w.short_periods + 1); }));
  EXPECT_TRUE(found([](PilotConfig& w) { w.long_periods = wrap<UInt<6>>(w.long_periods + 1); }));
  EXPECT_TRUE(found([](PilotConfig& w) { w.rounds = wrap<UInt<5>>(w.rounds + 2); }));
  EXPECT_TRUE(found([](PilotConfig& w) { w.saliency = w.saliency ^ UInt<15>(1); }));
  EXPECT_TRUE(found([](PilotConfig& w) { w.polarity = w.polarity ^ UInt<15>(1); }));
}

}  // namespace
}  // namespace steplock
