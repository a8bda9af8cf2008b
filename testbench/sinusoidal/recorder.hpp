// Collects what a sinusoidal run leaves behind.  The estimate is judged from outside: at each sample the
// true angle of the N pole less the drive's theta_c for that instant, delta theta.
//
// Totals run from the start, so that a mean over any span is a difference of two samples.
//
// Test: tests/testbench/sinusoidal_run_test.cpp
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "testbench/sinusoidal/watch.hpp"

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

struct Record {
  std::vector<Sample> overview;      // equally spaced
  std::vector<StateChange> changes;
  double peak_current = 0;           // A, any phase, at gate edges
  double least_angle_rad = 0, greatest_angle_rad = 0;  // mechanical, over the run
  std::uint64_t shoot_throughs = 0, clocks = 0;
  double simulated_s = 0, wall_s = 0, cpu_s = 0, energy_residual = 0;
  bool interrupted = false;
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

class Recorder {
 public:
  Recorder(double duration_s, std::size_t samples);

  void changed(const plant::State&, Watch was, Watch now, const View&, double load_nm);
  void sample(const plant::State&, Watch, const View&, double load_nm);
  double next_sample() const { return next_sample_; }
  bool tracing() const { return true; }  // wants the strobes
  void pins_changed(double, const plant::Pins&) {}

  const Totals& totals() const { return totals_; }
  double delta_theta_deg() const { return delta_deg_; }
  Record take() { return std::move(record_); }

 private:
  void integrate(const plant::State&);

  double interval_, next_sample_ = 0;
  Record record_;
  Totals totals_;
  double last_time_ = 0;
  std::array<double, 3> last_current_ = {};
  AngleError error_;
  double delta_deg_ = 0;
};

// The N pole from winding u, electrical degrees, in [0, 360).
double north_pole_deg(const plant::State&);

}  // namespace steplock::sinusoidal
