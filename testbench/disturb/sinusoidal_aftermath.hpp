// Watches a disturbed run of a sinusoidal drive from outside: first its start, as any start (sweep/sinusoidal_witness.hpp), then
// what becomes of it after the disturbance (after_judge.hpp).  It is astray where its estimate lies more than Witness::kLostDeg from
// the N pole while it claims a lock.
//
// It stands where a Recorder stands in the co-simulation.
//
// Doc: docs/sweep.md   Test: tests/testbench/sinusoidal_disturbance_test.cpp
#pragma once

#include "testbench/disturb/after_judge.hpp"
#include "testbench/sweep/sinusoidal_witness.hpp"

namespace steplock::sinusoidal {

class Aftermath {
 public:
  explicit Aftermath(const WitnessSettings& settings, Recorder* recorder = nullptr)
      : way_(settings.set_rpm < 0 ? -1 : 1), start_(settings, recorder), judge_(settings) {}

  // As a Recorder's.
  void changed(const plant::State&, Watch was, Watch now, const View&, double load_nm);
  void sample(const plant::State&, Watch, const View&, double load_nm);
  double next_sample() const { return std::min(start_.next_sample(), judge_.next_look()); }
  bool tracing() const { return true; }  // wants the strobes
  void pins_changed(double, const plant::Pins&) {}

  bool start_decided() const { return start_.decided(); }
  const Findings& start() const { return start_.findings(); }
  void disturb(const Disturbed& d) { judge_.disturb(d); }
  bool decided() const { return judge_.decided(); }
  void time_is_over() { judge_.time_is_over(); }
  const AfterFindings& findings() const { return judge_.findings(); }
  Reason reason() const { return reason_; }  // of the latched fault, or of the last failed attempt

 private:
  double way_;  // +1, or -1 in reverse
  Witness start_;
  AfterJudge judge_;
  AngleError error_;
  bool astray_ = false;
  Reason reason_ = Reason::kNone;
};

}  // namespace steplock::sinusoidal
