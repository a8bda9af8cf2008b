#include "hls/six_step/telemetry.hpp"

#include <gtest/gtest.h>

namespace steplock {
namespace {

TEST(Telemetry, EachEventMovesItsOwnCounter) {
  Telemetry dut;
  for (int i = 0; i < 60; ++i) {
    dut.tick({.crossing = true,
              .missed = i % 2 == 0,
              .freewheel_long = i % 3 == 0,
              .limit_hit = i % 4 == 0,
              .retry = i % 5 == 0});
  }
  const auto out = dut.tick({});
  EXPECT_EQ(out.crossings, Telemetry::Count(60));
  EXPECT_EQ(out.missed, Telemetry::Count(30));
  EXPECT_EQ(out.freewheel_long, Telemetry::Count(20));
  EXPECT_EQ(out.limit_hits, Telemetry::Count(15));
  EXPECT_EQ(out.retries, Telemetry::Count(12));
}

TEST(Telemetry, StopsAtTheTopInsteadOfWrapping) {
  Telemetry dut;
  for (int i = 0; i < 65535; ++i) dut.tick({.crossing = true});
  EXPECT_EQ(dut.tick({.crossing = true}).crossings, Telemetry::Count(65535));
  EXPECT_EQ(dut.tick({}).crossings, Telemetry::Count(65535));
}

TEST(Telemetry, ClearWinsOverAnEvent) {
  Telemetry dut;
  dut.tick({.crossing = true, .retry = true});
  dut.tick({.clear = true, .crossing = true});
  const auto out = dut.tick({});
  EXPECT_EQ(out.crossings, Telemetry::Count(0));
  EXPECT_EQ(out.retries, Telemetry::Count(0));
}

TEST(Telemetry, LeftOutItCountsNothing) {
  Telemetry dut;
  for (int i = 0; i < 10; ++i) dut.tick({.counts = false, .crossing = true, .missed = true, .limit_hit = true});
  EXPECT_EQ(dut.tick({.counts = false}), Telemetry::Out{});
  EXPECT_EQ(dut, Telemetry{});
}

}  // namespace
}  // namespace steplock
