// The whole drive through SPI: random frames, some of them cut, against a model of the map made of the table; and
// the C driver over it, which turns the bridge on and off and clears a fault.
#include "hls/bus/six_step_spi.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "rtl/host/steplock_spi.h"
#include "tests/hls/map_model.hpp"
#include "tests/hls/spi_host.hpp"

namespace steplock {
namespace {

struct Bench {
  bool operator()(const Spi::Pins& pins) {
    in.spi = pins;
    out = top.tick(in);
    return out.spi.miso;
  }
  bool gates_move(int clocks) {
    bool moved = false;
    for (int i = 0; i < clocks; ++i) {
      (*this)({});
      const Gates& g = out.gates;
      moved = moved || g.uh || g.ul || g.vh || g.vl || g.wh || g.wl;
    }
    return moved;
  }

  SixStepSpi top;
  SixStepSpi::In in;
  SixStepSpi::Out out;
};

// `lie`: the answer that is told wrong, so that the caller sees the test fail.
void random_frames(int frames, std::uint64_t seed, int lie = -1) {
  std::mt19937_64 random(seed);
  const auto chance = [&](int percent) { return int(random() % 100) < percent; };
  Bench b;
  MapModel<> model;
  b({});
  int errors = 0;
  for (int i = 0; i < frames; ++i) {
    const int address = chance(10) ? int(random() % 4096) : chance(20) ? kLock : int(random() % 64) * 4;
    const int home = address & ~3;
    const double half = 4 + 0.01 * double(random() % 300);
    std::uint32_t data = chance(30) ? kLockKey : std::uint32_t(random());
    // Run stays low and no watchdog bites: this is the traffic of an idle drive.
    if (home == kControl) data &= ~2U;
    const bool write = chance(50) && home != address_of(index_of("WATCHDOG"));
    if (chance(20)) {
      spi_frame(b, half, address | (write ? 0x8000 : 0), data, int(random() % 48));
      continue;
    }
    SpiAnswer answer = write ? spi_write(b, half, address, data) : spi_read(b, half, address);
    if (i >= lie && lie >= 0) answer.status ^= 4, lie = -1;
    if (write) {
      const bool okay = model.write(home, data, ~0U);
      ASSERT_EQ(answer.status, okay ? 0x5a : 0x5e) << "frame " << i << " to " << address;
    } else {
      const auto word = model.read(home);
      ASSERT_EQ(answer.status, word ? 0x5a : 0x5e) << "frame " << i << " from " << address;
      ASSERT_EQ(answer.data, word.value_or(0)) << "frame " << i << " from " << address;
    }
    errors += answer.status == 0x5e;
  }
  EXPECT_GT(errors, frames / 20);
}

TEST(SixStepSpi, RandomFramesGetTheAnswersOfTheTableAndCutOnesWriteNothing) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) random_frames(1500, seed);
}

TEST(SixStepSpi, AWrongAnswerIsNoticed) {
  testing::TestPartResultArray results;
  {
    testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    random_frames(200, 1, 100);
  }
  EXPECT_GT(results.size(), 0);
}

// Bytes to bits, as a processor's SPI port does.
int transfer(void* bench, const std::uint8_t* out, std::uint8_t* in, std::size_t bytes) {
  std::uint64_t frame = 0;
  for (std::size_t i = 0; i < bytes; ++i) frame = frame << 8 | out[i];
  const auto back = spi_frame(*static_cast<Bench*>(bench), 4.2, int(frame >> 40),
                              std::uint32_t(frame >> 8));
  for (std::size_t i = 0; i < bytes; ++i) in[i] = std::uint8_t(back >> (8 * (bytes - 1 - i)));
  return 0;
}

TEST(SixStepSpi, TheCDriverTurnsTheBridgeOnAndOffAndClearsAFaultOverIt) {
  Bench b;
  b({});
  steplock_spi spi = {transfer, &b};
  const steplock_bus bus = steplock_over_spi(&spi);
  // A reset pattern that lasts, half of the time on.
  const std::array<steplock_word, 5> words = {{{address_of(index_of("PWM")), 1u << 24 | 200},
                                               {address_of(index_of("START_RESET")), 4095u << 16},
                                               {address_of(index_of("START_DUTY")), 0x4000},
                                               {address_of(index_of("SPEED_DUTY")), 0x8000u << 16},
                                               {address_of(index_of("SPEED_DUTY_SLEW")), 0xfff}}};
  ASSERT_EQ(steplock_init(&bus, words.data(), words.size()), STEPLOCK_OK);
  EXPECT_FALSE(b.gates_move(2000));
  ASSERT_EQ(steplock_start(&bus, 0), STEPLOCK_OK);
  EXPECT_TRUE(b.gates_move(2000));
  EXPECT_EQ(steplock_init(&bus, words.data(), words.size()), STEPLOCK_NOT_STOPPED);
  EXPECT_EQ(bus.write(bus.context, address_of(index_of("PWM")), 1000), 1) << "refused while it runs";

  b.in.pins.fault = true;
  b.gates_move(3);
  EXPECT_FALSE(b.gates_move(1000));
  EXPECT_EQ(steplock_clear_fault(&bus), STEPLOCK_FAULT_LATCHED) << "the pin is still up";
  b.in.pins.fault = false;
  b.gates_move(5);
  EXPECT_TRUE(b.out.fault);
  EXPECT_EQ(steplock_clear_fault(&bus), STEPLOCK_OK);
  EXPECT_FALSE(b.out.fault);
  std::uint32_t value = 0;
  EXPECT_EQ(bus.read(bus.context, 0x800, &value), 1) << "a hole";
}

}  // namespace
}  // namespace steplock
