// Motors over all decades: each gets a drive by defaults alone.
#include "testbench/drive_file/decades_motor.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include "model/design/design.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock {
namespace {

design::Settings drawn(std::uint64_t seed, std::uint64_t index) {
  const auto path = std::filesystem::temp_directory_path() / fmt::format("steplock_{}_decades.toml", getpid());
  std::ofstream(path) << decades_motor_file(seed, index);
  design::Settings s = load_drive_file(path.string()).settings;
  std::filesystem::remove(path);
  return s;
}

TEST(DecadesMotor, IsTheSameForTheSameSeedAndAnotherOneElse) {
  EXPECT_EQ(decades_motor_file(3, 7), decades_motor_file(3, 7));
  EXPECT_NE(decades_motor_file(3, 7), decades_motor_file(3, 8));
  EXPECT_NE(decades_motor_file(3, 7), decades_motor_file(4, 7));
}

// Whatever the library works out is within limits and words.  Of 10,000 motors, of another seed with STEPLOCK_SEED; they reach
// both ends of what is drawn.
TEST(DecadesMotor, EachOfTenThousandGetsWords) {
  const char* asked = std::getenv("STEPLOCK_SEED");
  const std::uint64_t seed = asked ? std::stoull(asked) : 36;
  std::vector<double> buses, currents, frequencies, inertias;
  int refused = 0;
  for (std::uint64_t k = 0; k < 10'000 && refused < 10; ++k) {
    const design::Settings s = drawn(seed, k);
    const auto found = design::problems(s);
    if (!found.empty()) {
      ADD_FAILURE() << "steplock motors --decades --seed " << seed << ", " << decades_motor_name(k) << ": " << found.front();
      ++refused;
    }
    buses.push_back(s.inverter.bus_v);
    currents.push_back(s.motor.rated_current_a);
    frequencies.push_back(s.scenario.speed_rpm * s.motor.pole_pairs);
    inertias.push_back(s.motor.inertia_kgm2);
  }
  const auto reach = [](const std::vector<double>& x, double low, double high) {
    EXPECT_LT(std::ranges::min(x), 2 * low);
    EXPECT_GT(std::ranges::max(x), high / 2);
  };
  reach(buses, 2, 800);
  reach(currents, 0.1, 1000);
  reach(frequencies, 100, 1e6);
  reach(inertias, 1e-8, 10);
}

}  // namespace
}  // namespace steplock
