#include "testbench/disturb/sinusoidal_aftermath.hpp"

#include <cmath>

namespace steplock::sinusoidal {
namespace {

bool claims_lock(State s) { return s == State::kRun || s == State::kSlowDown; }

}  // namespace

void Aftermath::changed(const plant::State& s, Watch was, Watch now, const View& view, double load_nm) {
  start_.changed(s, was, now, view, load_nm);
  bool strays = astray_;
  if (now.sample() && !was.sample()) {
    const auto error = error_.at_sample(s, view);
    strays = error && std::abs(*error) > Witness::kLostDeg && claims_lock(now.state());
  }
  const bool first = strays && !astray_;
  astray_ = strays;
  if (!judge_.watches(s.time)) return;
  judge_.look(s);
  judge_.claims(claims_lock(now.state()));
  if (strays) judge_.strayed(first);
  if (now.state() == was.state()) return;
  if (now.state() == State::kRetryDelay || now.state() == State::kFault) {
    reason_ = now.reason();
    judge_.failed(claims_lock(was.state()), now.state() == State::kFault, s.time);
  }
}

void Aftermath::sample(const plant::State& s, Watch w, const View& view, double load_nm) {
  if (s.time >= start_.next_sample()) start_.sample(s, w, view, load_nm);
  if (s.time >= judge_.next_look() && judge_.watches(s.time)) {
    judge_.look(s);
    judge_.turn(s, way_ * view.speed_rpm, claims_lock(w.state()));
  }
}

}  // namespace steplock::sinusoidal
