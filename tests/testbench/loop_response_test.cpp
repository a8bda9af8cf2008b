#include "testbench/paper/loop_response.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "model/design/design.hpp"
#include "testbench/drive_file/drive_file.hpp"
#include "testbench/paper/ideal_rotor.hpp"

namespace steplock {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(IdealRotor, CrossesWhereItsPhaseSays) {
  const IdealRotor rotor(40, {{30, 0.01}, {200, 0.002}});
  for (int k = 1; k < 500; ++k) {
    EXPECT_NEAR(rotor.phase(rotor.crossing(k)), k / 6.0, 1e-12) << k;
  }
}

// plant.hpp: e_u rises at 0, e_v 120 and e_w 240 degrees later; each is up for half a turn.
TEST(IdealRotor, ComparatorsAreThoseOfThePlant) {
  constexpr bool kUp[6][3] = {{1, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
  for (int k = -6; k < 12; ++k) {
    for (std::size_t p = 0; p < 3; ++p) {
      EXPECT_EQ(IdealRotor::pins(k).comparator[p], kUp[(k + 6) % 6][p]) << k;
    }
  }
}

TEST(TonesIn, AreFoundBesideASteadyTurning) {
  std::vector<double> times, turns;
  for (int i = 0; i < 2000; ++i) {
    const double t = i * 4e-3 + 1e-4 * (i % 7);  // unevenly sampled, as commutations are
    times.push_back(t);
    turns.push_back(3 + 40 * t + 0.01 * std::sin(30 * t + 0.5) + 0.002 * std::cos(200 * t));
  }
  const auto found = tones_in(times, turns, {30, 200});
  EXPECT_NEAR(std::abs(found[0] - std::polar(0.01, 0.5)), 0, 1e-12);
  EXPECT_NEAR(std::abs(found[1] - std::complex<double>(0, 0.002)), 0, 1e-12);
}

// The blocks' own loop against the sampled computation of the design library, which leaves out aliases:
// a tone's own one lies at the crossing rate less its frequency.  The drive takes samples some 2 us apart
// and so places a crossing within half of what the rotor turns in between.  Of the closed loop's answer T
// to a tone that is at most the part `place`; and H = T / (1 - T) magnifies it by |1 + H|^2 / |H|.
TEST(MeasureLoop, IsTheSampledLoopOfTheDesignLibrary) {
  const auto s = load_drive_file(STEPLOCK_DRIVES "/amano2003.toml").settings;
  const LoopExperiment e{.rpm = 1200, .tones = 8, .measure_s = 3, .engine = EngineKind::kFixed};
  const auto d = design::design_drive(s);
  const auto& loop = d.parameters.loop;
  constexpr double kCrossings = 240;  // per second
  const double place = 60 * kCrossings * d.parameters.bemf.sample_every / 2 / e.tone_deg;
  const auto computed = design::open_loop_sampled({loop.integral, loop.proportional, loop.pole},
                                                  d.parameters.pwm.tick(), 1 / kCrossings);
  const auto measured = measure_loop(s, e);
  ASSERT_GE(measured.size(), 7u);
  for (const LoopPoint& p : measured) {
    const std::complex<double> wanted = computed(p.omega);
    const double alias = std::abs(computed(2 * std::numbers::pi * kCrossings - p.omega) / wanted);
    const double magnified = place * std::norm(1.0 + wanted) / std::abs(wanted);
    EXPECT_LT(std::abs(p.open / wanted - 1.0), alias + magnified) << p.omega;
  }
}

// The negative control: a loop of twice the gain is not taken for the designed one.
TEST(MeasureLoop, TellsTwiceTheGain) {
  auto s = load_drive_file(STEPLOCK_DRIVES "/amano2003.toml").settings;
  const LoopExperiment e{.rpm = 1200, .lowest = 60, .highest = 90, .tones = 2, .measure_s = 2,
                         .engine = EngineKind::kFixed};
  const double once = measure_loop(s, e)[0].gain_db();
  s.loop.k_l = 2 * *s.loop.k_l;
  EXPECT_NEAR(measure_loop(s, e)[0].gain_db() - once, 20 * std::log10(2.0), 0.5);
}

}  // namespace
}  // namespace steplock
