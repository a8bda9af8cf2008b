#include "testbench/sweep/sinusoidal_witness.hpp"

#include <algorithm>
#include <cmath>

namespace steplock::sinusoidal {
namespace {

bool claims_lock(State s) { return s == State::kRun || s == State::kSlowDown; }

}  // namespace

void Witness::changed(const plant::State& s, Watch was, Watch now, const View& view,
                      double load_nm) {
  start_.look(s);
  if (now.state() != was.state()) entered(s, was.state(), now, view);
  if (now.sample() && !was.sample()) {
    const auto error = error_.at_sample(s, view);
    const bool lost = error && std::abs(*error) > kLostDeg && claims_lock(now.state());
    if (lost && !lost_) start_.slipped(start_.findings().slips + 1, s.time);
    lost_ = lost;
  }
  if (recorder_) recorder_->changed(s, was, now, view, load_nm);
}

void Witness::sample(const plant::State& s, Watch w, const View& view, double load_nm) {
  // Not at the recorder's samples: what is found does not depend on who writes it down.
  if (s.time >= start_.next_look()) {
    start_.look(s);
    start_.turn(s, way_ * view.speed_rpm);
  }
  if (recorder_ && s.time >= recorder_->next_sample()) recorder_->sample(s, w, view, load_nm);
}

double Witness::next_sample() const {
  return recorder_ ? std::min(start_.next_look(), recorder_->next_sample()) : start_.next_look();
}

void Witness::entered(const plant::State& s, State was, Watch now, const View& view) {
  const State is = now.state();
  if (is == State::kRetryDelay || is == State::kFault) {
    start_.failed(claims_lock(was), is == State::kFault, s.time);
    start_.caused(s, claims_lock(was), false, way_ * view.speed_rpm);
    start_.findings().sinusoidal_reason = now.reason();
  }
  if (claims_lock(is) != claims_lock(was)) start_.claims(claims_lock(is), s.time);
}

}  // namespace steplock::sinusoidal
