#include "hls/bus/config_registers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "hls/bus/sinusoidal_registers.hpp"
#include "hls/bus/six_step_registers.hpp"

namespace steplock {
namespace {

// The registers, and a bus that writes and reads them one after the other.
template <class Map = SixStep>
struct Bench {
  ConfigRegisters<Map> dut;
  bool stopped = true;
  bool boundary = false;

  typename ConfigRegisters<Map>::Out tick(const BusRequest& request) {
    return dut.tick({.request = request, .stopped = stopped, .boundary = boundary});
  }
  // Whether it was obeyed.
  bool write(int index, std::uint32_t data, int strobes = 15) {
    return !tick({.write = true, .index = index, .data = data, .strobes = strobes}).refused;
  }
  std::uint32_t read(int index) {
    tick({.read = true, .index = index});
    return std::uint32_t(tick({}).data.raw());
  }
  typename Map::Config config() { return tick({}).config; }
  void unlock() { write(index_of("LOCK"), kLockKey); }
};

constexpr int kPwm = index_of("PWM"), kPwmLimits = index_of("PWM_LIMITS");
constexpr int kTarget = index_of("SPEED_TARGET"), kGain = index_of("SPEED_GAIN");

template <class Map = SixStep>
std::uint32_t all_of(int index) {
  std::uint32_t bits = 0;
  std::apply([&](const auto&... row) {
    ((bits |= row.address == 4 * index ? mask_of(row) : 0), ...);
  }, Map::kWordRows);
  return bits;
}

// The words of PWM and PWM_LIMITS, which every drive has.
const auto& bridge(const SixStepConfig& config) { return config.pwm; }
const auto& bridge(const SinusoidalConfig& config) { return config.bridge; }

// What holds for every map.
template <class Map>
struct ConfigRegistersOf : testing::Test {};
using Maps = testing::Types<SixStep, Sinusoidal>;
TYPED_TEST_SUITE(ConfigRegistersOf, Maps);

TYPED_TEST(ConfigRegistersOf, ResetIsThatOfTheTable) {
  Bench<TypeParam> bench;
  for (const Field& f : TypeParam::kFields) {
    if (f.address < 0x80) continue;
    EXPECT_EQ(bench.read(f.address / 4) >> f.lsb & (mask_of(f) >> f.lsb), f.reset)
        << f.group << '.' << f.name;
  }
}

TYPED_TEST(ConfigRegistersOf, SaysWhatItIs) {
  Bench<TypeParam> bench;
  EXPECT_EQ(bench.read(index_of("ID")), 0x53544c4bu);
  EXPECT_EQ(bench.read(index_of("VERSION")), kMapVersion);
  const std::uint32_t capability = bench.read(index_of("CAPABILITY"));
  EXPECT_EQ(capability >> 8 & 255, 12u) << "floor of the dead time, clocks";
  EXPECT_EQ(capability >> 16 & 7, 1u) << "axes";
}

TYPED_TEST(ConfigRegistersOf, WhatStandsElsewhereReadsZero) {
  Bench<TypeParam> bench;
  EXPECT_EQ(bench.tick({}).data, UInt<32>(0)) << "nothing was read";
  bench.write(index_of("CONTROL"), 15);
  for (int index = index_of("CONTROL"); index < kPwm; ++index) EXPECT_EQ(bench.read(index), 0u);
  bench.read(kPwm);
  EXPECT_EQ(bench.read(0x60), 0u) << "no alias of PWM";
  EXPECT_EQ(bench.read(0x40), 0u) << "nor of ID";
}

TEST(ConfigRegisters, AnAnswerStaysUntilTheNextRead) {
  Bench<> bench;
  EXPECT_EQ(bench.read(kPwm), 1u << 24);
  bench.write(kPwm, 100);
  EXPECT_EQ(bench.tick({}).data, UInt<32>(1u << 24));
}

// A register whose first write is of some bytes: the others keep their reset values.
TEST(ConfigRegisters, BytesThatWereNeverWrittenReadTheirReset) {
  const int bemf = index_of("BEMF"), place = index_of("LOOP_PHASE");
  for (int strobes = 0; strobes < 16; ++strobes) {
    Bench<> bench;
    const auto mask = std::uint32_t(byte_mask(UInt<4>(strobes)).raw());
    for (const int index : {bemf, place}) {
      const std::uint32_t reset = bench.read(index);
      EXPECT_TRUE(bench.write(index, ~0u, strobes));
      EXPECT_EQ(bench.read(index), (reset & ~mask) | (all_of(index) & mask)) << strobes;
      EXPECT_TRUE(bench.write(index, 0, strobes));
      EXPECT_EQ(bench.read(index), reset & ~mask) << strobes;
    }
  }
}

// 477 clocks is what a sample takes; docs/sinusoidal_registers.md.
TEST(ConfigRegisters, TellsAPeriodThatIsTooShortForASample) {
  Bench<Sinusoidal> bench;
  EXPECT_TRUE(bench.tick({}).no_period);
  bench.write(kPwm, 476);
  EXPECT_TRUE(bench.tick({}).no_period);
  bench.write(kPwm, 477);
  EXPECT_FALSE(bench.tick({}).no_period);
}

// A signed word among unsigned ones.
TEST(ConfigRegisters, ANegativeCurrentIsOne) {
  Bench<Sinusoidal> bench;
  const int current = index_of<Sinusoidal>("CURRENT");
  EXPECT_TRUE(bench.write(current, 0x1234'fffe));
  EXPECT_EQ(bench.config().control.set_gamma, -2);
  EXPECT_EQ(bench.config().control.limit, 0x1234);
  EXPECT_EQ(bench.read(current), 0x1234'fffeu);
  EXPECT_TRUE(bench.write(current, 0xab00, 2)) << "one byte of it";
  EXPECT_EQ(bench.config().control.set_gamma, Int<16>::of(0xabfe));
}

TEST(ConfigRegisters, TellsAPeriodOfZero) {
  Bench<> bench;
  EXPECT_TRUE(bench.tick({}).no_period);
  bench.write(kPwm, 1u << 13);
  EXPECT_FALSE(bench.tick({}).no_period);
  bench.write(kPwm, 0xffff'0000);
  EXPECT_TRUE(bench.tick({}).no_period) << "the other fields do not count";
}

TYPED_TEST(ConfigRegistersOf, EveryRegisterReadsBackItsFieldsAndNothingElse) {
  Bench<TypeParam> bench;
  bench.unlock();
  for (int index = 0x20; index < 0x40; ++index) {
    const std::uint32_t bits = all_of<TypeParam>(index);
    EXPECT_EQ(bench.write(index, ~0u), bits != 0) << index;
    EXPECT_EQ(bench.read(index), bits) << index;
  }
  for (int index = 0x20; index < 0x40; ++index) {
    EXPECT_EQ(bench.read(index), all_of<TypeParam>(index)) << "later writes left it alone";
  }
}

// Each row of the table, the last as well.
TYPED_TEST(ConfigRegistersOf, EveryRowMovesItsWord) {
  Bench<TypeParam> bench;
  bench.unlock();
  bench.boundary = true;
  const auto check = [&]<class Row>(const Row& row) {
    const std::uint32_t all = mask_of(row) >> row.lsb;
    bench.write(row.address / 4, ~0u);
    bench.config();
    auto config = bench.config();
    EXPECT_EQ(std::uint32_t(bits_of(Row::Word::of(config)).raw()), all) << row.group << '.' << row.name;
    bench.write(row.address / 4, 0);
    bench.config();
    config = bench.config();
    EXPECT_EQ(bits_of(Row::Word::of(config)).raw(), 0u) << row.group << '.' << row.name;
  };
  std::apply([&](const auto&... row) { (check(row), ...); }, TypeParam::kWordRows);
}

TEST(ConfigRegisters, AFieldMovesItsOwnWord) {
  Bench<> bench;
  bench.unlock();
  bench.write(kPwm, 0x0702'0123);
  bench.write(kPwmLimits, 0x0055'0044);
  bench.write(index_of("LOOP"), 0x0011'0a1e);
  const SixStepConfig config = bench.config();
  EXPECT_EQ(config.pwm.period, Clocks(0x123));
  EXPECT_EQ(config.pwm.tick_periods, UInt<8>(7));
  EXPECT_FALSE(config.pwm.centred);
  EXPECT_TRUE(config.pwm.complementary);
  EXPECT_EQ(config.pwm.minimum, Clocks(0x44));
  EXPECT_EQ(config.pwm.dead_time, UInt<8>(0x55));
  EXPECT_EQ(config.loop.divide, UInt<2>(3));
  EXPECT_EQ(config.loop.bandwidth, Bandwidth::kPerStep);
  EXPECT_EQ(config.loop.detector, Detector::kOncePerTurn);
  EXPECT_EQ(config.source, Source::kHall);
  EXPECT_EQ(config.speed.shift, UInt<4>(10));
  EXPECT_EQ(config.loop.delay, UInt<10>(0x11));
}

RC_GTEST_PROP(ConfigRegisters, OnlyBytesWithAStrobeChange,
              (std::uint32_t before, std::uint32_t data)) {
  const int strobes = *rc::gen::inRange(0, 16);
  Bench<> bench;
  bench.write(kGain, before);
  RC_ASSERT(bench.write(kGain, data, strobes));
  std::uint32_t mask = 0;
  for (int byte = 0; byte < 4; ++byte) {
    if (strobes >> byte & 1) mask |= 255u << 8 * byte;
  }
  RC_ASSERT(bench.read(kGain) == ((data & mask) | (before & ~mask)));
}

TYPED_TEST(ConfigRegistersOf, HolesAndReadOnlyRegistersRefuse) {
  Bench<TypeParam> bench;
  for (const int index :
       {0x3f, 0x14, 0x40, 0x60, 0x3ff, index_of("ID"), index_of("CLOCK"), index_of("STATUS")}) {
    EXPECT_FALSE(bench.write(index, 1)) << index;
  }
  EXPECT_TRUE(bench.tick({.read = true, .index = 0x60}).hole) << "no alias of PWM";
  EXPECT_TRUE(bench.tick({.read = true, .index = 0x40}).hole) << "nor of ID";
  EXPECT_TRUE(bench.tick({.read = true, .index = 0x3f}).hole);
  EXPECT_FALSE(bench.tick({.read = true, .index = kPwm}).hole);
}

TYPED_TEST(ConfigRegistersOf, WhatShapesTheBridgeIsRefusedWhileRunning) {
  Bench<TypeParam> bench;
  bench.unlock();
  EXPECT_TRUE(bench.write(kPwm, 100));
  bench.stopped = false;
  EXPECT_FALSE(bench.write(kPwm, 200));
  EXPECT_FALSE(bench.write(kPwmLimits, 200));
  EXPECT_EQ(bridge(bench.config()).period, Clocks(100));
  EXPECT_EQ(bridge(bench.config()).minimum, Clocks(0));
  EXPECT_EQ(bench.write(kGain, 3), (std::is_same_v<TypeParam, SixStep>)) << "whose gains may be tuned";
}

TYPED_TEST(ConfigRegistersOf, LimitsAreRefusedBehindTheLock) {
  Bench<TypeParam> bench;
  EXPECT_FALSE(bench.write(kPwmLimits, 7));
  bench.unlock();
  EXPECT_TRUE(bench.write(kPwmLimits, 7));
  bench.write(index_of("LOCK"), kLockKey + 1);
  EXPECT_FALSE(bench.write(kPwmLimits, 8));
  bench.write(index_of("LOCK"), kLockKey, 1);
  EXPECT_FALSE(bench.write(kPwmLimits, 8)) << "half a key is none";
  EXPECT_EQ(bridge(bench.config()).minimum, Clocks(7));
}

TYPED_TEST(ConfigRegistersOf, TheSetPointActsFromTheNextPeriodOn) {
  Bench<TypeParam> bench;
  bench.stopped = false;
  EXPECT_TRUE(bench.write(kTarget, 12345));
  EXPECT_EQ(bench.read(kTarget), 12345u);
  EXPECT_EQ(bench.config().speed.target, 0);
  bench.boundary = true;
  bench.config();
  EXPECT_EQ(bench.config().speed.target, 12345);
}

}  // namespace
}  // namespace steplock
