// Sweeps of a short drive: in one go, in shards, resumed, merged; and their statistics.
#include "testbench/sweep/sweep.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "testbench/sweep/drawn_run.hpp"
#include "testbench/sweep_page/statistics.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kRuns = 5;

fs::path fresh(const std::string& name) {
  const fs::path path = fs::path(testing::TempDir()) / ("steplock_sweep_" + name);
  fs::remove_all(path);
  return path;
}

std::string text(const fs::path& path) {
  std::ostringstream all;
  all << std::ifstream(path, std::ios::binary).rdbuf();
  return all.str();
}

// The short drive within what it starts under at the first try, so that a run costs a tenth of a second.
std::vector<DriveFile> easy_drive() {
  DriveFile file = open_drive_file(STEPLOCK_TESTS "/short.toml");
  design::EnvelopeSection& e = file.settings.envelope;
  e.load = {0};
  e.fan = 0.1;
  e.inertia = {0.8, 1.2};
  e.spinning = 0;
  return {file};
}

class Sweep : public testing::Test {
 protected:
  const std::vector<DriveFile> files_ = easy_drive();
  const SweepSetup setup_ = sweep_setup({.seed = 5, .rtl = 0.6}, kRuns, files_);

  SweepEnd run(const fs::path& folder, const SweepOptions& options = {.jobs = 2}) {
    const SweepEnd end = sweep(setup_, files_, options, folder);
    write_sweep_report(setup_, end.rows, folder);
    return end;
  }
};

TEST_F(Sweep, ShardsMergedAreTheWholeByteForByte) {
  const fs::path whole = fresh("whole"), a = fresh("a"), b = fresh("b"), c = fresh("c"), merged = fresh("merged");
  const SweepEnd end = run(whole);
  EXPECT_EQ(end.rows.size(), kRuns);
  std::size_t parts = 0;
  for (std::uint64_t k = 0; k < 3; ++k) {
    parts += run(k == 0 ? a : k == 1 ? b : c, {.shard = {k, 3}, .jobs = 1}).rows.size();
  }
  EXPECT_EQ(parts, kRuns);
  SweepSetup setup;
  const SweepEnd together = merge_sweeps({c, a, b}, merged, setup);
  write_sweep_report(setup, together.rows, merged);
  for (const char* name : {"runs.csv", "sweep.json", "sweep.html", "setup.json"}) {
    EXPECT_EQ(text(whole / name), text(merged / name)) << name;
  }
  // Of the share that was asked for, some run was repeated on the RTL (of this seed).
  EXPECT_GT(sweep_json(setup, together.rows)["rtl_repeats"], 0);
  EXPECT_EQ(sweep_json(setup, together.rows)["rtl_differing"], 0);
}

TEST_F(Sweep, ResumedIsTheWholeByteForByte) {
  const fs::path whole = fresh("at_once"), parts = fresh("parts");
  run(whole);
  // Stopped by the first look after the third result.
  const SweepEnd first = run(parts, {.jobs = 1, .progress = [](auto done, auto) { return done < 3; }});
  EXPECT_TRUE(first.interrupted);
  EXPECT_GE(first.rows.size(), 3u);
  EXPECT_LT(first.rows.size(), kRuns);
  std::ofstream(parts / "runs.csv", std::ios::app) << "11,short,99";  // torn
  const SweepEnd second = run(parts, {.jobs = 2, .resume = true});
  EXPECT_EQ(second.done, kRuns - first.rows.size());
  for (const char* name : {"runs.csv", "sweep.json", "setup.json"}) {
    EXPECT_EQ(text(whole / name), text(parts / name)) << name;
  }
  SweepSetup fewer = setup_;
  fewer.runs = 3;
  try {
    sweep(fewer, files_, {.resume = true}, parts);
    ADD_FAILURE() << "runs beyond those that are asked for";
  } catch (const BadInput& e) {
    EXPECT_NE(std::string(e.what()).find(fmt::format("it has run {}; go on with --runs {}", kRuns - 1, kRuns)),
              std::string::npos) << e.what();
  }
  EXPECT_EQ(text(whole / "runs.csv"), text(parts / "runs.csv")) << "nothing half-written";
}

