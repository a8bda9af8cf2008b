// Each hardship is in the plant what its name says; and one that the drive's current cannot master ends latched.
#include "testbench/sweep/hardship.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/sweep/drawn_run.hpp"
#include "testbench/sweep_page/statistics.hpp"
#include "testbench/sweep/sweep.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

constexpr double kPi = std::numbers::pi;

RunSeed hard_seed(std::uint64_t k) { return run_seed({.matrix = Matrix::kHard, .outside = 0.5}, k); }

// The first drawn run of a kind.
DrawnRun run_of(const design::Settings& s, Trial kind) {
  for (std::uint64_t k = 0;; ++k) {
    if (draw_hardship(s, hard_seed(k)).kind == kind) return drawn_run(s, hard_seed(k));
  }
}

// Gates off.
plant::Plant left_alone(const DrawnRun& run) {
  return plant::Plant(plant_parameters(run.settings), initial_state(run.settings, run.settings.scenario.start_angle_deg));
}

design::Settings frictionless() {
  design::Settings s = short_drive();
  s.motor.coulomb_nm = s.motor.viscous_nms = 0;
  return s;
}

TEST(Hardship, ASeedOfTheHardMatrixIsInsideAndExactInADouble) {
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const RunSeed seed = hard_seed(k);
    EXPECT_TRUE(seed.hard());
    EXPECT_FALSE(seed.outside());
    EXPECT_FALSE(seed.disturbed());
    EXPECT_LT(seed.value, kSeedEnd);
    EXPECT_EQ(static_cast<std::uint64_t>(static_cast<double>(seed.value)), seed.value);
    EXPECT_FALSE(run_seed({.seed = 5}, k).hard());
  }
}

TEST(Hardship, EveryKindIsDrawnWithinWhatTheFileAllows) {
  design::Settings s = short_drive();
  s.hardship = {.unbalance = 0.5, .wind = 0.4, .cogging = 0.3, .stiction = 0.2, .breakaway = 0.1, .comparators = 3, .spring_hz = {20, 30}};
  const double most[kTrials] = {0.5, 0.4, 30, 0.3, 0.2, 0.1, 3}, least[kTrials] = {0.1, -0.4, 20, 0.06, 0.04, 0.02, 3};
  std::set<Trial> kinds;
  bool against = false;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const Hardship h = draw_hardship(s, hard_seed(k));
    kinds.insert(h.kind);
    against = against || h.size < 0;
    EXPECT_LE(h.size, most[static_cast<int>(h.kind)]);
    EXPECT_GE(h.size, least[static_cast<int>(h.kind)]);
    EXPECT_EQ(h.detail != 0, h.kind == Trial::kSwing || h.kind == Trial::kCogging);
  }
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(kTrials));
  EXPECT_TRUE(against);
}

// Between 30 and 150 degrees, as the draw says, and back again: no friction.
TEST(Hardship, AWeightSwingsItsRotorAsFarAsItWasDrawn) {
  const DrawnRun run = run_of(frictionless(), Trial::kSwing);
  plant::Plant plant = left_alone(run);
  const double hang = run.settings.load.unbalance_deg * kPi / 180;
  // Currents of the swing's own back-EMF do not flow: it stays below the diodes' drop.
  double farthest = 0, nearest = 10;
  for (int k = 0; k < 4000; ++k) {
    plant.advance_to(1e-4 * k);
    const double away = std::remainder(plant.state().angle - hang, 2 * kPi);
    farthest = std::max(farthest, std::abs(away));
    nearest = std::min(nearest, std::abs(away));
  }
  const double lost = run.hardship.speed * run.hardship.speed;  // cos(detail) - cos(amplitude)
  const double amplitude = std::acos(std::cos(run.hardship.detail) - lost);
  EXPECT_GT(amplitude, 29.9 * kPi / 180);
  EXPECT_LT(amplitude, 150.1 * kPi / 180);
  EXPECT_NEAR(farthest, amplitude, 0.01);
  EXPECT_LT(nearest, 0.05);
}

TEST(Hardship, WindTurnsItsFanAtTheSpeedAtWhichTheRunBegins) {
  const DrawnRun run = run_of(short_drive(), Trial::kWind);
  ASSERT_NE(run.settings.scenario.start_speed_rpm, 0);
  EXPECT_EQ(run.settings.scenario.start_speed_rpm < 0, run.hardship.size < 0);
  plant::Plant plant = left_alone(run);
  const double before = plant.state().speed;
  plant.advance_to(0.5);
  EXPECT_NEAR(plant.state().speed / before, 1, 1e-3);
}

TEST(Hardship, ABeltLeavesTheInertiaAndTakesHalfOfItBehindItsSpring) {
  const design::Settings s = short_drive();
  const DrawnRun run = run_of(s, Trial::kSpring);
  const auto& p = run.settings;
  EXPECT_NEAR(p.motor.inertia_kgm2 + p.load.inertia_kgm2,
              run.conditions.inertia * (s.motor.inertia_kgm2 + s.load.inertia_kgm2), 1e-12);
  EXPECT_GE(p.load.inertia_kgm2, p.motor.inertia_kgm2);
  EXPECT_NEAR(std::sqrt(p.load.spring_nm_rad / p.load.inertia_kgm2) / (2 * kPi), run.hardship.size, 1e-9);
}

