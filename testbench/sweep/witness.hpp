// Watches one run of a six-step drive from outside, by the rotor's true angle, and says when its
// outcome is clear (start_judge.hpp).  A slip is a commutation that was a step or more from its place
// while the drive claimed a lock (run/judge.hpp).
//
// It stands where a Recorder stands in the co-simulation, and passes everything on to one if there is
// one; that changes no number of its own.
//
// Doc: docs/sweep.md   Test: tests/testbench/witness_test.cpp
#pragma once

#include "testbench/drive/six_step/recorder.hpp"
#include "testbench/sweep/start_judge.hpp"

namespace steplock {

class Witness {
 public:
  explicit Witness(const WitnessSettings&, Recorder* recorder = nullptr);

  // As a Recorder's.
  void changed(const plant::State&, Watch was, Watch now, const DriveView&, double load_nm);
  void sample(const plant::State&, Watch, const DriveView&, double load_nm);
  double next_sample() const;
  bool tracing() const { return recorder_ != nullptr && recorder_->tracing(); }
  void pins_changed(double time, const plant::Pins&);

  bool decided() const { return start_.decided(); }
  const Findings& findings() const { return start_.findings(); }

 private:
  void entered(const plant::State&, State was, Watch now, const DriveView&);

  int pole_pairs_;
  Recorder* recorder_;
  Judge judge_;
  StartJudge start_;
};

}  // namespace steplock
