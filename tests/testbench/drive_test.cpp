// What one drive has, the other has: runs, reports, waves and lockstep by one path.
#include "testbench/drive/drive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "tests/testbench/own_folder.hpp"

namespace steplock {
namespace {

namespace fs = std::filesystem;

// A start, a load step and the end of it, as short as the drive allows.
template <class Drive>
design::Settings scenario();
template <>
design::Settings scenario<SixStepDrive>() {
  return open_drive_file(STEPLOCK_TESTS "/short.toml").settings;
}
template <>
design::Settings scenario<SinusoidalDrive>() {
  design::Settings s = open_drive_file(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml").settings;
  s.scenario.stop_s.reset();
  s.scenario.load_step_s = 0.5;
  s.scenario.load_off_s = 0.65;
  s.scenario.duration_s = 0.7;
  return s;
}

std::string read(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

template <class Drive>
class EitherDrive : public testing::Test {};
using Drives = testing::Types<SixStepDrive, SinusoidalDrive>;
TYPED_TEST_SUITE(EitherDrive, Drives);

TYPED_TEST(EitherDrive, IsFoundByItsSettings) {
  with_drive(scenario<TypeParam>(), [](auto drive) {
    EXPECT_TRUE((std::is_same_v<decltype(drive), TypeParam>));
    return 0;
  });
}

TYPED_TEST(EitherDrive, LeavesAPageFiguresSamplesAndAWave) {
  const design::Settings s = scenario<TypeParam>();
  const fs::path out = own_folder();
  RunOptions options{.engine = EngineKind::kFixed};
  typename TypeParam::Record record;
  {
    TraceWriter trace((out / "wave.fst").string(), TypeParam::wave(), s.motor.pole_pairs);
    options.trace = &trace;
    record = TypeParam::run(s, options);
  }
  const auto summary = TypeParam::summarise(s, options, record);
  for (const std::string& failure : summary.failures()) ADD_FAILURE() << failure;
  const ReportFiles files = TypeParam::report(out, s, summary, record, true);
  EXPECT_TRUE(files.warnings.empty());
  for (const char* name : {"summary.json", "run.csv", "lock.csv", "steady.csv", "start.svg", "lock.svg",
                           "steady.svg", "load_step.svg", "report.html", "wave.fst", "wave.gtkw"}) {
    EXPECT_NE(std::ranges::find(files.paths, out / name), files.paths.end()) << name;
    EXPECT_GT(fs::file_size(out / name), 100u) << name;
  }
  EXPECT_EQ(nlohmann::json::parse(read(out / "summary.json"))["engine"], "fixed");
  const std::string page = read(out / "report.html");
  EXPECT_NE(page.find("passed"), page.npos);
  EXPECT_NE(page.find(escaped(s.drive.name)), page.npos);
}

// A wave only looks: it takes more samples, and no number of the run's moves.
TYPED_TEST(EitherDrive, RunsTheSameWithAWave) {
  design::Settings s = scenario<TypeParam>();
  s.scenario.duration_s = 0.05;
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset();
  const fs::path path = own_folder() / "same.fst";
  const auto end = [&](TraceWriter* trace) {
    const auto record = TypeParam::run(s, {.engine = EngineKind::kFixed, .angle_deg = 77, .trace = trace});
    return std::pair(record.overview.back().plant.electrical_angle, record.changes.size());
  };
  TraceWriter trace(path.string(), TypeParam::wave(), s.motor.pole_pairs);
  const auto with = end(&trace), without = end(nullptr);
  EXPECT_NEAR(with.first, without.first, 1e-6);
  EXPECT_EQ(with.second, without.second);
}

TYPED_TEST(EitherDrive, IsHeldInLockstepOnEveryClock) {
  design::Settings s = scenario<TypeParam>();
  s.scenario.duration_s = 0.02;
  s.scenario.load_step_s.reset(), s.scenario.load_off_s.reset();
  const RunOptions options{.engine = EngineKind::kRtl, .lockstep = true};
  auto summary = TypeParam::summarise(s, options, TypeParam::run(s, options));
  ASSERT_TRUE(summary.lockstep);
  EXPECT_TRUE(summary.lockstep->equal()) << to_text(*summary.lockstep);
  EXPECT_EQ(summary.lockstep->clocks, summary.clocks);
  EXPECT_TRUE(to_json(summary)["rtl_equals_fixed"]["equal"]);
  // And a difference fails the run.
  summary.lockstep->differing_clocks = 1;
  const auto failures = summary.failures();
  EXPECT_NE(std::ranges::find(failures, "the RTL is not its C++"), failures.end());
}

// Under load, where the ripple is small beside it: the rotor's q current is the drive's delta current, but for
// the estimate's error (below 3 degrees here) and the ADC's step.  Its noise is taken away.
TEST(SinusoidalDrive, TheRotorsAxesAreTheDrivesWhereTheEstimateIsRight) {
  design::Settings s = scenario<SinusoidalDrive>();
  s.adc.current_noise_a = 0;
  const auto record = SinusoidalDrive::run(s, {.engine = EngineKind::kFixed});
  double q = 0, d = 0, delta = 0, gamma = 0, n = 0;
  for (const auto& x : record.overview) {
    if (x.time < 0.6 || x.time > 0.64) continue;
    const auto i = sinusoidal::rotor_current(x.plant);
    q += i.q, d += i.d, delta += x.drive.i_delta, gamma += x.drive.i_gamma, ++n;
  }
  ASSERT_GT(n, 100);
  const double turned = 3 * std::numbers::pi / 180, step = 2 * design::sinusoidal::current_range(s) / 4096;
  EXPECT_GT(delta / n, 2);
  EXPECT_NEAR(q / n, delta / n, (1 - std::cos(turned)) * delta / n + step);
  EXPECT_NEAR(d / n, gamma / n, std::sin(turned) * delta / n + step);
}

}  // namespace
}  // namespace steplock
