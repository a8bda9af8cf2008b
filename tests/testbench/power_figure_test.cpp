// The figure's curves are one balance: what the source gives is what the load, the store and the heat take, to what the plant's own
// check leaves over.
#include "testbench/report/power_figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "testbench/drive/sinusoidal.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

const Curve& curve(const Figure& f, std::size_t panel, const char* title) {
  for (const Curve& c : f.panels.at(panel).curves) {
    if (c.title == title) return c;
  }
  throw std::out_of_range(title);
}

// J that the spans of equal length from `first` to `last` leave over.
template <class Sample>
double left_over(const Figure& f, const std::vector<Sample>& samples, std::size_t stride) {
  double joule = 0;
  for (std::size_t k = 0, i = stride; i < samples.size(); ++k, i += stride) {
    const double dt = samples[i].time - samples[i - stride].time;
    const auto at = [&](std::size_t panel, const char* title) { return curve(f, panel, title).points.at(k).y; };
    joule += dt * (at(0, "source") - at(0, "load") - at(0, "stored") - at(1, "copper") - at(1, "switches") - at(1, "bus resistance") -
                   at(1, "friction"));
  }
  return joule;
}

template <class Record>
void expect_balance(const Figure& f, const Record& record) {
  const auto& all = record.overview;
  const std::size_t stride = all.size() / 300, spans = (all.size() - 1) / stride;
  ASSERT_GT(stride, 1u) << "of several samples, for a span to be more than what lies between two";
  ASSERT_EQ(curve(f, 0, "source").points.size(), spans);
  const auto &first = all.front().plant.energy, &last = all[spans * stride].plant.energy;
  // The same sums in another order: some thousand additions of 53 bits.
  const double rounding = std::ldexp(last.supplied, -53 + 13);
  EXPECT_NEAR(left_over(f, all, stride), last.residual() - first.residual(), rounding);
}

TEST(PowerFigure, IsOneBalanceAndTheLoadsShareOfIt) {
  const DriveFile file = open_drive_file(STEPLOCK_TESTS "/short.toml");
  const RunOptions options{.engine = EngineKind::kFloat};
  const Record record = run_drive(file.settings, options);
  const Figure f = power_figure(record.overview, {{0.4, "load"}});
  expect_balance(f, record);
  ASSERT_EQ(f.panels.size(), 3u);
  EXPECT_EQ(f.marks.size(), 1u);
  // Each share is that of the plant's energies over its span, whether the source gives them or the rotor that slows down.
  const std::size_t stride = record.overview.size() / 300;
  const std::vector<Point>& shares = f.panels[2].curves.at(0).points;
  std::size_t found = 0, slowed = 0;
  for (std::size_t i = stride; i < record.overview.size(); i += stride) {
    const Sample &from = record.overview[i - stride], &to = record.overview[i];
    const plant::Energy &a = from.plant.energy, &b = to.plant.energy;
    const double load = b.load - a.load, source = b.supplied - a.supplied, gone = a.stored() - b.stored();
    const auto p = std::ranges::find(shares, (from.time + to.time) / 2, &Point::x);
    ASSERT_EQ(p != shares.end(), load > 0) << from.time;
    if (p == shares.end()) continue;
    ++found;
    slowed += gone > 0;
    EXPECT_DOUBLE_EQ(p->y, 100 * load / (source + std::max(0.0, gone)));
    EXPECT_LT(p->y, 100);
    EXPECT_GE(to.time, file.settings.scenario.load_step_s);
    EXPECT_LE(from.time, file.settings.scenario.load_off_s);
  }
  EXPECT_EQ(found, shares.size());
  EXPECT_GT(found, 20u);
  EXPECT_GT(slowed, 0u);
}

TEST(PowerFigure, OfTheSinusoidalDriveIsOneBalanceToo) {
  const DriveFile file = open_drive_file(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml");
  const auto record = SinusoidalDrive::run(file.settings, {.engine = EngineKind::kFixed});
  expect_balance(power_figure(record.overview, {}), record);
}

TEST(PowerFigure, WithoutALoadThereIsNoEfficiency) {
  Power idle;
  idle.to_s = 1, idle.input = 2, idle.friction = 2;
  EXPECT_EQ(power_figure(std::vector<Power>{idle, idle}, {}).panels.size(), 2u);
  idle.load = 3, idle.stored = -3;  // a rotor that slows down gives the load more than the source does
  const Figure f = power_figure(std::vector<Power>{idle, idle}, {});
  ASSERT_EQ(f.panels.size(), 3u);
  EXPECT_DOUBLE_EQ(f.panels[2].curves[0].points[0].y, 60);
}

}  // namespace
}  // namespace steplock
