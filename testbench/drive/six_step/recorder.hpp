// What the recorder of a six-step run follows beside plant and drive: the judge of commutations, and the
// signals of its wave.
//
// Doc: docs/report.md   Test: tests/testbench/run_drive_test.cpp, trace_writer_test.cpp
#pragma once

#include "testbench/drive/six_step/judge.hpp"
#include "testbench/drive/six_step/record.hpp"
#include "testbench/run/recorder_of.hpp"

namespace steplock {

class SixStepRecording {
 public:
  using Sample = steplock::Sample;
  using StateChange = steplock::StateChange;
  using Record = steplock::Record;
  using Totals = steplock::Totals;
  using Watch = steplock::Watch;
  using View = DriveView;

  static constexpr bool kWantsStrobes = false;
  static const WaveTable& wave();

  explicit SixStepRecording(const RecorderSettings& settings) : judge_(settings.advance_deg) {}

  static bool begins_lock(Watch w) { return w.state() == State::kPullIn; }
  static bool ends_lock(Watch w) { return w.state() == State::kRun; }
  void change(StateChange&, const plant::State&, const View&) const {}
  void pass(const plant::State&, Record&) const {}
  void follow(const plant::State& s, Watch was, Watch now, const View& view, Totals& totals) {
    const bool claims_lock = now.state() == State::kRun || now.state() == State::kSlowDown;
    if (!claims_lock) judge_.released();
    if (now.step() == was.step() || !claims_lock) return;
    judge_.commutated(s.electrical_angle, was.step(), now.step());
    totals.commutation_deg = judge_.sum();
    totals.commutation_squared = judge_.sum_of_squares();
    totals.commutations = judge_.commutations();
    totals.phase_error_squared += view.phase_error_deg * view.phase_error_deg;
  }
  void fill(Sample& s) const { s.commutation_error_deg = judge_.last_deg(); }
  void finish(Record& record) const { record.step_outs = judge_.step_outs(); }

  void trace_logic(TraceWriter&, const Sample&) const;
  void trace_analog(TraceWriter&, const Sample&) const;

  std::uint64_t step_outs() const { return judge_.step_outs(); }

 private:
  Judge judge_;
};

extern template class RecorderOf<SixStepRecording>;

class Recorder : public RecorderOf<SixStepRecording> {
 public:
  using RecorderOf::RecorderOf;
  std::uint64_t step_outs() const { return drive().step_outs(); }
};

}  // namespace steplock
