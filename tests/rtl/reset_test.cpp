// Blocks with a memory, which no reset clears: after a reset in the middle, whatever the bus was doing, the RTL is
// the class as it begins.
#include <gtest/gtest.h>

#include <cstdint>

#include "Vdrive_registers.h"
#include "Vconfig_registers.h"
#include "hls/bus/drive_registers.hpp"
#include "hls/bus/six_step_registers.hpp"
#include "hls/bus/config_registers.hpp"
#include "ports/drive_registers_ports.hpp"
#include "ports/config_registers_ports.hpp"
#include "testbench/lockstep.hpp"
#include "testbench/stimulus.hpp"

namespace steplock {
namespace {

struct WordPorts {
  using Block = ConfigRegisters<>;
  using Rtl = Vconfig_registers;
  static void randomise(Block::In& in, Stimulus& any) { ports::config_registers::randomise(in, any); }
  static void drive(Rtl& rtl, const Block::In& in) { ports::config_registers::drive_ports(rtl, in); }
  static const char* differs(const Rtl& rtl, const Block::Out& out) {
    return ports::config_registers::differs(rtl, out);
  }
};
struct DrivePorts {
  using Block = DriveRegisters<>;
  using Rtl = Vdrive_registers;
  static void randomise(Block::In& in, Stimulus& any) { ports::drive_registers::randomise(in, any); }
  static void drive(Rtl& rtl, const Block::In& in) { ports::drive_registers::drive_ports(rtl, in); }
  static const char* differs(const Rtl& rtl, const Block::Out& out) {
    return ports::drive_registers::differs(rtl, out);
  }
};

// The first clock that differs, or `clocks`.  `renew` false: the class is not told of the resets.
template <class Ports>
int agree_over_resets(int clocks, bool renew = true) {
  Lockstep<typename Ports::Rtl> rtl;
  typename Ports::Block cpp;
  Stimulus any(3);
  for (int clock = 0; clock < clocks; ++clock) {
    any.next();
    typename Ports::Block::In in;
    Ports::randomise(in, any);
    in.request.index = in.request.index & WordIndex(63);  // holes beyond the map are for rtl_test.cpp
    if (any.bit(0.5)) in.request.write = false;
    if (in.request.write) in.request.read = false;  // as bus.hpp has it
    Ports::drive(rtl.ports(), in);
    const bool reset = any.bit(0.002);
    rtl.ports().rst = reset;
    rtl.settle();
    const auto out = cpp.tick(in);
    if (Ports::differs(rtl.ports(), out) != nullptr) return clock;
    rtl.edge();
    if (reset && renew) cpp = {};
  }
  return clocks;
}

TEST(ResetInTheMiddle, IsOneForTheWords) {
  EXPECT_EQ(agree_over_resets<WordPorts>(300'000), 300'000);
}
TEST(ResetInTheMiddle, IsOneForTheSnapshot) {
  EXPECT_EQ(agree_over_resets<DrivePorts>(300'000), 300'000);
}
TEST(ResetInTheMiddle, IsNoticedWhenTheClassIsNotTold) {
  EXPECT_LT(agree_over_resets<WordPorts>(300'000, false), 5'000);
  EXPECT_LT(agree_over_resets<DrivePorts>(300'000, false), 5'000);
}

}  // namespace
}  // namespace steplock
