// Motors that no file knows: the same for the same seed, over decades, and accepted by the design library or refused by a key.
#include "testbench/drive_file/drawn_motor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "model/design/design.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock {
namespace {

design::Settings drawn(std::uint64_t seed, std::uint64_t index) {
  const auto path = std::filesystem::temp_directory_path() / ("steplock_" + drawn_motor_name(index) + ".toml");
  std::ofstream(path) << drawn_motor_file(seed, index);
  return load_drive_file(path.string()).settings;
}

TEST(DrawnMotor, IsTheSameForTheSameSeedAndAnotherOneElse) {
  EXPECT_EQ(drawn_motor_file(3, 7), drawn_motor_file(3, 7));
  EXPECT_NE(drawn_motor_file(3, 7), drawn_motor_file(3, 8));
  EXPECT_NE(drawn_motor_file(3, 7), drawn_motor_file(4, 7));
}

TEST(DrawnMotor, TheySpanDecades) {
  std::vector<double> speeds, currents, inertias;
  for (std::uint64_t k = 0; k < 100; ++k) {
    const auto s = drawn(1, k);
    speeds.push_back(s.scenario.speed_rpm);
    currents.push_back(s.motor.rated_current_a);
    inertias.push_back(s.motor.inertia_kgm2);
  }
  const auto span = [](const std::vector<double>& x) {
    return *std::max_element(x.begin(), x.end()) / *std::min_element(x.begin(), x.end());
  };
  EXPECT_GT(span(speeds), 100);
  EXPECT_GT(span(currents), 30);
  EXPECT_GT(span(inertias), 1e4);
}

// What each of them says follows from the other values: the bus is enough for the set speed at the rated current.
TEST(DrawnMotor, TheBusIsEnoughForTheSetSpeed) {
  for (std::uint64_t k = 0; k < 100; ++k) {
    const auto s = drawn(1, k);
    const double emf = std::sqrt(3.0) * s.motor.flux_vs * s.motor.pole_pairs * s.scenario.speed_rpm * M_PI / 30;
    EXPECT_LT(emf + 2 * s.motor.resistance_ohm * s.motor.rated_current_a, s.inverter.bus_v) << k;
    EXPECT_GT(s.sensors.limit_a, s.motor.rated_current_a) << k;
  }
}

// Comparators see their terminals through dividers that are made for the bus, so their hysteresis grows with it as their offsets
// and noise do.
TEST(DrawnMotor, HysteresisFollowsTheBus) {
  for (std::uint64_t k = 0; k < 100; ++k) {
    const auto s = drawn(1, k);
    EXPECT_DOUBLE_EQ(s.sensors.comparator_hysteresis_v, s.sensors.comparator_offset_v[0]) << k;
    EXPECT_NEAR(s.sensors.comparator_hysteresis_v / s.inverter.bus_v, 4e-4, 5e-4 * 4e-4) << k;  // a file has four digits
  }
}

}  // namespace
}  // namespace steplock
