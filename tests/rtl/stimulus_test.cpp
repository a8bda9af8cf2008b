#include "testbench/stimulus.hpp"

#include <gtest/gtest.h>

#include <set>

namespace steplock {
namespace {

TEST(Stimulus, SameSeedSameNumbers) {
  Stimulus a(7), b(7), c(8);
  bool other = false;
  for (int i = 0; i < 10'000; ++i) {
    a.next();
    b.next();
    c.next();
    const auto number = a.bits(33);
    ASSERT_TRUE(number == b.bits(33));
    other = other || number != c.bits(33);
  }
  EXPECT_TRUE(other);
}

TEST(Stimulus, StaysWithinTheWidth) {
  Stimulus any(1);
  for (int width = 1; width < 128; ++width) {
    for (int i = 0; i < 200; ++i) {
      any.next();
      ASSERT_TRUE(any.bits(width) >> width == 0) << width;
    }
  }
}

TEST(Stimulus, VisitsEveryCorner) {
  Stimulus any(1);
  std::set<std::uint64_t> seen;
  for (int i = 0; i < 100'000; ++i) {
    any.next();
    seen.insert(static_cast<std::uint64_t>(any.bits(20)));
  }
  for (const std::uint64_t corner : {0x0u, 0x1u, 0xFFFFFu, 0x80000u, 0x7FFFFu, 0x400u}) {
    EXPECT_TRUE(seen.contains(corner)) << corner;
  }
}

// Some counter of the drive takes a thousand clocks to run out, with everything else standing still.
TEST(Stimulus, HoldsAnInputForAThousandClocksNowAndThen) {
  Stimulus any(1);
  int longest = 0, held = 0;
  Stimulus::Number last = 0;
  for (int i = 0; i < 400'000; ++i) {
    any.next();
    const auto number = any.bits(30);
    held = number == last ? held + 1 : 0;
    longest = std::max(longest, held);
    last = number;
  }
  EXPECT_GT(longest, 1000);
}

}  // namespace
}  // namespace steplock
