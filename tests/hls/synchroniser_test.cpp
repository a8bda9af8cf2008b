#include "hls/bridge/synchroniser.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace steplock {
namespace {

std::array<bool, 8> bits(const Synchroniser::Pins& pins) {
  return {pins.comparator_u, pins.comparator_v, pins.comparator_w, pins.limit,
          pins.fault,        pins.hall_u,       pins.hall_v,       pins.hall_w};
}

Synchroniser::Pins pins(unsigned value) {
  const auto bit = [&](int i) { return (value >> i & 1) != 0; };
  return {bit(0), bit(1), bit(2), bit(3), bit(4), bit(5), bit(6), bit(7)};
}

TEST(Synchroniser, StartsWithAllPinsLow) {
  Synchroniser dut;
  for (int i = 0; i < 2; ++i) EXPECT_EQ(bits(dut.tick(pins(255))), bits(pins(0)));
}

// Each pin comes out two clocks later, and no pin as another.
RC_GTEST_PROP(Synchroniser, ShowsEveryPinTwoClocksLater, (std::uint32_t seed)) {
  std::mt19937 random(seed);
  std::vector<unsigned> sent = {0, 0};
  Synchroniser dut;
  for (int clock = 0; clock < 100; ++clock) {
    sent.push_back(random() & 255);
    RC_ASSERT(bits(dut.tick(pins(sent.back()))) == bits(pins(sent[clock])));
  }
}

}  // namespace
}  // namespace steplock