TEST_F(Sweep, IsNotOverwrittenAndNotMixed) {
  const fs::path folder = fresh("mixed");
  fs::create_directories(folder);
  std::ofstream(folder / "runs.csv") << csv_header(Matrix::kStart) << '\n';
  std::ofstream(folder / "setup.json") << setup_text(setup_);
  const auto message = [&](const SweepSetup& setup, bool resume) -> std::string {
    try {
      sweep(setup, files_, {.resume = resume}, folder);
    } catch (const BadInput& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(message(setup_, false).find("go on with --resume"), std::string::npos);
  SweepSetup other = setup_;
  other.kind.seed = 6;
  EXPECT_NE(message(other, true).find("setup.json:1: the seed is 5, not 6"), std::string::npos);
  other = setup_;
  other.drives[0].fingerprint = "changed";
  EXPECT_NE(message(other, true).find("short has changed"), std::string::npos);
}

TEST_F(Sweep, ARunReplayedAloneIsItsLine) {
  const fs::path folder = fresh("replay");
  const SweepEnd end = run(folder);
  for (const Row& row : {end.rows[0], end.rows[3]}) {
    const auto again = make_row(row.index, "short", files_[0].settings, {row.seed});
    EXPECT_EQ(csv_line(*again), csv_line(row));
    // With everything written down, as `steplock run --replay` does it.
    Record record;
    Row watched = row;
    watched.findings = simulate(drawn_run(files_[0].settings, {row.seed}), {.record = &record}).findings;
    EXPECT_EQ(csv_line(watched), csv_line(row));
    EXPECT_GT(record.overview.size(), 20u);
  }
}

TEST_F(Sweep, GivesEachDriveItsShare) {
  SweepSetup setup = setup_;
  setup.drives = {{"a", "", 1}, {"b", "", 0.25}, {"c", "", 1}};
  setup.runs = 900;
  const auto drives = drives_of_runs(setup);
  EXPECT_EQ(std::ranges::count(drives, 0u), 400);
  EXPECT_EQ(std::ranges::count(drives, 1u), 100);
  // The beginning of a longer sweep is the shorter one.
  setup.runs = 100;
  const auto fewer = drives_of_runs(setup);
  EXPECT_TRUE(std::ranges::equal(fewer, std::span(drives).first(100)));
}

// Negative controls of the outcomes: drives that cannot work are counted as what they are.
TEST_F(Sweep, ADriveWithoutTorqueIsLatchedAndCounted) {
  DrawnRun run = drawn_run(files_[0].settings, {8});
  run.config.start.start_duty = run.config.start.align_duty = 0;
  run.config.speed.bemf = 0;
  const DrawnResult result = simulate(run);
  EXPECT_EQ(result.findings.outcome, Outcome::kLatched);
  EXPECT_EQ(result.findings.reason, Reason::kBlocked);
  const Row row{.index = 0, .drive = "short", .seed = 8, .outside = false, .rtl = "", .conditions = run.conditions,
                .findings = result.findings, .disturbance = {}, .after = {}};
  SweepSetup setup = setup_;
  setup.runs = 1;
  EXPECT_FALSE(passed(setup, {row}));
  EXPECT_EQ(sweep_json(setup, {row})["latched"], 1);
  EXPECT_EQ(sweep_json(setup, {row})["failures"].size(), 1u);
}

// With Hall sensors a drive claims its lock at once; with all protection off it never gives it up.
TEST_F(Sweep, ADriveThatNeverDoubtsOnABlockedRotorIsASilentStepOutAndCounted) {
  DrawnRun run = drawn_run(files_[0].settings, {8});
  run.settings.load.opposing_nm = 10;
  run.config.source = Source::kHall;
  run.config.protection = {};
  const DrawnResult result = simulate(run);
  EXPECT_EQ(result.findings.outcome, Outcome::kSilentStepOut);
  const Row row{.index = 0, .drive = "short", .seed = 8, .outside = true, .rtl = "", .conditions = run.conditions,
                .findings = result.findings, .disturbance = {}, .after = {}};
  SweepSetup setup = setup_;
  setup.runs = 1;
  EXPECT_FALSE(passed(setup, {row})) << "not even outside the envelope";
  EXPECT_EQ(sweep_json(setup, {row})["silent_step_outs"], 1);
  EXPECT_EQ(sweep_json(setup, {row})["outside_envelope"], 1);
}

TEST(SweepStatistics, ARoughStartCountsLikeALossInsideTheEnvelope) {
  Row row;
  row.drive = "a";
  row.findings.outcome = Outcome::kRough;
  row.findings.beyond = "kick";
  row.findings.lock_time_s = 0.5;
  SweepSetup setup;
  setup.runs = 1;
  setup.drives = {{"a", "", 1, 20}};
  EXPECT_FALSE(passed(setup, {row}));
  const auto j = sweep_json(setup, {row});
  EXPECT_EQ(j["rough"], 1);
  EXPECT_EQ(j["inside"]["first_try"], 0);
  EXPECT_EQ(j["inside"]["lost_at_most"], 1);
  EXPECT_EQ(j["lock_time_s"]["max"], 0.5) << "its figures count all the same";
  EXPECT_EQ(j["failures"][0]["reason"], "beyond kick");
  row.outside = true;
  EXPECT_TRUE(passed(setup, {row}));
}

TEST(SweepStatistics, AreMinMedianMaxOfWhatStartedInside) {
  std::vector<Row> rows(4);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].index = k;
    rows[k].drive = "a";
    rows[k].findings.outcome = Outcome::kStarted;
    rows[k].findings.lock_time_s = 1.0 + static_cast<double>(k);
    rows[k].findings.peak_current_a = 10 * (1.0 + static_cast<double>(k));
  }
  rows[3].findings.outcome = Outcome::kLatched;
  SweepSetup setup;
  setup.runs = 4;
  setup.drives = {{"a", "", 1, 20}};
  rows[0].findings.retries = 2;
  rows[0].findings.causes = "outrun+outrun";
  rows[3].findings.causes = "lock_lost";
  auto j = sweep_json(setup, rows);
  EXPECT_EQ(j["runs"], 4);
  EXPECT_EQ(j["started"], 3);
  EXPECT_EQ(j["latched"], 1);
  EXPECT_EQ(j["lock_time_s"]["min"], 1);
  EXPECT_EQ(j["lock_time_s"]["median"], 2);
  EXPECT_EQ(j["lock_time_s"]["max"], 3);
  EXPECT_EQ(j["peak_current_a"]["median"], 25);
  EXPECT_EQ(j["peak_over_limit"]["max"], 2);
  EXPECT_EQ(j["inside"]["first_try"], 2);
  EXPECT_EQ(j["inside"]["started_after_retries"], 1);
  EXPECT_EQ(j["inside"]["causes"]["outrun"], 2);
  EXPECT_EQ(j["inside"]["causes"]["lock_lost"], 1);
  EXPECT_EQ(j["inside"]["causes"]["too_weak"], 0);
  EXPECT_FALSE(passed(setup, rows));
  rows[3].outside = true;
  EXPECT_TRUE(passed(setup, rows)) << "outside, a latched fault is as it must be";
  setup.runs = 5;
  EXPECT_FALSE(passed(setup, rows)) << "one is missing";
  setup.runs = 4;
  rows[0].rtl = "state_o at clock 9";
  EXPECT_FALSE(passed(setup, rows)) << "the RTL differed";
}

}  // namespace
}  // namespace steplock
