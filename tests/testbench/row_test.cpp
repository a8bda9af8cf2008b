// A run as a line of text, and back.
#include "testbench/sweep/row.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock {
namespace {

Row sample_row() {
  Row row{.index = 41, .drive = "servo", .seed = kHardSeed - 3, .outside = true, .rtl = "equal",
          .conditions = {}, .findings = {}, .disturbance = {}, .hardship = {}, .after = {}};
  row.conditions.inertia = 1.0 / 3;
  row.conditions.offset_v_v = -0.0123456789;
  row.findings.outcome = Outcome::kSilentStepOut;
  row.findings.reason = Reason::kWrongLock;
  row.findings.lock_time_s = 0.25;
  row.findings.slips = 3;
  row.findings.beyond = "current+kick";
  return row;
}

std::string message(const std::function<void()>& f) {
  try {
    f();
  } catch (const BadInput& e) {
    return e.what();
  }
  return "";
}

TEST(Row, IsTheSameTextAfterReading) {
  const std::string text = csv_line(sample_row());
  EXPECT_EQ(csv_line(parse_csv_line(Matrix::kStart, text, "x", 1)), text);
  const Row row = parse_csv_line(Matrix::kStart, text, "x", 1);
  EXPECT_EQ(row.seed, kHardSeed - 3);
  EXPECT_EQ(row.findings.outcome, Outcome::kSilentStepOut);
  EXPECT_EQ(row.findings.reason, Reason::kWrongLock);
  EXPECT_FALSE(row.findings.kick_deg);
  EXPECT_EQ(row.findings.beyond, "current+kick");
  EXPECT_NEAR(row.conditions.inertia, 1.0 / 3, 1e-7);
}

TEST(Row, OfADisturbanceIsTheSameTextAfterReading) {
  Row row{.index = 3, .drive = "servo", .seed = 8 | 2, .rtl = "", .conditions = {}, .findings = {}, .disturbance = {},
          .hardship = {}, .after = {}};
  row.disturbance.kind = Trouble::kBusDip;
  row.disturbance.size = 0.3;
  row.after.outcome = After::kLatched;
  row.after.reason = Reason::kStall;
  row.after.fault_s = 1.5;
  row.findings.outcome = Outcome::kStarted;
  const std::string line = csv_line(row);
  const Row read = parse_csv_line(Matrix::kDisturb, line, "x", 1);
  EXPECT_EQ(csv_line(read), line);
  EXPECT_EQ(read.disturbance.kind, Trouble::kBusDip);
  EXPECT_EQ(read.after.outcome, After::kLatched);
  EXPECT_EQ(*read.after.fault_s, 1.5);
  EXPECT_FALSE(read.after.recovery_s);
  EXPECT_EQ(std::ranges::count(csv_header(Matrix::kDisturb), ','), std::ranges::count(line, ','));
}

TEST(Row, HasAsManyCellsAsTheHeader) {
  const std::string header = csv_header(Matrix::kStart), line = csv_line(sample_row());
  EXPECT_EQ(std::ranges::count(header, ','), std::ranges::count(line, ','));
}

TEST(Row, ABadCellIsRefusedWithItsLine) {
  std::string text = csv_line(sample_row());
  EXPECT_EQ(message([&] { parse_csv_line(Matrix::kStart, "x" + text, "runs.csv", 7); }).substr(0, 23),
            "runs.csv:7: index is \"x");
  EXPECT_NE(message([&] { parse_csv_line(Matrix::kStart, text + ",1", "runs.csv", 7); }), "");
  EXPECT_NE(message([&] { parse_csv_line(Matrix::kStart, "1,2", "runs.csv", 7); }), "");
}

TEST(Row, AHalfWrittenLastLineIsDropped) {
  const auto path = std::filesystem::path(testing::TempDir()) / "steplock_half.csv";
  const std::string line = csv_line(sample_row());
  std::ofstream(path) << csv_header(Matrix::kStart) << '\n' << line << '\n' << line.substr(0, 30);
  EXPECT_EQ(read_rows(path.string()).size(), 1u);
  std::ofstream(path) << "index,drive\n" << line << '\n';
  EXPECT_NE(message([&] { read_rows(path.string()); }).find(":1: these are not the columns"), std::string::npos);
}

}  // namespace
}  // namespace steplock
