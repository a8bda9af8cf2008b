// One block, generated, against its C++: every output of every clock.  The list in CMakeLists.txt says
// which (BLOCK, MODULE and the headers come from there), and which parameters are 0 (LEFT_OUT).
#include BLOCK_HEADER
#include PORTS_HEADER
#include VERILATED_HEADER

#include "testbench/lockstep.hpp"
#include "testbench/stimulus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace steplock {
namespace {

// Clocks of a sample; 1 for a block that takes one in every clock.
template <class Block>
constexpr int clocks_of_a_sample() {
  if constexpr (requires { Block::kClocks; }) {
    return Block::kClocks;
  } else {
    return 1;
  }
}

// Draws the inputs of a clock.  Under a schedule they stand still from the start to
// done, and starts that will be ignored come at random.
template <class Block>
class Drawn {
 public:
  explicit Drawn(std::uint64_t seed, [[maybe_unused]] bool leaves_out) : any_(seed) {
#ifdef LEFT_OUT
    typename Block::In& in = in_;
    if (leaves_out) LEFT_OUT;
#endif
  }

  const typename Block::In& next() {
    if constexpr (clocks_of_a_sample<Block>() > 1) {
      if (left_ > 0) {
        --left_;
        in_.start = any_.bit(0.5);
        return in_;
      }
    }
    any_.next();
    ports::MODULE::randomise(in_, any_);
    if constexpr (clocks_of_a_sample<Block>() > 1) {
      if (in_.start) left_ = Block::kClocks - 1;
    }
    return in_;
  }

 private:
  Stimulus any_;
  typename Block::In in_;
  int left_ = 0;  // clocks until done
};

// The clock at which the two first differ, or `clocks`; `sabotage` turns one output bit of the block.
template <class Block>
std::uint64_t agree(std::uint64_t clocks, std::uint64_t seed, bool sabotage = false,
                    std::uint64_t* samples = nullptr, bool leaves_out = true) {
  Lockstep<VERILATED> rtl;
  Block cpp;
  Drawn<Block> inputs(seed, leaves_out);
  for (std::uint64_t clock = 0; clock < clocks; ++clock) {
    const auto& in = inputs.next();
    ports::MODULE::drive_ports(rtl.ports(), in);
    rtl.settle();
    auto out = cpp.tick(in);
    if constexpr (clocks_of_a_sample<Block>() > 1) {
      if (samples != nullptr && out.done) ++*samples;
    }
    if (sabotage && clock == clocks / 2) reinterpret_cast<unsigned char&>(out) ^= 1;
    if (const char* port = ports::MODULE::differs(rtl.ports(), out)) {
      if (!sabotage && leaves_out) ADD_FAILURE() << port << " differs in clock " << clock << ", seed " << seed;
      return clock;
    }
    rtl.edge();
  }
  return clocks;
}

using Block = BLOCK;

// A schedule gets enough of them for 100,000 samples, if it is started half of the time or more.
TEST(RTL_SUITE, EqualsItsCppForAMillionClocks) {
  constexpr std::uint64_t clocks = std::max(250'000, 50'000 * clocks_of_a_sample<Block>());
  std::uint64_t samples = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    ASSERT_EQ(agree<Block>(clocks, seed, false, &samples), clocks);
  }
  if (clocks_of_a_sample<Block>() > 1) {
    EXPECT_GE(samples, 100'000U);
  }
}

TEST(RTL_SUITE, OneWrongBitInOneClockIsNoticed) {
  EXPECT_EQ(agree<Block>(1000, 1, true), 500u);
}

#ifdef LEFT_OUT
TEST(RTL_SUITE, WhatIsLeftOutOfOneOfThemIsNoticed) {
  EXPECT_LT(agree<Block>(100'000, 1, false, nullptr, false), 100'000u);
}
#endif

}  // namespace
}  // namespace steplock
