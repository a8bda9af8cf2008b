// What a run amounts to, in the numbers people ask for.
//
// Speeds are the plant's: the angle turned in a span, divided by the span.  The steady span is the
// last half between reaching set speed (or lock, if it never is reached) and the first disturbance.
// A run passes if the drive locked, stayed in step and without fault, no phase carried more than its bound
// (model/design/bounds.hpp), held its set speed within 0.5 %
// there and, where the scenario asks for it, in the last fifth of the time in reverse, and was back within
// 2 % in the last fifth of the load step (heavy rotors take their time; the error is printed).
//
// Doc: docs/report.md   Test: tests/testbench/summary_test.cpp
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "testbench/run/float_errors.hpp"
#include "testbench/run/power.hpp"
#include "testbench/run/profile.hpp"
#include "testbench/run/ripple.hpp"
#include "testbench/run/tolerance.hpp"
#include "testbench/run/run_options.hpp"
#include "testbench/drive/six_step/record.hpp"
#include "testbench/engine/lockstep.hpp"

namespace steplock {

struct SpeedResult {
  double from_s = 0, to_s = 0;  // the span
  double mean_rpm = 0, error_percent = 0;
};

struct Summary {
  std::string drive, engine;
  double angle_deg = 0;
  bool locked = false;                     // at set speed, before the first disturbance
  std::uint64_t step_outs = 0;             // steps slipped, judged from the plant
  int lost_locks = 0;                      // claims of lock that ended without a command
  std::string fault = "none";              // reason latched at the end
  std::vector<std::string> reasons;        // of every failure on the way, also those retried
  int retries = 0;
  std::optional<double> lock_time_s;       // from t = 0 to the first lock
  std::optional<double> start_time_s;      // from `run` to set speed
  double set_speed_rpm = 0;
  SpeedResult steady;
  Ripple ripple;                           // of true speed and torque, steady
  Power power;                             // steady
  std::optional<Power> loaded_power;       // in the last fifth of the load step
  double phase_error_rms_deg = 0;          // phase detector, steady
  double commutation_error_mean_deg = 0, commutation_error_rms_deg = 0;  // true angle, steady
  double peak_current_a = 0, rms_current_a = 0, current_bound_a = 0;
  std::optional<double> load_step_nm, load_dip_percent;
  std::optional<SpeedResult> loaded, reversed;
  std::optional<double> reverse_time_s;    // from the command to the reverse lock
  std::vector<Piece> profile;              // of the scenario's set speeds and loads
  int crossings = 0, missed = 0, freewheel_long = 0, limit_hits = 0;
  std::uint64_t shoot_throughs = 0, clocks = 0;
  double simulated_s = 0, wall_s = 0, clocks_per_cpu_second = 0, energy_residual = 0;
  bool interrupted = false;
  std::optional<Lockstep> lockstep;         // rtl = fixed, if asked for
  std::optional<FloatErrors> float_errors;  // if asked for
  std::vector<std::string> advice;          // what to change, if it failed and the cause can be told (advice.hpp)

  std::vector<std::string> failures() const;  // why it does not pass; empty if it does
};

Summary summarise(const design::Settings&, const RunOptions&, const Record&);
nlohmann::ordered_json to_json(const Summary&);
std::string to_text(const Summary&);  // for a terminal

}  // namespace steplock
