// What a sinusoidal run leaves behind, and how it is recorded.  The estimate is judged from outside: at each
// sample the true angle of the N pole less the drive's theta_c for that instant, delta theta.
//
// Totals run from the start, so that a mean over any span is a difference of two samples.
//
// Test: tests/testbench/sinusoidal_run_test.cpp
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "testbench/run/recorder_of.hpp"
#include "testbench/run/simulated.hpp"
#include "testbench/drive/sinusoidal/watch.hpp"

namespace steplock::sinusoidal {

struct Totals {
  double current_squared = 0;                 // A^2 s, mean of the three phases
  double angle_deg = 0, angle_squared = 0;    // sums of delta theta over samples, electrical degrees
  std::uint64_t angles = 0;
};

struct Sample {
  double time = 0;
  plant::State plant;
  View drive;
  Watch watch;
  double load_nm = 0;
  double delta_theta_deg = 0;  // of the last sample judged
  Totals totals;
};

struct StateChange {
  double time = 0;
  State state = State::kIdle;
  Reason reason = Reason::kNone;
  double angle_deg = 0;      // the rotor's, electrical, of its N pole
  double mechanical_rad = 0;
  View drive;
};

struct Record : Simulated {
  std::vector<Sample> overview;      // equally spaced
  std::vector<Sample> lock;          // fine, from the estimator's start to a little after lock
  std::vector<Sample> steady;        // fine, the last turns before the first disturbance
  std::vector<StateChange> changes;
  double least_angle_rad = 0, greatest_angle_rad = 0;  // mechanical, over the run
};

// Delta theta at each sample: the true angle there less the drive's theta_c for that instant, which it
// shows only when it has worked the sample through.
class AngleError {
 public:
  // At the strobe of a sample; `view` still is the one of the sample before, and so is the result, in
  // electrical degrees, -180 to 180.  Nothing while the drive does not estimate.
  std::optional<double> at_sample(const plant::State&, const View& view);

 private:
  double sampled_deg_ = 0;
  bool sampled_ = false;
};

// What the recorder follows beside plant and drive (run/recorder_of.hpp).
class Recording {
 public:
  using Sample = sinusoidal::Sample;
  using StateChange = sinusoidal::StateChange;
  using Record = sinusoidal::Record;
  using Totals = sinusoidal::Totals;
  using Watch = sinusoidal::Watch;
  using View = sinusoidal::View;

  static constexpr bool kWantsStrobes = true;
  static const WaveTable& wave();

  explicit Recording(const RecorderSettings&) {}

  static bool begins_lock(Watch w) { return w.state() == State::kStarting; }
  static bool ends_lock(Watch w) { return w.state() == State::kRun; }
  void change(StateChange&, const plant::State&, const View&) const;
  void pass(const plant::State&, Record&) const;
  void follow(const plant::State&, Watch was, Watch now, const View&, Totals&);
  void fill(Sample& s) const { s.delta_theta_deg = delta_deg_; }
  void finish(Record&) const {}

  void trace_logic(TraceWriter&, const Sample&) const;
  void trace_analog(TraceWriter&, const Sample&) const;

  double delta_theta_deg() const { return delta_deg_; }

 private:
  AngleError error_;
  double delta_deg_ = 0;
};

}  // namespace steplock::sinusoidal

namespace steplock {
extern template class RecorderOf<sinusoidal::Recording>;
}

namespace steplock::sinusoidal {

class Recorder : public RecorderOf<Recording> {
 public:
  using RecorderOf::RecorderOf;
  double delta_theta_deg() const { return drive().delta_theta_deg(); }
};

// The N pole from winding u, electrical degrees, in [0, 360).
double north_pole_deg(const plant::State&);
// The phase currents in the rotor's own frame, d along the N pole; A, as the peak of a phase, so that they
// stand beside the drive's i_gamma and i_delta.
struct RotorCurrent {
  double d = 0, q = 0;
};
RotorCurrent rotor_current(const plant::State&);

}  // namespace steplock::sinusoidal
