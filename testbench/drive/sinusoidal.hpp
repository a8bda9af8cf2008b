// The facts of the sinusoidal drive (drive.hpp).
//
// Test: tests/testbench/drive_test.cpp
#pragma once

#include <filesystem>

#include "testbench/compare/estimator_shadow.hpp"
#include "testbench/disturb/disturbance_sweep.hpp"
#include "testbench/disturb/sinusoidal_disturbance.hpp"
#include "testbench/range/range.hpp"
#include "testbench/report/report.hpp"
#include "testbench/run/check.hpp"
#include "testbench/drive/sinusoidal/run.hpp"
#include "testbench/sweep/drawn_run.hpp"

namespace steplock {

struct SinusoidalDrive {
  using Record = sinusoidal::Record;
  using Summary = sinusoidal::Result;
  static constexpr bool kHardships = false;

  // The words may not hold what the reference in doubles can do.
  static void check(const DriveFile& file, EngineKind engine) {
    if (engine != EngineKind::kFloat) check_config(file);
  }
  static Record run(const design::Settings& s, const RunOptions& options) { return sinusoidal::run(s, options); }
  static Summary summarise(const design::Settings& s, const RunOptions& options, const Record& record) {
    return sinusoidal::summarise(s, options, record);
  }
  static ReportFiles report(const std::filesystem::path& directory, const design::Settings& s,
                            const Summary& summary, const Record& record, bool traced) {
    return sinusoidal::write_report(directory, s, summary, record, traced);
  }
  static FloatErrors shadow(const design::Settings& s, const Summary& summary,
                            const std::function<bool(double done)>& progress,
                            const std::optional<design::sinusoidal::Parameters>& reference = {}) {
    return sinusoidal::shadow_errors(s, summary, progress, reference);
  }
  static const WaveTable& wave() { return sinusoidal::Recording::wave(); }
  static RangePlan range() { return sinusoidal_range(); }
  static bool meets(Trouble kind) { return sinusoidal::meets(kind); }
  static DrawnResult simulate(const DrawnRun& run, const SimulateOptions& options) {
    return run.seed.disturbed() ? sinusoidal::simulate_disturbed(run, options) : steplock::simulate(run, options);
  }
  static SweepEnd disturb(const SweepSetup& setup, const std::vector<DriveFile>& files, const SweepOptions& options,
                          const std::filesystem::path& folder) {
    return sinusoidal::sweep_disturbances(setup, files, options, folder);
  }
  static void record_into(SimulateOptions& options, Record& record) { options.sinusoidal_record = &record; }
};

}  // namespace steplock
