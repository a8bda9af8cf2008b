// Watches one start of a sinusoidal drive from outside, by the rotor's true angle, and says when its
// outcome is clear (start_judge.hpp).  A slip is an estimate that comes to lie more than kLostDeg from
// the N pole while the drive claims a lock: from there the current of a wanted torque brakes.
//
// It stands where a Recorder stands in the co-simulation, and passes everything on to one if there is
// one; that changes no number of its own.
//
// Doc: docs/sweep.md   Test: tests/testbench/sinusoidal_sweep_test.cpp
#pragma once

#include "testbench/drive/sinusoidal/recorder.hpp"
#include "testbench/sweep/start_judge.hpp"

namespace steplock::sinusoidal {

class Witness {
 public:
  static constexpr double kLostDeg = 90;  // electrical

  explicit Witness(const WitnessSettings& settings, Recorder* recorder = nullptr)
      : way_(settings.set_rpm < 0 ? -1 : 1), recorder_(recorder), start_(settings) {}

  // As a Recorder's.
  void changed(const plant::State&, Watch was, Watch now, const View&, double load_nm);
  void sample(const plant::State&, Watch, const View&, double load_nm);
  double next_sample() const;
  bool tracing() const { return true; }  // wants the strobes
  void pins_changed(double, const plant::Pins&) {}

  bool decided() const { return start_.decided(); }
  const Findings& findings() const { return start_.findings(); }

 private:
  void entered(const plant::State&, State was, Watch now, const View&);

  double way_;  // +1, or -1 in reverse
  Recorder* recorder_;
  StartJudge start_;
  AngleError error_;
  bool lost_ = false;
};

}  // namespace steplock::sinusoidal
