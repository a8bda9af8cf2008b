// Collects a Record while the co-simulation runs, of either drive.  Light by design: it is called when
// gates, step or state change and at sample times, never per clock.
//
// Phase currents are taken as straight lines between calls; calls come at every gate edge, where the
// current of a chopped motor has its corners and its peaks.
//
// What a drive has of its own says its `Recording` (recorder.hpp, sinusoidal/recorder.hpp):
//
//     types  Sample, StateChange, Record, Watch, View
//     bool   kWantsStrobes                    strobes alone are worth a call
//     bool   begins_lock(Watch), ends_lock(Watch)   the fine window of the start: its first and its last state
//     void   follow(plant, was, now, view, Totals&)  the judge; fill(Sample&): what it last found
//     void   change(StateChange&, plant, view), finish(Record&)
//     void   trace_logic(TraceWriter&, Sample), trace_analog(TraceWriter&, Sample)
//
// Doc: docs/report.md   Test: tests/testbench/run_drive_test.cpp
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "testbench/run/trace_writer.hpp"

namespace steplock {

struct RecorderSettings {
  double advance_deg = 0;         // of the drive, for the judge
  double electrical_turn_s = 0;   // at set speed; 0: no fine windows
  double steady_end_s = 0;        // the steady window is the two turns before this
  double duration_s = 0;
  double pwm_s = 0;
  std::size_t overview_samples = 6000;
};

template <class Recording>
class RecorderOf {
 public:
  using Record = typename Recording::Record;
  using Sample = typename Recording::Sample;
  using Watch = typename Recording::Watch;
  using View = typename Recording::View;

  explicit RecorderOf(const RecorderSettings& settings, TraceWriter* trace = nullptr)
      : settings_(settings), trace_(trace), drive_(settings), lock_interval_(settings.pwm_s / kFinePerPwmPeriod) {}

  // The watched word became `now` at this instant.
  void changed(const plant::State& s, Watch was, Watch now, const View& view, double load_nm) {
    integrate(s);
    if (now.state() != was.state() || now.reason() != was.reason()) {
      typename Recording::StateChange change;
      change.time = s.time;
      change.state = now.state();
      change.reason = now.reason();
      drive_.change(change, s, view);
      record_.changes.push_back(change);
      if (fine() && Recording::begins_lock(now) && record_.lock.empty()) {
        in_lock_window_ = true;
        lock_window_end_ = std::numeric_limits<double>::infinity();
        plan_next(s.time);
      }
      if (Recording::ends_lock(now) && in_lock_window_) {
        lock_window_end_ = s.time + kSteadyTurns * settings_.electrical_turn_s;
      }
    }
    drive_.follow(s, was, now, view, totals_);
    if (trace_) drive_.trace_logic(*trace_, make(s, now, view, load_nm));
  }
  // It is next_sample() or later.
  void sample(const plant::State& s, Watch w, const View& view, double load_nm) {
    integrate(s);
    const Sample taken = make(s, w, view, load_nm);
    if (s.time >= next_overview_) {
      record_.overview.push_back(taken);
      next_overview_ += settings_.duration_s / static_cast<double>(settings_.overview_samples);
    }
    if (in_lock_window_) {
      record_.lock.push_back(taken);
      in_lock_window_ = s.time < lock_window_end_;
      if (record_.lock.size() == kWindowSamples) coarsen_lock_window();
    }
    if (fine() && s.time >= steady_from() && s.time <= settings_.steady_end_s) record_.steady.push_back(taken);
    if (trace_) drive_.trace_analog(*trace_, taken);
    plan_next(s.time);
  }
  double next_sample() const { return next_sample_; }

  bool tracing() const { return Recording::kWantsStrobes || trace_ != nullptr; }
  void pins_changed(double time, const plant::Pins& pins) {
    if (trace_) trace_->pins(time, pins);
  }

  const Recording& drive() const { return drive_; }
  const typename Recording::Totals& totals() const { return totals_; }
  Record take() {  // ends the recording
    drive_.finish(record_);
    return std::move(record_);
  }

 private:
  // Samples of a fine window; beyond, a figure gains nothing.
  static constexpr std::size_t kWindowSamples = 12000;
  static constexpr double kFinePerPwmPeriod = 24;
  static constexpr double kTracedPerPwmPeriod = 8;
  static constexpr double kSteadyTurns = 2;

  bool fine() const { return settings_.electrical_turn_s > 0; }
  double steady_from() const { return settings_.steady_end_s - kSteadyTurns * settings_.electrical_turn_s; }

  void integrate(const plant::State& s) {
    double squares = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = last_current_[k], b = s.current[k];
      squares += (a * a + a * b + b * b) / 3;  // mean square of a straight line
      record_.peak_current = std::max(record_.peak_current, std::abs(b));
    }
    totals_.current_squared += (s.time - last_time_) * squares / 3;
    last_time_ = s.time;
    last_current_ = s.current;
    drive_.pass(s, record_);
  }
  Sample make(const plant::State& s, Watch w, const View& v, double load_nm) const {
    Sample made{.time = s.time, .plant = s, .drive = v, .watch = w, .load_nm = load_nm, .totals = totals_};
    drive_.fill(made);
    return made;
  }
  // Nobody knows how long the lock will take: a full window gives up every other sample.
  void coarsen_lock_window() {
    for (std::size_t i = 0; i < kWindowSamples / 2; ++i) record_.lock[i] = record_.lock[2 * i];
    record_.lock.resize(kWindowSamples / 2);
    lock_interval_ *= 2;
  }
  void plan_next(double now) {
    next_sample_ = next_overview_;
    if (in_lock_window_) next_sample_ = std::min(next_sample_, now + lock_interval_);
    if (trace_) next_sample_ = std::min(next_sample_, now + settings_.pwm_s / kTracedPerPwmPeriod);
    if (!fine()) return;
    if (now < steady_from()) {
      next_sample_ = std::min(next_sample_, steady_from());
    } else if (now < settings_.steady_end_s) {
      const double span = kSteadyTurns * settings_.electrical_turn_s;
      const double step = std::max(settings_.pwm_s / kFinePerPwmPeriod, span / static_cast<double>(kWindowSamples));
      next_sample_ = std::min(next_sample_, now + step);
    }
  }

  RecorderSettings settings_;
  TraceWriter* trace_;
  Recording drive_;
  Record record_;
  typename Recording::Totals totals_;
  std::array<double, 3> last_current_ = {};
  double last_time_ = 0, next_sample_ = 0, next_overview_ = 0;
  bool in_lock_window_ = false;
  double lock_window_end_ = 0, lock_interval_;
};

}  // namespace steplock
