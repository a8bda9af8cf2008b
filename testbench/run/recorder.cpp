#include "testbench/run/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "testbench/run/trace_writer.hpp"

namespace steplock {
namespace {

// Samples of a fine window; beyond, a figure gains nothing.
constexpr std::size_t kWindowSamples = 12000;
constexpr double kFinePerPwmPeriod = 24;
constexpr double kTracedPerPwmPeriod = 8;
constexpr double kSteadyTurns = 2;

bool claims_lock(Watch w) { return w.state() == State::kRun || w.state() == State::kSlowDown; }

}  // namespace

Recorder::Recorder(const RecorderSettings& settings, TraceWriter* trace)
    : settings_(settings), trace_(trace), judge_(settings.advance_deg),
      lock_interval_(settings.pwm_s / kFinePerPwmPeriod) {}

void Recorder::integrate(const plant::State& s) {
  const double dt = s.time - last_time_;
  double squares = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = last_current_[k], b = s.current[k];
    squares += (a * a + a * b + b * b) / 3;  // mean square of a straight line
    record_.peak_current = std::max(record_.peak_current, std::abs(b));
  }
  totals_.current_squared += dt * squares / 3;
  last_time_ = s.time;
  last_current_ = s.current;
}

Sample Recorder::make(const plant::State& s, Watch w, const DriveView& v, double load_nm) const {
  return {.time = s.time, .plant = s, .drive = v, .watch = w, .load_nm = load_nm,
          .commutation_error_deg = judge_.last_deg(), .totals = totals_};
}

void Recorder::changed(const plant::State& s, Watch was, Watch now, const DriveView& view,
                       double load_nm) {
  integrate(s);
  if (now.state() != was.state() || now.reason() != was.reason()) {
    record_.changes.push_back({s.time, now.state(), now.reason()});
    if (now.state() == State::kPullIn && record_.lock.empty()) {
      in_lock_window_ = true;
      lock_window_end_ = std::numeric_limits<double>::infinity();
      plan_next(s.time);
    }
    if (now.state() == State::kRun && in_lock_window_) {
      lock_window_end_ = s.time + kSteadyTurns * settings_.electrical_turn_s;
    }
  }
  if (!claims_lock(now)) judge_.released();
  if (now.step() != was.step() && claims_lock(now)) {
    judge_.commutated(s.electrical_angle, was.step(), now.step());
    totals_.commutation_deg = judge_.sum();
    totals_.commutation_squared = judge_.sum_of_squares();
    totals_.commutations = judge_.commutations();
    totals_.phase_error_squared += view.phase_error_deg * view.phase_error_deg;
  }
  if (trace_) trace_->logic(make(s, now, view, load_nm));
}

void Recorder::sample(const plant::State& s, Watch w, const DriveView& view, double load_nm) {
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
  const double steady_from = settings_.steady_end_s - kSteadyTurns * settings_.electrical_turn_s;
  if (s.time >= steady_from && s.time <= settings_.steady_end_s) record_.steady.push_back(taken);
  if (trace_) trace_->analog(taken);
  plan_next(s.time);
}

// Nobody knows how long the pull-in will take: a full window gives up every other sample.
void Recorder::coarsen_lock_window() {
  for (std::size_t i = 0; i < kWindowSamples / 2; ++i) record_.lock[i] = record_.lock[2 * i];
  record_.lock.resize(kWindowSamples / 2);
  lock_interval_ *= 2;
}

void Recorder::plan_next(double now) {
  const double fine = settings_.pwm_s / kFinePerPwmPeriod;
  const double span = kSteadyTurns * settings_.electrical_turn_s;
  const double steady_from = settings_.steady_end_s - span;
  next_sample_ = next_overview_;
  if (in_lock_window_) next_sample_ = std::min(next_sample_, now + lock_interval_);
  if (trace_) next_sample_ = std::min(next_sample_, now + settings_.pwm_s / kTracedPerPwmPeriod);
  if (now < steady_from) {
    next_sample_ = std::min(next_sample_, steady_from);
  } else if (now < settings_.steady_end_s) {
    const double step = std::max(fine, span / static_cast<double>(kWindowSamples));
    next_sample_ = std::min(next_sample_, now + step);
  }
}

void Recorder::pins_changed(double time, const plant::Pins& pins) {
  if (trace_) trace_->logic(time, pins);
}

Record Recorder::take() {
  record_.step_outs = judge_.step_outs();
  return std::move(record_);
}

}  // namespace steplock
