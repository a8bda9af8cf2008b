#include "model/plant/circuit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace steplock::plant {
namespace {

const Bridge kBridge = {.on_resistance = 0.01, .diode_drop = 0.55, .diode_resistance = 0.005};
constexpr double kBus = 24;

Circuit resolve(const Gates& gates, const Phases& current, const Phases& emf) {
  return Circuit::resolve(kBridge, gates, current, emf, kBus);
}

TEST(Circuit, ASwitchDropsItsResistanceInEitherDirection) {
  const Gates gates = {.uh = true, .vl = true, .wl = true};
  const auto t = resolve(gates, {2, -3, 1}, {}).terminals({2, -3, 1}, {}, kBus);
  EXPECT_DOUBLE_EQ(t.voltage[0], kBus - 0.02);
  EXPECT_DOUBLE_EQ(t.voltage[1], 0.03);
  EXPECT_DOUBLE_EQ(t.voltage[2], -0.01);
}

TEST(Circuit, BothSwitchesOfALegHoldItAtHalfTheBusThroughHalfTheirResistance) {
  const Gates gates = {.uh = true, .ul = true, .vl = true};
  const auto circuit = resolve(gates, {2, -2, 0}, {});
  EXPECT_EQ(circuit.mode[0], LegMode::kBoth);
  const auto t = circuit.terminals({2, -2, 0}, {}, kBus);
  EXPECT_DOUBLE_EQ(t.voltage[0], kBus / 2 - 0.01);
  EXPECT_DOUBLE_EQ(t.voltage[1], 0.02);
}

TEST(Circuit, CurrentWithoutASwitchTakesTheDiodeOfItsDirection) {
  const auto circuit = resolve({.vl = true}, {2, -1, -1}, {});
  EXPECT_EQ(circuit.mode[0], LegMode::kLowDiode);
  EXPECT_EQ(circuit.mode[2], LegMode::kHighDiode);
  const auto t = circuit.terminals({2, -1, -1}, {}, kBus);
  EXPECT_DOUBLE_EQ(t.voltage[0], -0.55 - 0.01);
  EXPECT_DOUBLE_EQ(t.voltage[2], kBus + 0.55 + 0.005);
}

TEST(Circuit, OneFloatingTerminalStandsAtStarPointPlusItsBemf) {
  const Phases i = {1, -1, 0}, e = {5, -5, 2};
  const auto circuit = resolve({.uh = true, .vl = true}, i, e);
  EXPECT_EQ(circuit.mode[2], LegMode::kFloating);
  const auto t = circuit.terminals(i, e, kBus);
  EXPECT_DOUBLE_EQ(t.neutral, kBus / 2);
  EXPECT_DOUBLE_EQ(t.voltage[2], kBus / 2 + 2);
}

TEST(Circuit, TwoFloatingTerminalsHangOnTheThird) {
  const Phases e = {5, -5, 2};
  const auto circuit = resolve({.vl = true}, {}, e);
  const auto t = circuit.terminals({}, e, kBus);
  EXPECT_DOUBLE_EQ(t.neutral, 5);
  EXPECT_DOUBLE_EQ(t.voltage[0], 10);
  EXPECT_DOUBLE_EQ(t.voltage[1], 0);
  EXPECT_DOUBLE_EQ(t.voltage[2], 7);
}

TEST(Circuit, AFloatingTerminalThatWouldLeaveTheRailsClamps) {
  EXPECT_EQ(resolve({.vl = true}, {}, {-2, 1, 0}).mode[0], LegMode::kLowDiode);
  EXPECT_EQ(resolve({.vh = true}, {}, {2, 1, 0}).mode[0], LegMode::kHighDiode);
  EXPECT_EQ(resolve({.vh = true}, {}, {1.5, 1, 0}).mode[0], LegMode::kFloating);  // within a drop
}

TEST(Circuit, CoastingTerminalsCentreOnGroundUntilTheLowestClamps) {
  const auto small = resolve({}, {}, {0.2, -0.3, 0.1}).terminals({}, {0.2, -0.3, 0.1}, kBus);
  EXPECT_NEAR(small.neutral, 0, 1e-15);
  const auto large = resolve({}, {}, {2, -5, 3}).terminals({}, {2, -5, 3}, kBus);
  EXPECT_DOUBLE_EQ(large.voltage[1], -0.55);
  EXPECT_DOUBLE_EQ(large.neutral, 5 - 0.55);
}

TEST(Circuit, CoastingFasterThanTheBusRectifiesIntoIt) {
  const auto circuit = resolve({}, {}, {13, -13, 4});
  EXPECT_EQ(circuit.mode[0], LegMode::kHighDiode);
  EXPECT_EQ(circuit.mode[1], LegMode::kLowDiode);
  EXPECT_EQ(circuit.mode[2], LegMode::kFloating);
}

TEST(Circuit, TheShuntSeesTheReturnCurrentButNotALoopThroughTwoLowSides) {
  const Phases i = {3, -3, 0};
  EXPECT_DOUBLE_EQ(resolve({.uh = true, .vl = true}, i, {}).bus_current(i), 3);
  EXPECT_DOUBLE_EQ(resolve({.ul = true, .vl = true}, i, {}).bus_current(i), 0);
  EXPECT_DOUBLE_EQ(resolve({.vl = true}, i, {}).bus_current(i), 0);  // low diode and low switch
  EXPECT_DOUBLE_EQ(resolve({}, i, {}).bus_current(i), -3);           // back into the bus
}

// With ideal conditions at the terminals known, what must hold is stated without reference to how
// the conduction was found: no floating terminal beyond a clamp, no diode that pulls its current
// the wrong way, and Kirchhoff at the star point.
RC_GTEST_PROP(Circuit, EveryStateOfRestIsConsistent, ()) {
  const auto volt = [] { return *rc::gen::inRange(-30000, 30001) * 1e-3; };
  const Phases e = {volt(), volt(), volt()};
  const auto bits = *rc::gen::inRange(0, 64);
  const bool both = (bits & 3) == 3 || (bits & 12) == 12 || (bits & 48) == 48;
  RC_PRE(!both);
  const Gates gates = {bool(bits & 1), bool(bits & 2),  bool(bits & 4),
                       bool(bits & 8), bool(bits & 16), bool(bits & 32)};
  const auto circuit = resolve(gates, {}, e);
  const auto t = circuit.terminals({}, e, kBus);
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double drive = t.voltage[k] - e[k] - t.neutral;
    sum += circuit.on[k] * drive;
    switch (circuit.mode[k]) {
      case LegMode::kFloating:
        RC_ASSERT(t.voltage[k] >= -kBridge.diode_drop - 1e-12);
        RC_ASSERT(t.voltage[k] <= kBus + kBridge.diode_drop + 1e-12);
        break;
      case LegMode::kLowDiode:
        RC_ASSERT(drive > 0);
        break;
      case LegMode::kHighDiode:
        RC_ASSERT(drive < 0);
        break;
      default:
        break;
    }
  }
  RC_ASSERT(std::abs(sum) < 1e-12 || circuit.inverse_count == 0);
}

}  // namespace
}  // namespace steplock::plant
