// Faults of the comparator pins, clock by clock; and in closed loop, where no engine may miss one.
#include "testbench/run/pin_faults.hpp"

#include <gtest/gtest.h>

namespace steplock {
namespace {

plant::Pins pins(bool u, bool v, bool w) { return {.comparator = {u, v, w}}; }

TEST(PinFaults, HeldKeepsTheLevelOfItsBeginning) {
  PinFaults faults;
  faults.add({.kind = PinFault::Kind::kHeld, .comparator = 1, .from = 10, .clocks = 5});
  EXPECT_EQ(faults.seen(9, pins(0, 0, 1)), pins(0, 0, 1));
  EXPECT_EQ(faults.next(9), 10u);
  EXPECT_EQ(faults.seen(10, pins(0, 1, 1)), pins(0, 1, 1));
  EXPECT_EQ(faults.next(10), 15u);
  EXPECT_EQ(faults.seen(12, pins(1, 0, 0)), pins(1, 1, 0));
  EXPECT_EQ(faults.seen(15, pins(1, 0, 0)), pins(1, 0, 0));
  EXPECT_EQ(faults.next(15), PinFaults::kNever);
}

TEST(PinFaults, WaitsForACommutationThenTakesThePhaseThatFloats) {
  PinFaults faults;
  faults.add({.kind = PinFault::Kind::kInverted, .from = 100, .at_commutation = true, .delay = 7, .clocks = 3});
  faults.commutated(90, 3);  // too early
  EXPECT_EQ(faults.seen(99, pins(0, 0, 0)), pins(0, 0, 0));
  EXPECT_EQ(faults.next(99), PinFaults::kNever);
  faults.commutated(120, 4);  // v floats in step 4
  EXPECT_EQ(faults.next(120), 127u);
  EXPECT_EQ(faults.seen(127, pins(0, 0, 0)), pins(0, 1, 0));
  EXPECT_EQ(faults.seen(129, pins(1, 1, 1)), pins(1, 0, 1));
  faults.commutated(130, 5);
  EXPECT_EQ(faults.seen(130, pins(1, 1, 1)), pins(1, 1, 1));
}

TEST(PinFaults, EndsWithItsLastStep) {
  PinFaults faults;
  faults.add({.kind = PinFault::Kind::kHigh, .comparator = 0, .from = 10, .steps = 2});
  EXPECT_EQ(faults.seen(10, pins(0, 0, 0)), pins(1, 0, 0));
  faults.commutated(20, 1);
  EXPECT_EQ(faults.seen(20, pins(0, 0, 0)), pins(1, 0, 0));
  faults.commutated(31, 2);
  EXPECT_EQ(faults.seen(31, pins(0, 0, 0)), pins(0, 0, 0));
}

TEST(PinFaults, LowForGoodStaysLow) {
  PinFaults faults;
  faults.add({.kind = PinFault::Kind::kLow, .comparator = 2, .from = 1});
  EXPECT_EQ(faults.seen(5, pins(1, 1, 1)), pins(1, 1, 0));
  EXPECT_EQ(faults.seen(1'000'000'000'000, pins(1, 1, 1)), pins(1, 1, 0));
}

}  // namespace
}  // namespace steplock
