// Requests without a bus; the map itself is tested through each bus (six_step_axi_test and its like).
#include "hls/bus/six_step_registered.hpp"

#include <gtest/gtest.h>

#include "tests/hls/map_model.hpp"

namespace steplock {
namespace {

BusRequest reading(int address) { return {.read = true, .index = WordIndex::of(address / 4)}; }
BusRequest writing(int address, std::uint32_t data) {
  return {.write = true, .index = WordIndex::of(address / 4), .data = data, .strobes = 15};
}

TEST(SixStepRegistered, AnAnswerComesInTheNextClockAndStaysUntilTheNextRequestOfItsKind) {
  SixStepRegistered dut;
  dut.tick({.pins = {}, .request = reading(0)});
  for (int clock = 0; clock < 5; ++clock) {
    const auto out = dut.tick({.pins = {}, .request = writing(0, 1)});
    EXPECT_EQ(out.data, UInt<32>(kMapId)) << "a write changes nothing of a read's answer";
    EXPECT_FALSE(out.read_error);
    EXPECT_EQ(out.write_error, clock > 0) << "the ID is read-only";
  }
  dut.tick({.pins = {}, .request = reading(0xffc)});
  const auto out = dut.tick({});
  EXPECT_TRUE(out.read_error) << "a hole";
  EXPECT_EQ(out.data, UInt<32>(0));
  EXPECT_TRUE(out.write_error) << "of the write before";
}

TEST(SixStepRegistered, WhatWasWrittenIsReadBackInTheClockAfter) {
  SixStepRegistered dut;
  dut.tick({.pins = {}, .request = writing(kPwm, 0x01000190)});
  dut.tick({.pins = {}, .request = reading(kPwm)});
  EXPECT_EQ(dut.tick({}).data, UInt<32>(0x01000190));
}

}  // namespace
}  // namespace steplock
