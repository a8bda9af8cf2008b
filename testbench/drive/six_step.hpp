// The facts of the six-step drive (drive.hpp).
//
// Test: tests/testbench/drive_test.cpp
#pragma once

#include <filesystem>

#include "testbench/compare/shadow.hpp"
#include "testbench/drive/six_step/recorder.hpp"
#include "testbench/drive/six_step/report.hpp"
#include "testbench/range/range.hpp"
#include "testbench/run/check.hpp"
#include "testbench/sweep/drawn_run.hpp"
#include "testbench/sweep/sweep.hpp"

namespace steplock {

struct SixStepDrive {
  using Record = steplock::Record;
  using Summary = steplock::Summary;
  static constexpr bool kHardships = true;  // the sweep's hard matrix serves it

  static void check(const DriveFile&, EngineKind) {}
  static Record run(const design::Settings& s, const RunOptions& options) { return run_drive(s, options); }
  static Summary summarise(const design::Settings& s, const RunOptions& options, const Record& record) {
    return steplock::summarise(s, options, record);
  }
  static ReportFiles report(const std::filesystem::path& directory, const design::Settings& s,
                            const Summary& summary, const Record& record, bool traced) {
    return write_report(directory, s, summary, record, traced);
  }
  static FloatErrors shadow(const design::Settings& s, const Summary& summary,
                            const std::function<bool(double done)>& progress,
                            const std::optional<design::Parameters>& reference = {}) {
    return shadow_errors(s, summary, progress, reference);
  }
  static const WaveTable& wave() { return SixStepRecording::wave(); }
  static RangePlan range() { return six_step_range(); }
  static bool meets(Trouble) { return true; }
  static DrawnResult simulate(const DrawnRun& run, const SimulateOptions& options) { return steplock::simulate(run, options); }
  static SweepEnd disturb(const SweepSetup& setup, const std::vector<DriveFile>& files, const SweepOptions& options,
                          const std::filesystem::path& folder) {
    return sweep(setup, files, options, folder);
  }
  static void record_into(SimulateOptions& options, Record& record) { options.record = &record; }
};

}  // namespace steplock
