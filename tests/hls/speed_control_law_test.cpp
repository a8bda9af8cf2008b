// The speed control's machine against its law, bit for bit: every mode, random words and corners, state kept.
#include "hls/six_step/speed_control_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "model/reference/speed_control.hpp"
#include "tests/hls/random_config.hpp"

namespace steplock {
namespace {

using In = SpeedControl::In;

class Config : public RandomConfig {
 public:
  using RandomConfig::RandomConfig;

  Duty duty() { return one_in(4) ? Duty(one_in(2) ? 0x8000 : 0) : Duty::of(below(0x8001)); }

  // Words that a motor may have, so that the duty is not at a bound all the time; or any.
  SpeedConfig config() {
    SpeedConfig w;
    const bool any = one_in(4);
    w.target = any ? word<26>() : Frequency::of(below(1 << 20));
    w.slew = any ? word<20>() : UInt<20>::of(below(1 << 16));
    w.shift = any ? word<4>() : UInt<4>(5);
    w.kp = any ? word<16>() : UInt<16>::of(below(1 << 14));
    w.ki = any ? word<16>() : UInt<16>::of(below(1 << 12));
    w.bemf = any ? word<16>() : UInt<16>::of(below(1 << 12));
    w.loaded = any ? word<16>() : UInt<16>::of(w.bemf.raw() + below(1 << 10));
    w.minimum = any ? duty() : Duty(600);
    w.maximum = any ? duty() : Duty(0x8000);
    w.duty_slew = word<12>();
    return w;
  }
  void change(In& in, Duty duty_now) {
    if (one_in(30)) in.config = config(), in.target = in.config.target;
    if (one_in(20)) in.mode = one_in(2)   ? SpeedMode::kControl
                             : one_in(2) ? SpeedMode::kFixed
                             : one_in(2) ? SpeedMode::kFeedForwardBrake
                                         : SpeedMode::kFeedForwardDrive;
    if (one_in(20)) in.fixed_duty = duty(), in.period = word<14>(), in.slip = duty();
    // Lower targets, and a rotor that comes near to them.
    if (one_in(15)) in.target = one_in(3) ? in.config.target : Frequency::of(below(in.target.raw() + 1));
    const std::int64_t near = in.target.raw() + static_cast<int>(below(2001)) - 1000;
    in.frequency = one_in(3) ? in.frequency : one_in(2) ? word<26>() : Frequency::of(std::uint64_t(near < 0 ? 0 : near & 0x3ffffff));
    // A rotor that hardly turns, whose duty is next to the slip: a last bit of that decides.
    if (one_in(20)) in.slip = duty_now, in.frequency = Frequency::of(below(4));
    in.masked_lead = one_in(6);
    in.freewheels = one_in(3);
    in.limited = one_in(3);
  }

};

struct Seen {
  Duty duty;
  Clocks on_clocks;
  bool slips;
  bool operator==(const Seen&) const = default;
};

// One tick of the machine, worked on to its end; a cut of the current limit comes before it.
Seen update(SpeedControl& dut, In in) {
  const bool limited = in.limited;
  in.limited = false;
  for (int i = 0; i < 3; ++i) dut.tick(in);  // what the last one left
  in.limited = limited;
  dut.tick(in);
  in.limited = false;
  dut.tick(in);
  in.tick = true;
  dut.tick(in);
  in.tick = false;
  SpeedControl::Out out = dut.tick(in);
  int changes = 0;
  for (int i = 0; i < 150; ++i) {
    const Clocks before = out.on_clocks;
    out = dut.tick(in);
    changes += out.on_clocks != before;
  }
  EXPECT_LE(changes, 1) << "nothing on its way shows";
  return {out.duty, out.on_clocks, out.slips};
}

Seen seen(const SpeedControlLaw& law) { return {law.duty, law.on_clocks, law.slips}; }

// Ticks in which machine and law differ, and how often each state was reached.
struct Found {
  int differ = 0, controlled = 0, resumed = 0, asked = 0, slipped = 0, at_high = 0, at_low = 0;
};
Found compare(Config config, int ticks, const std::function<void(In&)>& spoil = [](In&) {}) {
  SpeedControl dut;
  SpeedControlLaw law;
  In in;
  in.config = config.config();
  Found found;
  for (int k = 0; k < ticks; ++k) {
    config.change(in, law.duty);
    In other = in;
    spoil(other);
    found.resumed += law.resumes && in.mode == SpeedMode::kControl;
    law.tick(other);
    found.differ += update(dut, in) != seen(law);
    found.controlled += in.mode == SpeedMode::kControl;
    found.asked += law.asks && in.freewheels;
    found.slipped += law.slips, found.at_high += law.at_high, found.at_low += law.at_low;
  }
  return found;
}

TEST(SpeedControlLaw, IsWhatTheMachineDoes) {
  Found all;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Found f = compare(Config(seed), 3000);
    ASSERT_EQ(f.differ, 0) << seed;
    all.controlled += f.controlled, all.resumed += f.resumed, all.asked += f.asked, all.slipped += f.slipped;
    all.at_high += f.at_high, all.at_low += f.at_low;
  }
  // Nothing of it was left out.
  EXPECT_GT(all.controlled, 10000);
  EXPECT_GT(all.resumed, 100);
  EXPECT_GT(all.asked, 1000);
  EXPECT_GT(all.slipped, 1000);
  EXPECT_GT(all.at_high, 1000);
  EXPECT_GT(all.at_low, 1000);
}

// 2^-13 of the duty in a tick, and a last bit less.
TEST(SpeedControlLaw, AsksFromItsBoundOn) {
  for (const int less : {0, 1}) {
    SpeedControl dut;
    SpeedControlLaw law;
    In in{.fixed_duty = 10000, .frequency = 1 << 18};
    in.config = {.slew = UInt<20>::max(), .shift = 5, .ki = 1 << 8, .maximum = 0x8000, .duty_slew = 50};
    law.tick(in);
    ASSERT_EQ(update(dut, in), seen(law));
    in.mode = SpeedMode::kControl;
    in.target = (1 << 18) + (1 << 15) + 1 - less;  // ki e is 2^18 of 2^31
    in.freewheels = true;
    law.tick(in);
    EXPECT_EQ(law.asks, less == 0);
    EXPECT_EQ(update(dut, in), seen(law));
  }
}

// The comparison sees a last bit of each word.
TEST(SpeedControlLaw, ADifferenceOfOneBitIsFound) {
  const auto found = [](const std::function<void(In&)>& spoil) { return compare(Config(7), 40000, spoil).differ > 0; };
  EXPECT_TRUE(found([](In& in) { in.target = in.target ^ Frequency(1); }));
  EXPECT_TRUE(found([](In& in) { in.frequency = in.frequency ^ Frequency(1); }));
  EXPECT_TRUE(found([](In& in) { in.fixed_duty = in.fixed_duty ^ Duty(1); }));
  EXPECT_TRUE(found([](In& in) { in.slip = in.slip ^ Duty(1); }));
  EXPECT_TRUE(found([](In& in) { in.config.slew = in.config.slew ^ UInt<20>(1); }));
  EXPECT_TRUE(found([](In& in) { in.config.kp = in.config.kp ^ UInt<16>(1); }));
  EXPECT_TRUE(found([](In& in) { in.config.ki = in.config.ki ^ UInt<16>(1); }));
  EXPECT_TRUE(found([](In& in) { in.config.bemf = in.config.bemf ^ UInt<16>(1); }));
  EXPECT_TRUE(found([](In& in) { in.config.loaded = in.config.loaded ^ UInt<16>(1); }));
  EXPECT_TRUE(found([](In& in) { in.config.minimum = in.config.minimum ^ Duty(1); }));
  EXPECT_TRUE(found([](In& in) { in.config.maximum = in.config.maximum ^ Duty(1); }));
  EXPECT_TRUE(found([](In& in) { in.config.duty_slew = in.config.duty_slew ^ UInt<12>(1); }));
  EXPECT_TRUE(found([](In& in) { in.masked_lead = false; }));
  EXPECT_TRUE(found([](In& in) { in.freewheels = false; }));
  EXPECT_TRUE(found([](In& in) { in.limited = false; }));
}

// The reference in doubles beside the law, in its last places of a frequency and in ticks; what the law may be away: a last
// place of the error (the one's complement), of the integral in each tick, and two of the duty.  The times that it is further away.
int beyond_truncations(
    Config config, int ticks,
    const std::function<void(design::SpeedParameters&)>& spoil = [](design::SpeedParameters&) {}) {
  int beyond = 0;
  for (int run = 0; run < ticks / 50; ++run) {
    In in;
    in.fixed_duty = 0x3000 + config.below(0x2000), in.frequency = Frequency::of((1u << 17) + config.below(1u << 17));
    in.config = {.slew = 200 + config.below(1000), .shift = 4, .kp = config.below(1 << 12), .ki = config.below(1 << 12), .maximum = 0x8000,
                .duty_slew = UInt<12>::max()};
    const double kp = std::ldexp(double(in.config.kp.raw()), -4 - 12 - 15), ki = std::ldexp(double(in.config.ki.raw()), -4 - 31);
    design::SpeedParameters p{.slew = double(in.config.slew.raw()), .kp = kp, .ki = ki, .minimum = 0, .maximum = 1, .duty_slew = 0.124};
    spoil(p);
    reference::SpeedControl control(p, 1);
    SpeedControlLaw law;
    law.tick(in);
    const auto duty = [](Duty d) { return std::ldexp(double(d.raw()), -15); };
    control.follow(duty(law.duty), duty(law.duty), double(in.frequency.raw()));
    in.mode = SpeedMode::kControl;
    in.target = in.frequency.raw() + 5000 + config.below(20000);  // upwards: where it came down, control begins once more
    double of_integral = 0;
    for (int k = 0; k < 50; ++k) {
      in.frequency = Frequency::of(std::uint64_t(law.reference.raw()) + config.below(2000) - 1000);
      law.tick(in);
      control.tick(double(in.target.raw()), double(in.frequency.raw()), false);
      of_integral += ki + 0x1p-31;
      EXPECT_FALSE(law.at_low || law.at_high);
      beyond += std::abs(duty(law.duty) - control.duty()) > of_integral + kp + 0x1p-27 + 2 * 0x1p-15;
    }
  }
  return beyond;
}

TEST(SpeedControlLaw, EqualsTheReferenceWithinItsTruncations) {
  EXPECT_EQ(beyond_truncations(Config(5), 20000), 0);
  // Sixteen last places of a gain, or one of the slew, are more.
  EXPECT_GT(beyond_truncations(Config(5), 20000, [](design::SpeedParameters& p) { p.kp += 0x1p-27; }), 0);
  EXPECT_GT(beyond_truncations(Config(5), 20000, [](design::SpeedParameters& p) { p.ki += 0x1p-31; }), 0);
  EXPECT_GT(beyond_truncations(Config(5), 20000, [](design::SpeedParameters& p) { p.slew += 1; }), 0);
}

}  // namespace
}  // namespace steplock
