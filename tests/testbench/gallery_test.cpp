// The gallery: what its page says is what the runs say, and every file of drives/data_sheets has words.
#include "testbench/range/gallery.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "model/design/design.hpp"
#include "model/design/config.hpp"

namespace steplock {
namespace {

using testing::HasSubstr;

DriveFile sheet(const std::string& name) { return load_drive_file(STEPLOCK_DRIVES "/data_sheets/" + name + ".toml"); }

TEST(Gallery, AnEntryShowsTheStartAndNoMoreThanALittleAfterIt) {
  const GalleryEntry e = gallery_entry(sheet("cubemars_ri20"));
  EXPECT_TRUE(e.summary.failures().empty()) << e.summary.failures().front();
  ASSERT_TRUE(e.summary.start_time_s && e.summary.lock_time_s);
  EXPECT_LT(*e.summary.lock_time_s, *e.summary.start_time_s);
  ASSERT_EQ(e.start.panels.size(), 2u);
  const Curve& rotor = e.start.panels[0].curves[1];
  ASSERT_EQ(rotor.title, "rotor");
  const double until = e.settings.scenario.run_s + 1.3 * *e.summary.start_time_s;
  EXPECT_LE(rotor.points.back().x, until);
  EXPECT_GT(rotor.points.back().x, 0.9 * until);
  EXPECT_NEAR(rotor.points.front().y, 0, 0.01 * e.summary.set_speed_rpm);                       // from rest
  EXPECT_NEAR(rotor.points.back().y, e.summary.set_speed_rpm, 0.05 * e.summary.set_speed_rpm);  // and at set speed
  ASSERT_EQ(e.start.marks.size(), 2u);
  EXPECT_DOUBLE_EQ(e.start.marks[0].x, *e.summary.lock_time_s);

  const std::string page = gallery_page({e});
  // The sheet's own numbers come out again: 16 V, 1.89 ohm, 0.45 mH, 7 pole pairs, KV 600, 1.38 g cm^2, 1.47 A.
  EXPECT_THAT(page, HasSubstr("| CubeMars RI20 KV600, joint | 16 | 1.89 | 0.45 | 7 | 600 | 1.38 | 1.47 |"));
  EXPECT_THAT(page, HasSubstr("| CubeMars RI20 KV600, joint | 5700 | 665 | "));
  EXPECT_THAT(page, HasSubstr("](figures/gallery_cubemars_ri20.svg)"));
  EXPECT_THAT(page, HasSubstr("- motor.coulomb_nm: "));
}

TEST(Gallery, ARunThatFailedSaysWhy) {
  GalleryEntry e;
  e.file = "x.toml";
  e.settings = sheet("cubemars_ri20").settings;
  e.summary.drive = "x";
  e.summary.set_speed_rpm = 1000;
  EXPECT_THAT(gallery_page({e}), HasSubstr("| never | never | "));
  EXPECT_THAT(gallery_page({e}), HasSubstr("| no: " + e.summary.failures().front() + " |"));
  EXPECT_THAT(gallery_page({e}), testing::Not(HasSubstr("figures/gallery")));
}

TEST(Gallery, EveryFileHasWordsAndTheySpanDecades) {
  std::vector<double> inertias, buses, resistances;
  for (const auto& entry : std::filesystem::directory_iterator(STEPLOCK_DRIVES "/data_sheets")) {
    const DriveFile file = load_drive_file(entry.path().string());
    const auto found = design::problems(file.settings);
    EXPECT_TRUE(found.empty()) << entry.path() << ": " << found.front();
    inertias.push_back(design::motor_constants(file.settings).inertia);
    buses.push_back(file.settings.inverter.bus_v);
    resistances.push_back(file.settings.motor.resistance_ohm);
  }
  const auto span = [](const std::vector<double>& x) { return std::ranges::max(x) / std::ranges::min(x); };
  EXPECT_GE(inertias.size(), 11u);
  EXPECT_GT(span(inertias), 1e6);
  EXPECT_GT(span(buses), 50);
  EXPECT_GT(span(resistances), 4000);
}

}  // namespace
}  // namespace steplock
