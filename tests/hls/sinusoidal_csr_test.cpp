// Requests without a bus; the map itself is tested through each bus (sinusoidal_axi_test and its like).
#include "hls/bus/sinusoidal_csr.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "tests/hls/map_model.hpp"

namespace steplock {
namespace {

using Drive = Behind<Sinusoidal>;

struct Bench {
  SinusoidalCsr dut;
  SinusoidalCsr::In in;
  SinusoidalCsr::Out out;

  void tick(const BusRequest& request = {}) {
    Drive::pins(in, out, false);
    in.request = request;
    out = dut.tick(in);
  }
  bool write(int address, std::uint32_t data) {
    tick({.write = true, .index = WordIndex::of(address / 4), .data = data, .strobes = 15});
    tick();
    return !out.write_error;
  }
  std::uint32_t read(int address) {
    tick({.read = true, .index = WordIndex::of(address / 4)});
    tick();
    return std::uint32_t(out.data.raw());
  }
};

TEST(SinusoidalCsr, AnAnswerComesInTheNextClockAndStaysUntilTheNextRequestOfItsKind) {
  Bench b;
  b.tick({.read = true, .index = 0});
  for (int clock = 0; clock < 5; ++clock) {
    b.tick({.write = true, .index = 0, .data = 1, .strobes = 15});
    EXPECT_EQ(b.out.data, UInt<32>(kMapId)) << "a write changes nothing of a read's answer";
    EXPECT_FALSE(b.out.read_error);
    EXPECT_EQ(b.out.write_error, clock > 0) << "the ID is read-only";
  }
  EXPECT_EQ(b.read(0xffc), 0u);
  EXPECT_TRUE(b.out.read_error) << "a hole";
}

TEST(SinusoidalCsr, SaysThatItIsASinusoidalDrive) {
  Bench b;
  EXPECT_EQ(b.read(address_of(index_of<Sinusoidal>("CAPABILITY"))) & 0x1f, 2u) << "and has no Hall decoder";
}

// Clocks in which each gate was on, in a pattern that lasts, and what a leg shows.
struct Life {
  int high = 0, low = 0, both = 0, shortest_gap = 1 << 30;
};
struct Value {
  int address;
  std::uint32_t data;
};
template <class... Values>
Life life_with(Values... bad) {
  Bench b;
  b.write(kLock, kLockKey);
  for (const auto& [address, value] : Drive::config()) b.write(address, value);
  (b.write(bad.address, bad.data), ...);
  b.write(kControl, 3);
  Life life;
  int off_for[3] = {1 << 20, 1 << 20, 1 << 20};
  Gates was;
  for (int clock = 0; clock < 80'000; ++clock) {
    b.tick();
    const Gates g = b.out.gates;
    const bool highs[] = {g.uh, g.vh, g.wh}, lows[] = {g.ul, g.vl, g.wl};
    const bool were_high[] = {was.uh, was.vh, was.wh}, were_low[] = {was.ul, was.vl, was.wl};
    for (int leg = 0; leg < 3; ++leg) {
      life.high += highs[leg];
      life.low += lows[leg];
      life.both += highs[leg] && lows[leg];
      const bool turns_on = (highs[leg] && !were_high[leg]) || (lows[leg] && !were_low[leg]);
      if (turns_on && off_for[leg] < life.shortest_gap) life.shortest_gap = off_for[leg];
      off_for[leg] = highs[leg] || lows[leg] ? 0 : off_for[leg] + 1;
    }
    was = g;
  }
  return life;
}

// As docs/programmers_guide.md has it, "Values that make no sense".
TEST(SinusoidalCsr, ValuesThatMakeNoSenseLeaveTheBridgeSafe) {
  constexpr int limits = address_of(index_of<Sinusoidal>("PWM_LIMITS"));
  constexpr int inverse = address_of(index_of<Sinusoidal>("PWM_RECIPROCAL"));
  constexpr int start = address_of(index_of<Sinusoidal>("START"));
  const Life good = life_with();
  EXPECT_GT(good.high, 5000);
  EXPECT_GT(good.low, 50'000);

  const Life no_period = life_with(Value{kPwm, 0});
  EXPECT_EQ(no_period.high + no_period.low, 0) << "all six gates are off";
  const Life short_period = life_with(Value{kPwm, kShortestPeriod - 1});
  EXPECT_EQ(short_period.high + short_period.low, 0) << "likewise";
  const Life shortest = life_with(Value{kPwm, kShortestPeriod});
  EXPECT_GT(shortest.high, 5000);

  const Life no_dead_time = life_with(Value{limits, 0});
  EXPECT_GE(no_dead_time.shortest_gap, int(kDeadTimeFloor));
  const Life large_minimum = life_with(Value{limits, 0x3fff});
  EXPECT_EQ(large_minimum.high, 0) << "every pulse is shorter";
  const Life wrong_inverse = life_with(Value{inverse, 0});
  const Life whole_voltage = life_with(Value{start, 0x7fffu << 16});
  EXPECT_GT(whole_voltage.high, 2 * good.high);
  const Life nothing = life_with(Value{start, 0});
  EXPECT_LE(nothing.high, 3 * 2 * Drive::kPeriod / 2) << "no voltage: all legs alike, in the first two periods";

  for (const Life& life : {good, no_period, short_period, shortest, no_dead_time, large_minimum, wrong_inverse,
                           whole_voltage, nothing}) {
    EXPECT_EQ(life.both, 0);
    EXPECT_GE(life.shortest_gap, int(kDeadTimeFloor));
  }
}

// Without the registers a period that no sample fits is one: what the test above would see.
TEST(SinusoidalCsr, TheDriveItselfTakesEveryPeriod) {
  SinusoidalTop drive;
  SinusoidalTop::In in;
  SinusoidalTop::Out out;
  in.command = {.configured = true, .run = true};
  in.config.bridge.period = kShortestPeriod - 1;
  in.config.sequence.pattern = 1000;
  in.config.speed.target = 1 << 20;
  int on = 0;
  for (int clock = 0; clock < 50'000; ++clock) {
    Drive::pins(in, out, false);
    out = drive.tick(in);
    on += out.gates.ul;
  }
  EXPECT_GT(on, 20'000);
}

TEST(SinusoidalCsr, APeriodOfZeroIsToldAndMended) {
  constexpr std::uint32_t bit = 1u << field<Sinusoidal>("STATUS", "no_period").lsb;
  Bench b;
  EXPECT_TRUE(b.read(kStatus) & bit) << "after a reset";
  b.write(kPwm, kShortestPeriod);
  EXPECT_FALSE(b.read(kStatus) & bit);
  b.write(kPwm, kShortestPeriod - 1);
  EXPECT_TRUE(b.read(kStatus) & bit);
}

// Before its words are written any current is too large and any ADC late; but that is no fault.
TEST(SinusoidalCsr, WithoutWordsNoFaultIsLatched) {
  Bench b;
  for (int clock = 0; clock < 5000; ++clock) {
    b.tick();
    b.in.codes = {.valid = clock % 700 == 0, .u = 20, .v = -7, .dc = 2700};
    b.out = b.dut.tick(b.in);
  }
  EXPECT_FALSE(b.out.fault);
  b.write(kPwm, 700);
  EXPECT_TRUE(b.write(kControl, 1));
  for (int clock = 0; clock < 2000 && !b.out.fault; ++clock) {
    b.tick();
    b.in.codes = {.valid = clock % 700 == 0, .u = 20, .v = -7, .dc = 2700};
    b.out = b.dut.tick(b.in);
  }
  EXPECT_TRUE(b.out.fault) << "a limit of 0 with words that are said to be valid";
}

// A drive that regulates behind its registers, and one without any beside it, given the same words at the same
// clocks; but the set-point only with the codes of a sample, `late` of them later.
class Beside {
 public:
  explicit Beside(int late) : late_(late) {
    SinusoidalConfig w;
    w.bridge = {.period = 1200, .minimum = 12, .dead_time = 12, .dead_time_loss = 192, .compensate = true, .reciprocal = 9321};
    w.estimator = {.decay = 3113, .gain = 3686, .k_theta = 3277, .k_e = 541, .k_speed = 5894};
    // Gains ten times a drive's: what the set-point does in one sample shows in the gates.
    w.speed = {.target = 1 << 20, .slew = 30000, .filter = 983, .k_p = 7000, .k_i = 5300, .limit = 12288};
    w.control = {.set_gamma = -300, .k_p = 1092, .k_i = 831, .inductance = 892, .emf = 1425, .limit = 18919};
    w.sequence = {.arbitrary = true, .lock = 0, .give_up = 100'000, .brake = 10, .retry_delay = 10};
    w.fault = {.over_current = 30000};
    write(kLock, kLockKey);
    std::map<int, std::uint32_t> values;
    const auto place = [&](const auto& row) {
      using Word = typename std::remove_cvref_t<decltype(row)>::Word;
      values[row.address] |= std::uint32_t(bits_of(Word::of(w)).raw()) << row.lsb;
    };
    std::apply([&](const auto&... row) { (place(row), ...); }, kSinusoidalWordRows);
    for (const auto& [address, value] : values) write(address, value);
    write(kControl, 3);
  }
  void write(int address, std::uint32_t data) {
    tick({.write = true, .index = WordIndex::of(address / 4), .data = data, .strobes = 15});
  }
  // Codes come 100 clocks after the strobe; with `again` in every clock of the sample too.
  void tick(const BusRequest& request = {}, bool again = false) {
    if (out.sample) since_ = 0;
    const bool due = since_ == 100, under_way = since_ > 100 && since_ < 100 + SinusoidalLoop::kClocks;
    CurrentSense::Codes codes{.valid = due, .u = int(random_() % 201) - 100, .v = int(random_() % 201) - 100, .dc = 2700};

    auto config = config_.tick({.request = request, .stopped = true}).config;
    if (request.write && request.index == index_of("SPEED_TARGET")) {
      target_ = request.data.raw();
      if (!command_[1].run) taken_ = target_;  // at once while the drive is stopped
    }
    config.speed.target = UInt<25>::of(taken_);
    const auto alone = alone_.tick({.fault = false, .codes = codes, .command = command_[0], .config = config});
    command_[0] = command_[1];
    if (request.write && request.index == kControl / 4) {
      command_[1].configured = request.data.bit(0);
      command_[1].run = request.data.bit(1);
    }
    samples += due;
    if (due && waits_ == 0) taken_ = target_;
    if (due && waits_ > 0) --waits_;
    if (request.write) waits_ = late_;

    codes.valid = due || (again && under_way);
    out = registered_.tick({.fault = false, .codes = codes, .request = request});
    differs += !(out.gates == alone.gates) || out.sample != alone.sample;
    moves += !(out.gates == was_);
    was_ = out.gates;
    if (since_ >= 0) ++since_;
  }
  SinusoidalCsr::Out out;
  int samples = 0, differs = 0, moves = 0;

 private:
  int late_;
  std::mt19937_64 random_{1};
  SinusoidalCsr registered_;
  ConfigRegisters<Sinusoidal> config_;
  SinusoidalTop alone_;
  Command command_[2];
  std::uint64_t target_ = 0, taken_ = 0;
  int since_ = -1, waits_ = 0;
  Gates was_;
};

// Whenever the host writes it, the set-point acts from the next codes on; and codes that come while a sample is
// under way are none.
int differences(int late) {
  constexpr int target = address_of(index_of("SPEED_TARGET"));
  std::mt19937_64 random(1);
  int differs = 0;
  for (int run = 0; run < 16; ++run) {
    Beside b(late);
    const int first = 50 * 1200 + int(random() % 1200);
    for (int clock = 0; clock < 64 * 1200; ++clock) {
      if (clock == first) {
        b.write(target, 1 << 21);
      } else {
        b.tick({}, run % 2 == 0);
      }
    }
    EXPECT_GT(b.samples, 60);
    EXPECT_GT(b.moves, 200);
    differs += b.differs;
  }
  return differs;
}
TEST(SinusoidalCsr, TheSetPointIsTakenOverWithTheCodesOfASample) { EXPECT_EQ(differences(0), 0); }
TEST(SinusoidalCsr, ASetPointThatIsASampleLateIsNoticed) { EXPECT_GT(differences(1), 100); }

}  // namespace
}  // namespace steplock