TEST(Hardship, TheOthersStandInThePlantsOwnParameters) {
  const design::Settings s = short_drive();
  const double rated = rated_torque(s);
  const DrawnRun cogging = run_of(s, Trial::kCogging), stiction = run_of(s, Trial::kStiction),
                 breakaway = run_of(s, Trial::kBreakaway), comparators = run_of(s, Trial::kComparators);
  EXPECT_DOUBLE_EQ(plant_parameters(cogging.settings).motor.cogging_torque, cogging.hardship.size * rated);
  EXPECT_EQ(plant_parameters(cogging.settings).motor.cogging_periods % (6 * s.motor.pole_pairs), 0);
  EXPECT_DOUBLE_EQ(plant_parameters(stiction.settings).motor.static_friction, s.motor.coulomb_nm + stiction.hardship.size * rated);
  EXPECT_DOUBLE_EQ(plant_parameters(breakaway.settings).load.breakaway_torque, breakaway.hardship.size * rated);
  const Conditions drawn = draw_conditions(s, comparators.seed);
  EXPECT_DOUBLE_EQ(comparators.settings.sensors.comparator_noise_v, 2 * drawn.noise_v);
  EXPECT_DOUBLE_EQ(comparators.settings.sensors.comparator_delay_s, 2 * drawn.delay_s);
  EXPECT_DOUBLE_EQ(comparators.settings.sensors.comparator_offset_v[1], 2 * drawn.offset_v_v);
}

TEST(Hardship, EachOneStartsAndItsRowIsTheSameAfterReading) {
  const design::Settings s = short_drive();
  for (int k = 0; k < kTrials; ++k) {
    const auto row = make_row(0, "short", s, run_of(s, static_cast<Trial>(k)).seed);
    EXPECT_EQ(row->findings.outcome, Outcome::kStarted) << name_of(static_cast<Trial>(k)) << ' ' << row->seed;
    EXPECT_EQ(row->hardship.kind, static_cast<Trial>(k));
    const std::string line = csv_line(*row);
    EXPECT_EQ(csv_line(parse_csv_line(Matrix::kHard, line, "x", 1)), line);
  }
}

// The negative control: more than the limit's current can break away, and more than it can turn over.  The reason is named,
// within five seconds.
TEST(Hardship, OneThatTheLimitsCurrentCannotMasterEndsLatchedInTime) {
  for (const Trial kind : {Trial::kBreakaway, Trial::kStiction, Trial::kCogging}) {
    design::Settings s = short_drive();
    s.hardship.breakaway = s.hardship.stiction = s.hardship.cogging = 20;
    const DrawnResult result = simulate(run_of(s, kind));
    EXPECT_EQ(result.findings.outcome, Outcome::kLatched) << name_of(kind);
    EXPECT_NE(result.findings.reason, Reason::kNone);
    EXPECT_LT(result.findings.end_s, 5) << name_of(kind);
  }
}

// Of every drive file, light rotors and heavy ones: all tries together follow for 4096 ticks, whatever noise makes the follower see.
class Blocked : public testing::TestWithParam<const char*> {};

TEST_P(Blocked, EndsAfterTheTicksOfOneTry) {
  design::Settings s = load_drive_file(STEPLOCK_DRIVES "/" + std::string(GetParam()) + ".toml").settings;
  s.hardship.breakaway = s.hardship.stiction = 20;
  int runs = 0;
  for (std::uint64_t k = 0; runs < 3; ++k) {
    const Trial kind = draw_hardship(s, hard_seed(k)).kind;
    if (kind != Trial::kBreakaway && kind != Trial::kStiction) continue;
    ++runs;
    const DrawnRun run = drawn_run(s, hard_seed(k));
    const auto& start = run.parameters.start;
    const double tick = run.parameters.pwm.tick(), between = start.detect_spin + start.retry_delay + 2 * tick;
    const DrawnResult result = simulate(run);
    EXPECT_EQ(result.findings.outcome, Outcome::kLatched) << k;
    EXPECT_LT(result.findings.end_s, run.settings.scenario.run_s + 4097 * tick + (start.retries + 1) * between) << name_of(kind) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Hardship, Blocked, testing::Values("amano2003", "bly172s", "br2804_drone", "ceiling_fan", "hoverboard_hub",
                                                            "m2310p_servo", "maxon_ec45_flat", "tekin_spindle"),
                         [](const auto& drive) { return std::string(drive.param); });

TEST(Hardship, ALossIsCountedWithItsKind) {
  const design::Settings s = short_drive();
  Row row{.index = 0, .drive = "short", .seed = run_of(s, Trial::kCogging).seed.value, .rtl = "", .conditions = {}, .findings = {},
          .disturbance = {}, .hardship = {.kind = Trial::kCogging}, .after = {}};
  row.findings.outcome = Outcome::kLatched;
  const SweepSetup setup{.kind = {.matrix = Matrix::kHard}, .runs = 1, .drives = {{"short", "x"}}};
  EXPECT_FALSE(passed(setup, {row}));
  EXPECT_EQ(sweep_json(setup, {row})["per_hardship"]["cogging"]["latched"], 1);
  EXPECT_EQ(sweep_json(setup, {row})["per_hardship"]["swing"]["runs"], 0);
  EXPECT_NE(start_page(setup, {row}).find("--replay " + std::to_string(row.seed)), std::string::npos);
}

}  // namespace
}  // namespace steplock
