#include "testbench/sweep/witness.hpp"

#include <algorithm>

#include "testbench/run/units.hpp"

namespace steplock {
namespace {

bool claims_lock(State s) { return s == State::kRun || s == State::kSlowDown; }

}  // namespace

Witness::Witness(const WitnessSettings& settings, Recorder* recorder)
    : pole_pairs_(settings.pole_pairs), recorder_(recorder), judge_(settings.advance_deg),
      start_(settings) {}

void Witness::changed(const plant::State& s, Watch was, Watch now, const DriveView& view,
                      double load_nm) {
  start_.look(s);
  if (now.state() != was.state()) entered(s, was.state(), now, view);
  if (!claims_lock(now.state())) judge_.released();
  if (now.step() != was.step() && claims_lock(now.state())) {
    judge_.commutated(s.electrical_angle, was.step(), now.step());
    start_.slipped(judge_.step_outs(), s.time);
  }
  if (recorder_) recorder_->changed(s, was, now, view, load_nm);
}

void Witness::sample(const plant::State& s, Watch w, const DriveView& view, double load_nm) {
  // Not at the recorder's samples: what is found does not depend on who writes it down.
  if (s.time >= start_.next_look()) {
    start_.look(s);
    start_.turn(s, rpm_of_steps(view.steps_per_second, pole_pairs_), view.duty);
  }
  if (recorder_ && s.time >= recorder_->next_sample()) recorder_->sample(s, w, view, load_nm);
}

double Witness::next_sample() const {
  return recorder_ ? std::min(start_.next_look(), recorder_->next_sample()) : start_.next_look();
}

void Witness::pins_changed(double time, const plant::Pins& pins) {
  if (recorder_) recorder_->pins_changed(time, pins);
}

void Witness::entered(const plant::State& s, State was, Watch now, const DriveView& view) {
  const State is = now.state();
  if (is == State::kRetryDelay || is == State::kFault) {
    start_.failed(claims_lock(was), is == State::kFault, s.time);
    start_.caused(s, claims_lock(was), was == State::kPullIn, rpm_of_steps(view.steps_per_second, pole_pairs_));
    start_.findings().reason = now.reason();
  }
  if (claims_lock(is) != claims_lock(was)) start_.claims(claims_lock(is), s.time);
}

}  // namespace steplock
