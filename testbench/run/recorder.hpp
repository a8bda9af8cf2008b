// Collects a Record while the co-simulation runs.  Light by design: it is called when gates, step
// or state change and at sample times, never per clock.
//
// Phase currents are taken as straight lines between calls; calls come at every gate edge, where the
// current of a chopped motor has its corners and its peaks.
//
// Doc: docs/report.md   Test: tests/testbench/run_drive_test.cpp
#pragma once

#include "testbench/run/judge.hpp"
#include "testbench/run/record.hpp"

namespace steplock {

class TraceWriter;

struct RecorderSettings {
  double advance_deg = 0;         // of the drive, for the judge
  double electrical_turn_s = 0;   // at set speed
  double steady_end_s = 0;        // the steady window is the two turns before this
  double duration_s = 0;
  double pwm_s = 0;
  std::size_t overview_samples = 6000;
};

class Recorder {
 public:
  Recorder(const RecorderSettings&, TraceWriter* trace = nullptr);

  // The watched word became `now` at this instant.
  void changed(const plant::State&, Watch was, Watch now, const DriveView&, double load_nm);
  // It is next_sample() or later.
  void sample(const plant::State&, Watch, const DriveView&, double load_nm);
  double next_sample() const { return next_sample_; }

  bool tracing() const { return trace_ != nullptr; }
  void pins_changed(double time, const plant::Pins&);

  std::uint64_t step_outs() const { return judge_.step_outs(); }
  Record take();  // ends the recording

 private:
  void integrate(const plant::State&);
  Sample make(const plant::State&, Watch, const DriveView&, double load_nm) const;
  void coarsen_lock_window();
  void plan_next(double now);

  RecorderSettings settings_;
  TraceWriter* trace_;
  Judge judge_;
  Record record_;
  Totals totals_;
  double last_time_ = 0;
  std::array<double, 3> last_current_ = {};
  double next_sample_ = 0, next_overview_ = 0;
  bool in_lock_window_ = false;
  double lock_window_end_ = 0;
  double lock_interval_;
};

}  // namespace steplock
