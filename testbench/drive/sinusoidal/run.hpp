// One run of a sinusoidal drive: its scenario on the co-simulation that every engine shares, what it
// amounts to, and the files it leaves.
//
// Speeds are the plant's: the angle turned in a span, divided by the span.  The steady span is the
// last half between reaching set speed and the first disturbance.  A run passes if the drive locked,
// ended without fault, held its set speed within 0.5 %, was back within 2 % in the last fifth of the
// load step, and stood still at the end of a stop.
//
// Doc: docs/sinusoidal.md   Test: tests/testbench/sinusoidal_run_test.cpp
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "testbench/report/figure.hpp"
#include "testbench/report/report.hpp"
#include "testbench/run/drive_loop.hpp"
#include "testbench/run/float_errors.hpp"
#include "testbench/run/power.hpp"
#include "testbench/run/profile.hpp"
#include "testbench/run/ripple.hpp"
#include "testbench/drive/sinusoidal/float_engine.hpp"
#include "testbench/drive/sinusoidal/recorder.hpp"

namespace steplock::sinusoidal {

// Engine, plant and recorder of one run, for whoever wants to intervene on the way.
template <class Engine>
class BenchOf {
 public:
  // The drive is designed for `believed`; the plant is what `real` says.
  BenchOf(const design::Settings& believed, const design::Settings& real, const Timeline& events,
          double angle_deg, std::size_t samples = 4000)
      : timeline_(events),
        clock_hz_(believed.control.clock_hz),
        plant_(plant_parameters(real), initial_state(real, angle_deg)),
        engine_(believed, adc_parameters(believed)),
        recorder_({.duration_s = static_cast<double>(events.clocks) / clock_hz_, .overview_samples = samples}),
        simulation_(engine_, plant_, timeline_, recorder_, clock_hz_) {}
  BenchOf(const BenchOf&) = delete;

  void run_until(double seconds) {
    simulation_.run_until(static_cast<std::uint64_t>(seconds * clock_hz_));
  }
  double time() const { return static_cast<double>(simulation_.clock()) / clock_hz_; }
  plant::Plant& plant() { return plant_; }
  Engine& engine() { return engine_; }
  Recorder& recorder() { return recorder_; }
  Record take() {
    Record record = recorder_.take();
    conclude(record, simulation_, plant_, clock_hz_);
    return record;
  }

 private:
  Timeline timeline_;
  double clock_hz_;
  plant::Plant plant_;
  Engine engine_;
  Recorder recorder_;
  Cosimulation<Engine, Recorder> simulation_;
};
using Bench = BenchOf<FloatEngine>;

struct Result {
  std::string drive, engine, estimator, start_by;
  double angle_deg = 0;
  bool locked = false;
  std::optional<double> lock_time_s, speed_time_s;  // in lock; and within 1 % of the set speed
  double backward_deg = 0;               // electrical, farthest against the wanted direction
  std::optional<double> position_error_deg;  // of the pilot pulses, electrical
  std::string fault = "none";
  std::vector<std::string> reasons;      // of every try that failed
  double set_speed_rpm = 0, mean_rpm = 0, speed_error_percent = 0;
  Ripple ripple;                         // of true speed and torque, steady
  Power power;                           // steady
  std::optional<Power> loaded_power;     // in the last fifth of the load step
  double delta_theta_mean_deg = 0, delta_theta_rms_deg = 0, delta_theta_worst_deg = 0;  // steady
  double rms_current_a = 0, peak_current_a = 0, current_bound_a = 0;
  std::optional<double> load_step_nm, load_dip_percent, loaded_error_percent;
  std::optional<double> loaded_delta_theta_worst_deg;  // from the load step to the end of the load
  std::optional<double> stopped_rpm;     // at the end
  std::vector<Piece> profile;            // of the scenario's set speeds and loads
  std::uint64_t shoot_throughs = 0, clocks = 0;
  double simulated_s = 0, wall_s = 0, cpu_s = 0, energy_residual = 0;
  bool interrupted = false;
  std::optional<Lockstep> lockstep;      // rtl = fixed, if asked for
  std::optional<FloatErrors> float_errors;  // fixed against float, likewise
  std::vector<std::string> advice;       // what to change, where the cause can be told (advice.hpp)

  std::vector<std::string> failures() const;
};

Record run(const design::Settings&, const RunOptions&);
Result summarise(const design::Settings&, const RunOptions&, const Record&);
nlohmann::ordered_json to_json(const Result&);
std::string to_text(const Result&);
std::string samples_csv(const std::vector<Sample>&);
std::vector<Figure> figures(const design::Settings&, const Record&);
PageContent page_content(const design::Settings&, const Result&, const Record&);
ReportFiles write_report(const std::filesystem::path&, const design::Settings&, const Result&, const Record&,
                         bool traced);

}  // namespace steplock::sinusoidal
