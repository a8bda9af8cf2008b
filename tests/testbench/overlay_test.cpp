// Two runs on one page: each figure has both, the table says by how much they differ, and what is no run is refused.
#include "testbench/report/overlay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

// A run of four samples; `turns` columns as the drives write them.
fs::path run_in(const std::string& name, double speed, const std::string& summary, bool duty = true) {
  const fs::path folder = fs::temp_directory_path() / "steplock_overlay" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::ofstream(folder / "summary.json") << summary;
  for (const char* file : {"run.csv", "steady.csv"}) {
    std::ofstream csv(folder / file);
    csv << "time_s,speed_rpm,iu_a,iv_a,iw_a,torque_nm,state" << (duty ? ",duty" : "") << "\n";
    for (int k = 0; k < 4; ++k) csv << 5 + k << "," << speed + k << ",1,-3," << k << ",0.5,run" << (duty ? ",0.25" : "") << "\n";
  }
  return folder;
}

std::string refusal(const fs::path& folder) {
  try {
    RunFolder run(folder);
    run.column("run.csv", "speed_rpm");
  } catch (const BadInput& e) {
    return e.what();
  }
  return "taken";
}

TEST(Overlay, EachPanelHasBothRuns) {
  const RunFolder a(run_in("a", 100, "{}")), b(run_in("b", 200, "{}"));
  const auto figures = overlay_figures(a, b);
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].panels.size(), 4u);
  for (const Figure& f : figures) {
    for (const Panel& p : f.panels) {
      ASSERT_EQ(p.curves.size(), 2u);
      EXPECT_EQ(p.curves[0].title, "a");
      EXPECT_EQ(p.curves[1].title, "b");
      EXPECT_EQ(p.curves[0].points.size(), 4u) << p.label;
    }
  }
  EXPECT_EQ(figures[0].panels[0].curves[1].points[2].y, 202);
  EXPECT_EQ(figures[0].panels[0].curves[1].points[2].x, 7) << "seconds after t = 0";
  EXPECT_EQ(figures[1].panels[0].curves[1].points[2].x, 2000) << "milliseconds after its samples begin";
  // The largest of the three, either way.
  EXPECT_EQ(figures[0].panels[1].curves[0].points[0].y, 3);
}

TEST(Overlay, WhatOneRunDoesNotHaveIsNotDrawn) {
  const RunFolder six_step(run_in("a", 100, "{}")), sinusoidal(run_in("b", 200, "{}", false));
  const auto figures = overlay_figures(six_step, sinusoidal);
  ASSERT_EQ(figures[0].panels.size(), 3u);
  for (const Panel& p : figures[0].panels) EXPECT_NE(p.label, "duty");
}

TEST(Overlay, TheTableSaysByHowMuchTheyDiffer) {
  const RunFolder a(run_in("a", 1, R"({"lock_time_s": 0.5, "fault": "none", "loaded": {"error": 0}, "old": 1})"));
  const RunFolder b(run_in("b", 1, R"({"lock_time_s": 0.6, "fault": "no_lock", "loaded": {"error": 0.25}, "new": 2})"));
  const std::string page = overlay_page(a, b, {}, fs::temp_directory_path());
  EXPECT_THAT(page, HasSubstr("<td>lock_time_s</td><td>0.5</td><td>0.6</td><td>+0.1 (+20 %)</td>"));
  EXPECT_THAT(page, HasSubstr("<td>fault</td><td>none</td><td>no_lock</td><td>differs</td>"));
  EXPECT_THAT(page, HasSubstr("<td>loaded.error</td><td>0</td><td>0.25</td><td>+0.25</td>"));
  EXPECT_THAT(page, HasSubstr("<td>old</td><td>1</td><td>-</td><td>differs</td>"));
  EXPECT_THAT(page, HasSubstr("<td>new</td><td>-</td><td>2</td><td>differs</td>"));
}

TEST(Overlay, TwoFoldersOfOneNameAreTold) {
  const RunFolder a(run_in("x/run", 1, "{}")), b(run_in("y/run", 1, "{}"));
  EXPECT_THAT(overlay_figures(a, b)[0].panels[0].curves[0].title, testing::EndsWith("x/run"));
}

TEST(Overlay, WhatIsNoRunIsRefusedWithItsFile) {
  EXPECT_THAT(refusal("/nonexistent/run"), HasSubstr("/nonexistent/run: no summary.json in it; name a folder"));
  EXPECT_THAT(refusal(run_in("a", 1, "half {")), HasSubstr("summary.json: is no summary of a run"));
  const fs::path folder = run_in("a", 1, "{}");
  std::ofstream(folder / "run.csv") << "time_s,speed_rpm\n0,1\n1,fast\n";
  EXPECT_THAT(refusal(folder), HasSubstr("run.csv:3: speed_rpm is no number here"));
}

}  // namespace
}  // namespace steplock
