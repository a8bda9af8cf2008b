// One block, generated, against its C++: every output of every clock.  The list in CMakeLists.txt says
// which (BLOCK, MODULE and the headers come from there).
#include BLOCK_HEADER
#include PORTS_HEADER
#include VERILATED_HEADER

#include "testbench/lockstep.hpp"
#include "testbench/stimulus.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace steplock {
namespace {

// The clock at which the two first differ, or `clocks`; `sabotage` turns one output bit of the block.
template <class Block>
std::uint64_t agree(std::uint64_t clocks, std::uint64_t seed, bool sabotage = false) {
  Lockstep<VERILATED> rtl;
  Block cpp;
  typename Block::In in;
  Stimulus any(seed);
  for (std::uint64_t clock = 0; clock < clocks; ++clock) {
    any.next();
    ports::MODULE::randomise(in, any);
    ports::MODULE::drive_ports(rtl.ports(), in);
    rtl.settle();
    auto out = cpp.tick(in);
    if (sabotage && clock == clocks / 2) reinterpret_cast<unsigned char&>(out) ^= 1;
    if (const char* port = ports::MODULE::differs(rtl.ports(), out)) {
      if (!sabotage) ADD_FAILURE() << port << " differs in clock " << clock << ", seed " << seed;
      return clock;
    }
    rtl.edge();
  }
  return clocks;
}

using Block = BLOCK;

TEST(RTL_SUITE, EqualsItsCppForAMillionClocks) {
  constexpr std::uint64_t clocks = 250'000;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) ASSERT_EQ(agree<Block>(clocks, seed), clocks);
}

TEST(RTL_SUITE, OneWrongBitInOneClockIsNoticed) {
  EXPECT_EQ(agree<Block>(1000, 1, true), 500u);
}

}  // namespace
}  // namespace steplock
