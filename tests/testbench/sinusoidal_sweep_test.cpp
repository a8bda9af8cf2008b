// Sweeps of sinusoidal drives: what is drawn, rows and setup, shards, resumption, replay, the RTL beside,
// and the outcomes of drives that cannot work.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "model/design/sinusoidal/design.hpp"
#include "testbench/run/check.hpp"
#include "testbench/report/report.hpp"
#include "testbench/sweep/drawn_run.hpp"
#include "testbench/sweep_page/statistics.hpp"
#include "testbench/sweep/sweep.hpp"

namespace steplock {
namespace {

namespace fs = std::filesystem;

DriveFile servo() { return open_drive_file(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml"); }

// A servo motor on little more than half its clock within what it starts under at the first try: half a second a run.
std::vector<DriveFile> easy_drive() {
  DriveFile file = servo();
  design::Settings& s = file.settings;
  s.control.clock_hz = 14e6;
  design::EnvelopeSection& e = s.envelope;
  e.load = {0};
  e.fan = 0.1;
  e.inertia = {0.8, 1.2};
  e.resistance = {0.9, 1.05};
  return {file};
}

fs::path fresh(const std::string& name) {
  const fs::path path = fs::path(testing::TempDir()) / ("steplock_sinusoidal_sweep_" + name);
  fs::remove_all(path);
  return path;
}

std::string text(const fs::path& path) {
  std::ostringstream all;
  all << std::ifstream(path, std::ios::binary).rdbuf();
  return all.str();
}

std::string message(const std::function<void()>& f) {
  try {
    f();
  } catch (const BadInput& e) {
    return e.what();
  }
  return "";
}

// Which of the quantities lie outside the envelope.
std::set<std::string> outside(const design::Settings& s, const Conditions& c) {
  const design::EnvelopeSection& e = s.envelope;
  std::set<std::string> names;
  const auto need = [&](double x, const std::array<double, 2>& r, const char* name) {
    if (x < r[0] || x > r[1]) names.insert(name);
  };
  need(c.inertia, e.inertia, "inertia");
  need(c.bus, e.bus, "bus");
  need(c.resistance, e.resistance, "resistance");
  need(c.inductance, e.inductance, "inductance");
  need(c.flux, e.flux, "flux");
  need(c.speed, e.spinning == 0 ? std::array{0.0, 0.0} : e.speed, "speed");
  need(c.noise_a / s.adc.current_noise_a, e.noise, "noise");
  const double most = e.offset[1] * 0.01 * design::sinusoidal::current_range(s);
  for (const double o : {c.offset_u_a, c.offset_v_a, c.offset_w_a}) need(o, {-most, most}, "offset");
  const bool dry = std::ranges::find(e.load, c.load) != e.load.end();
  if (!dry || (c.fan != 0 && (c.fan != e.fan || c.load != 0))) names.insert("load");
  return names;
}

TEST(SinusoidalConditions, LieInTheEnvelopeOfEveryDriveAndOutsideLeaveItByOneQuantity) {
  int files = 0;
  for (const auto& entry : fs::directory_iterator(STEPLOCK_DRIVES)) {
    if (entry.path().extension() != ".toml") continue;
    const design::Settings s = open_drive_file(entry.path().string()).settings;
    if (s.drive.kind != design::DriveKind::kSinusoidal) continue;
    ++files;
    std::set<std::string> seen;
    for (std::uint64_t k = 0; k < 2000; ++k) {
      const auto inside = outside(s, draw_conditions(s, run_seed({.seed = 3}, k)));
      ASSERT_TRUE(inside.empty()) << entry.path() << ": " << *inside.begin();
      const auto left = outside(s, draw_conditions(s, run_seed({.seed = 3, .outside = 1}, k)));
      ASSERT_LE(left.size(), 1u);  // none: an offset is drawn from a wider range, and may lie in the narrower
      seen.insert(left.begin(), left.end());
    }
    EXPECT_EQ(seen, (std::set<std::string>{"inertia", "bus", "resistance", "inductance", "flux", "load", "offset",
                                           "noise"})) << entry.path();
  }
  EXPECT_GE(files, 4);
}

TEST(SinusoidalConditions, ThePlantAndItsConvertersAreDrawnAndTheDriveDoesNotKnow) {
  const design::Settings s = open_drive_file(STEPLOCK_DRIVES "/ipm_2k2.toml").settings;
  const RunSeed seed = run_seed({.seed = 5}, 7);
  const Conditions c = draw_conditions(s, seed);
  const DrawnRun run = drawn_run(s, seed);
  const plant::Parameters p = plant_parameters(run.settings);
  EXPECT_DOUBLE_EQ(p.motor.inductance_d, *s.motor.inductance_d_h * c.inductance);
  EXPECT_DOUBLE_EQ(p.motor.inductance_q, *s.motor.inductance_q_h * c.inductance);
  EXPECT_DOUBLE_EQ(p.motor.resistance, s.motor.resistance_ohm * c.resistance);
  EXPECT_DOUBLE_EQ(p.bus.voltage, s.inverter.bus_v * c.bus);
  const double rated = design::sinusoidal::design_drive(s).rated_torque;
  EXPECT_DOUBLE_EQ(p.load.opposing_torque, s.load.opposing_nm + c.load * rated);
  const plant::AdcParameters a = adc_parameters(run.settings), file = adc_parameters(s);
  EXPECT_EQ(a.current_range, file.current_range);
  EXPECT_EQ(a.voltage_range, file.voltage_range);
  EXPECT_EQ(a.current_offset[1], c.offset_v_a);
  EXPECT_NE(a.current_offset[0], 0);
  EXPECT_EQ(a.current_noise, c.noise_a);
  EXPECT_EQ(run.file.motor.resistance_ohm, s.motor.resistance_ohm);
  EXPECT_TRUE(plant::validate(p).empty());
}

TEST(SinusoidalRow, IsTheSameTextAfterReadingAndHasItsOwnColumns) {
  const Table table(Matrix::kStart, design::DriveKind::kSinusoidal);
  Row row{.index = 4, .drive = "servo", .seed = 88, .rtl = "equal", .conditions = {}, .findings = {},
          .disturbance = {}, .after = {}, .kind = design::DriveKind::kSinusoidal};
  row.conditions.offset_v_a = -0.0125;
  row.findings.sinusoidal_reason = sinusoidal::Reason::kNoPolarity;
  const std::string line = csv_line(row);
  const Row again = parse_csv_line(table, line, "x", 1);
  EXPECT_EQ(csv_line(again), line);
  EXPECT_EQ(again.conditions.offset_v_a, -0.0125);
  EXPECT_STREQ(start_reason(again), "no_polarity");
  EXPECT_NE(csv_header(table).find(",flux,offset_u_a,offset_v_a,offset_w_a,noise_a,speed,rtl"), std::string::npos);
  // As published for six-step drives.
  EXPECT_EQ(csv_header(Matrix::kStart),
            "index,drive,seed,outside,outcome,reason,lock_time_s,speed_time_s,kick_deg,peak_current_a,peak_speed,causes,beyond,"
            "retries,lost_locks,slips,end_s,angle_deg,load,fan,inertia,bus,resistance,inductance,flux,offset_u_v,offset_v_v,"
            "offset_w_v,noise_v,delay_s,speed,rtl");
}

TEST(SinusoidalSetup, IsOfOneKindOfDriveAndSaysWhich) {
  const DriveFile six_step = open_drive_file(STEPLOCK_TESTS "/short.toml");
  EXPECT_NE(message([&] { sweep_setup({}, 1, {six_step, servo()}); }).find("sweep each kind by itself"),
            std::string::npos);
  const SweepSetup mine = sweep_setup({}, 1, {servo()}), other = sweep_setup({}, 1, {six_step});
  EXPECT_EQ(setup_text(other).find("drive_kind"), std::string::npos) << "old folders go on";
  EXPECT_NE(message([&] { check_same_sweep(mine, other, "there"); }).find("the drives are of the other kind"),
            std::string::npos);
  const fs::path path = fresh("setup.json");
  std::ofstream(path) << setup_text(mine);
  EXPECT_EQ(read_setup(path.string()).drive_kind, design::DriveKind::kSinusoidal);
  const std::string both[] = {STEPLOCK_TESTS "/short.toml", servo().path};
  EXPECT_EQ(kind_among({both[0], both[1]}), design::DriveKind::kSixStep);
  EXPECT_EQ(kind_among({both[1]}), design::DriveKind::kSinusoidal);
  EXPECT_EQ(open_files_of(design::DriveKind::kSinusoidal, {both[0], both[1]}, "it").size(), 1u);
}

TEST(SinusoidalEnvelope, RefusesTheKeysOfComparators) {
  const std::string head = "[drive]\nname = \"x\"\nsource = \"y\"\nkind = \"sinusoidal\"\n[envelope]\n";
  EXPECT_NE(message([&] { parse_drive_file(head + "delay = [0, 1]\n", "x.toml"); })
                .find("x.toml:6: envelope.delay is not for drive.kind = \"sinusoidal\""), std::string::npos);
}

// In one go; the same in two shards, merged; and stopped after the first run and resumed.
TEST(SinusoidalSweep, ShardsMergedAndResumedAreTheWholeByteForByte) {
  constexpr std::uint64_t kRuns = 3;
  const std::vector<DriveFile> files = easy_drive();
  const SweepSetup setup = sweep_setup({.seed = 5, .rtl = 0}, kRuns, files);
  const auto run = [&](const fs::path& folder, const SweepOptions& options) {
    const SweepEnd end = sweep(setup, files, options, folder);
    write_file(folder / "sweep.json", sweep_json(setup, end.rows).dump(2));
    return end;
  };
  const fs::path whole = fresh("whole"), a = fresh("a"), b = fresh("b"), merged = fresh("merged");
  const SweepEnd end = run(whole, {.jobs = 2});
  ASSERT_EQ(end.rows.size(), kRuns);
  EXPECT_TRUE(passed(setup, end.rows)) << text(whole / "runs.csv");

  EXPECT_TRUE(run(a, {.jobs = 1, .progress = [](auto done, auto) { return done < 1; }}).interrupted);
  EXPECT_LT(run(a, {.jobs = 2, .resume = true}).done, kRuns);
  run(b, {.shard = {0, 2}, .jobs = 1});
  SweepSetup together;
  merge_sweeps({b, a}, merged, together);
  for (const char* name : {"runs.csv", "setup.json"}) {
    EXPECT_EQ(text(whole / name), text(a / name)) << name;
    EXPECT_EQ(text(whole / name), text(merged / name)) << name;
  }

  // A run alone is its line, with everything written down too.
  const Row& row = end.rows[1];
  sinusoidal::Record record;
  Row watched = row;
  watched.findings = simulate(drawn_run(files[0].settings, {row.seed}),
                              {.sinusoidal_record = &record, .record_s = row.findings.end_s})
                         .findings;
  EXPECT_EQ(csv_line(watched), csv_line(row));
  EXPECT_GT(record.overview.size(), 100u);
}

TEST(SinusoidalSweep, TheRtlRepeatsARunAndAWrongBitInOneClockIsNoticed) {
  const design::Settings s = easy_drive()[0].settings;
  const RunSeed seed = run_seed({.seed = 5, .rtl = 1}, 0);
  const auto row = make_row(0, "servo", s, seed);
  EXPECT_EQ(row->rtl, "equal");
  DrawnRun run = drawn_run(s, seed);
  run.limit_s = 0.01;
  const DrawnResult result = simulate(run, {.rtl_beside = true, .spoil_clock = 30'000});
  EXPECT_FALSE(result.rtl_agrees);
  EXPECT_EQ(result.rtl_difference, "on_u_o at clock 30000");
}

// Negative controls of the outcomes.
TEST(SinusoidalSweep, ABlockedRotorEndsInTheLatchedFaultAndWithoutProtectionIsSilent) {
  design::Settings s = easy_drive()[0].settings;
  s.sinusoidal_start.retries = 0;
  DrawnRun run = drawn_run(s, run_seed({.seed = 5}, 0));
  run.settings.load.opposing_nm = 10;
  const DrawnResult latched = simulate(run);
  EXPECT_EQ(latched.findings.outcome, Outcome::kLatched);
  EXPECT_NE(latched.findings.sinusoidal_reason, sinusoidal::Reason::kNone);
  run.file.sinusoidal_protection.saturated_s = run.file.sinusoidal_protection.slow_s =
      run.file.sinusoidal_protection.emf_s = 0;
  run.file.sinusoidal_start.lock_rpm = 1;
  // The drive believes a third of the resistance: the rest of the voltage is a speed to it.
  run.file.motor.resistance_ohm /= 3;
  EXPECT_EQ(simulate(run).findings.outcome, Outcome::kSilentStepOut);
}

}  // namespace
}  // namespace steplock
