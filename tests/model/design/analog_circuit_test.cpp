// The values of the analog circuit: what they are for, held against every drive of drives/.
#include "model/design/analog_circuit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock::design {
namespace {

TEST(Circuit, ValuesAreThoseOfTheSeries) {
  EXPECT_DOUBLE_EQ(preferred_at_least(101e3, 24), 110e3);
  EXPECT_DOUBLE_EQ(preferred_at_least(110e3, 24), 110e3);
  EXPECT_DOUBLE_EQ(preferred_at_least(9.2, 24), 10);
  EXPECT_NEAR(preferred_at_most(5.5e-11, 6), 4.7e-11, 1e-20);
  EXPECT_NEAR(preferred_at_most(1e-3, 12), 1e-3, 1e-12);
  EXPECT_NEAR(preferred_at_most(0.99e-3, 12), 0.82e-3, 1e-12);
  EXPECT_DOUBLE_EQ(preferred_nearest(32.2e3, 96), 32.4e3);
  EXPECT_DOUBLE_EQ(preferred_nearest(31.9e3, 96), 31.6e3);
}

TEST(Circuit, EveryDriveGetsOneThatKeepsItsPromises) {
  int drives = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DRIVES)) {
    if (entry.path().extension() != ".toml") continue;
    const Settings s = load_drive_file(entry.path().string()).settings;
    if (s.drive.kind == DriveKind::kSinusoidal) continue;
    SCOPED_TRACE(entry.path().filename().string());
    ++drives;
    const Circuit c = circuit_of(s);
    EXPECT_LE(c.largest_input, 2.5 * (1 + 1e-9));
    EXPECT_GT(c.largest_input, 2.5 / 1.16) << "E24 steps are 16 % apart at most: the range is used";
    // A chop edge, seen through the filter at the end of the blanking.
    EXPECT_LE(s.inverter.bus_v * std::exp(-s.control.blanking_s / c.tau),
              s.sensors.comparator_hysteresis_v * (1 + 1e-9));
    EXPECT_LE(c.lag_deg, 1);
    EXPECT_LE(c.r_shunt * s.sensors.limit_a, 0.1 * (1 + 1e-9));
    // E96 steps are 2.4 % apart, so the nearest is 1.3 % off at most, with the rounding of its
    // values.
    EXPECT_NEAR(c.limit, s.sensors.limit_a, 0.013 * s.sensors.limit_a);
    EXPECT_LE(5 * c.r_edge * c.c_edge, s.control.limit_blanking_s * (1 + 1e-9));
    EXPECT_NE(circuit_text(s, c).find("| shunt, bridge to ground |"), std::string::npos);
  }
  EXPECT_GE(drives, 8);
}

// Divider and star have the same ratio, which the crossing needs: both computed from the same six
// resistors.
TEST(Circuit, StarOfThreeEqualDividersHasTheirRatio) {
  const Settings s = load_drive_file(DRIVES "/m2310p_servo.toml").settings;
  const Circuit c = circuit_of(s);
  const double u = 7, v = 19, w = 1;  // V
  const double star = (u + v + w) / c.r_high / (3 / c.r_high + 3 / c.r_low);
  EXPECT_NEAR(star, c.ratio * (u + v + w) / 3, 1e-12);
}

}  // namespace
}  // namespace steplock::design
