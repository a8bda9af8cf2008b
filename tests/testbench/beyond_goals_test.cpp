#include "testbench/sweep_page/beyond_goals.hpp"

#include <gtest/gtest.h>

#include "testbench/sweep_page/page_head.hpp"

namespace steplock {
namespace {

struct Page {
  SweepSetup setup;
  std::vector<Row> rows;

  Page() { setup.drives.push_back({.name = "fan", .fingerprint = "", .weight = 1, .limit_a = 10}); }
  Row& add(std::uint64_t seed) {
    Row row;
    row.drive = "fan";
    row.seed = seed;
    row.findings.outcome = Outcome::kStarted;
    row.findings.peak_current_a = 10;
    row.findings.lock_time_s = 1;
    row.findings.peak_speed = 1.05;
    rows.push_back(row);
    return rows.back();
  }
};

// A seed that a reader chose stands in the command; one that follows from what is judged is told with its digest.
TEST(PageHead, SaysWithWhatItWasPrintedAndWhoChoseTheSeed) {
  SweepSetup setup = Page().setup;
  setup.runs = 5, setup.kind.seed = 7;
  const auto head = [&] { return page_head(setup, "Title", "tools/starts", "drives/*.toml", "docs/a.md", "a_test"); };
  EXPECT_EQ(head(), "# Title\n\nPrinted by `steplock sweep drives/*.toml --runs 5 --seed 7 --page docs/a.md`; the test `a_test` repeats its "
                    "first runs and fails when they are not the page's.\n\n");
  setup.judged = "0123456789abcdef0123";
  EXPECT_NE(head().find("Printed by `tools/starts 5`; the test"), std::string::npos);
  EXPECT_NE(head().find("Nobody chose the seed, 7: it follows from a digest (0123456789abcdef) of"), std::string::npos);
}

TEST(BeyondGoals, NothingIsSaidWhereNothingLiesBeyond) {
  Page page;
  page.add(1);
  EXPECT_EQ(beyond_goals(page.setup, page.rows), "");
}

TEST(BeyondGoals, CountsAndNamesTheWorst) {
  Page page;
  for (std::uint64_t k = 1; k <= 5; ++k) {
    page.add(k).findings.peak_speed = 1.1 + 0.01 * double(k % 4);
    page.rows.back().conditions.inertia = k == 2 ? 0.5 : 5;
  }
  const std::string text = beyond_goals(page.setup, page.rows);
  EXPECT_NE(text.find("over the set speed, beyond 1.1: 4 of 5 runs. 1 had less inertia"), text.npos) << text;
  EXPECT_NE(text.find(" 3 had more inertia"), text.npos) << text;
  const auto at = [&](const char* seed) { return text.find(std::string("fan `--replay ") + seed + "` |"); };
  EXPECT_LT(at("3"), at("2"));
  EXPECT_LT(at("2"), at("1"));
  EXPECT_EQ(at("5"), text.npos) << "three are shown";
  EXPECT_EQ(text.find("Peak current"), text.npos);
}

// With 1.3 times the file's duty for its speed; of heavy rotors it is the swing.
TEST(BeyondGoals, AFastRotorWithAStrongBusFollowsItsDuty) {
  Page page;
  for (const double inertia : {0.6, 2.0, 5.0}) {
    page.add(1).findings.peak_speed = 1.12;
    page.rows.back().conditions.inertia = inertia;
    page.rows.back().conditions.flux = 0.85, page.rows.back().conditions.bus = 1.1;
  }
  const std::string text = beyond_goals(page.setup, page.rows);
  EXPECT_NE(text.find("3 of 3 runs. 2 had so much bus for its flux"), text.npos) << text;
  EXPECT_NE(text.find(" 1 had more inertia"), text.npos) << text;
}

// Of a run as docs/sweep.md tells it: neither bus, flux nor inertia is far enough from the file's.
TEST(BeyondGoals, AFastRotorALittleHeavierThanTheFilesIsNotExplained) {
  Page page;
  page.add(1).findings.peak_speed = 1.13;
  page.rows.back().conditions.inertia = 1.18, page.rows.back().conditions.flux = 0.962, page.rows.back().conditions.bus = 1.15;
  const std::string text = beyond_goals(page.setup, page.rows);
  EXPECT_NE(text.find("1 of 1 runs. 1: not explained here."), text.npos) << text;
}

TEST(BeyondGoals, APeakIsOverTheDrivesLimitAndARunThatWasNotAskedIsNotCounted) {
  Page page;
  page.add(7).findings.peak_current_a = 11.6;
  page.rows.back().findings.kick_deg = 361;
  page.rows.back().conditions.speed = -0.9;
  Row& latched = page.add(8);
  latched.findings.outcome = Outcome::kLatched;
  latched.findings.lock_time_s = 9;
  const std::string text = beyond_goals(page.setup, page.rows);
  EXPECT_NE(text.find("beyond 1.15: 1 of 2 runs. 1 turned backwards"), text.npos) << text;
  EXPECT_NE(text.find("| 1.16 | inertia 1, bus 1, flux 1, load 0, turns at -0.9 of the set speed |"), text.npos) << text;
  EXPECT_NE(text.find("beyond 360: 1 of 1 runs."), text.npos) << text;
  EXPECT_EQ(text.find("Time to lock"), text.npos);
}

// Of sinusoidal drives the causes are others: a rotor that pulses find is not turned by a pattern.
TEST(BeyondGoals, ASinusoidalPeakIsThePilotPulsesWhereThereAreAny) {
  Page page;
  page.setup.drive_kind = design::DriveKind::kSinusoidal;
  page.add(7).findings.peak_current_a = 12;
  page.rows.back().findings.kick_deg = 400;
  page.add(8).findings.kick_deg = 500;
  page.rows.back().findings.retries = 1;
  const std::string pattern = beyond_goals(page.setup, page.rows);
  EXPECT_NE(pattern.find("beyond 1.15: 1 of 2 runs. 1: not explained here."), pattern.npos) << pattern;
  EXPECT_NE(pattern.find("beyond 360: 2 of 2 runs. 1 turned backwards in an attempt that was given up. 1 were turned"), pattern.npos) << pattern;
  page.setup.drives[0].pilot = true;
  const std::string pilot = beyond_goals(page.setup, page.rows);
  EXPECT_NE(pilot.find("beyond 1.15: 1 of 2 runs. 1 were found by pilot pulses"), pilot.npos) << pilot;
}

TEST(BeyondGoals, WhatNoCauseExplainsIsSaidSo) {
  Page page;
  page.add(7).findings.peak_current_a = 11.6;
  EXPECT_NE(beyond_goals(page.setup, page.rows).find("1 of 1 runs. 1: not explained here."), std::string::npos);
}

}  // namespace
}  // namespace steplock
