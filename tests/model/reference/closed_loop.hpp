// The reference drive and a plant, closed, for tests that no drive file describes: a plant that
// differs from what the drive was designed for.  Judged from outside, by the rotor's true angle.
// (The bench's own run is testbench/drive/six_step/run.hpp.)
//
// Test: tests/model/reference/reference_closed_loop_test.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "model/design/design.hpp"
#include "model/plant/plant.hpp"
#include "model/reference/drive.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock::test {

struct Verdict {
  bool locked = false;      // at least once
  double lock_time = 0;     // s after `run`, the first time
  int tries = 0;            // entries of kAccelerate
  int locks_lost = 0;       // kRun or kSlowDown left for kRetryDelay or kFault
  int step_outs = 0;        // the true angle slipped by more than a step while locked
  double reached = 0;       // s, first within 2 % of the set speed
  double mean_rpm = 0;      // over the last half between `reached` and the first disturbance
  double loaded_rpm = 0;    // over the last quarter of the load step
  double reversed_rpm = 0;  // over the last 0.1 s before the stop
  double peak_current = 0;  // A
  double worst_error_deg = 0, mean_error_deg = 0, rms_error_deg = 0;  // commutations in lock
  reference::State last_state = reference::State::kIdle;
  reference::Reason reason = reference::Reason::kNone;
};

using Watch = std::function<void(double t, const reference::Output&, const plant::State&)>;

class ClosedLoop {
 public:
  ClosedLoop(const design::Settings& s, const design::Parameters& p, const plant::Parameters& plant,
             double angle_deg)
      : s_(s),
        plant_(plant, initial_state(s, angle_deg)),
        drive_(p),
        base_load_(plant.load.opposing_torque) {}

  Verdict run(const Watch& watch = {}, double watch_every = 1e-3) {
    const auto& scene = s_.scenario;
    for (double t = 0, next_watch = 0; t < scene.duration_s;) {
      const auto before = out_;
      update(t);
      changes(t, before);
      if (out_.commutate && out_.locked) judge();
      if (t >= next_watch) {
        const auto state = plant_.state();
        record(t, state);
        if (watch) watch(t, out_, state);
        next_watch += watch_every;
      }
      t = std::min({drive_.next_event(), plant_.next_event(), next_watch, next_command(t)});
      plant_.advance_to(t);
    }
    finish();
    return v_;
  }

 private:
  static constexpr double kNever = 1e9, kDegrees = 180 / std::numbers::pi;

  double at(const std::optional<double>& time) const { return time.value_or(kNever); }

  double next_command(double t) const {
    const auto& n = s_.scenario;
    double next = n.duration_s;
    for (const double event :
         {n.run_s, at(n.load_step_s), at(n.load_off_s), at(n.reverse_s), at(n.stop_s)}) {
      if (event > t) next = std::min(next, event);
    }
    return next;
  }

  void update(double t) {
    const auto& n = s_.scenario;
    const bool loaded = t >= at(n.load_step_s) && t < at(n.load_off_s);
    const double load = base_load_ + (loaded ? design::load_step_torque(s_) : 0);
    if (load != load_) plant_.set_load_torque(load_ = load);
    const reference::Pins pins{.comparator = plant_.pins().comparator,
                               .limit = plant_.pins().limit,
                               .hall = plant_.pins().hall};
    out_ = drive_.update(t, pins,
                         {.run = t >= n.run_s && t < at(n.stop_s),
                          .reverse = n.reverse != (t >= at(n.reverse_s)),
                          .brake_to_stop = n.brake_to_stop});
    const auto& g = out_.gates;
    const plant::Gates gates{g[0], g[1], g[2], g[3], g[4], g[5]};
    if (gates != plant_.gates()) plant_.set_gates(gates);
  }

  void changes(double t, const reference::Output& before) {
    using reference::State;
    if (!out_.locked) following_ = false;
    if (out_.state == before.state) return;
    if (out_.state == State::kAccelerate) ++v_.tries;
    if (out_.locked && !v_.locked) v_.locked = true, v_.lock_time = t - s_.scenario.run_s;
    if (before.locked && (out_.state == State::kRetryDelay || out_.state == State::kFault)) {
      ++v_.locks_lost;
    }
    if (out_.reason != reference::Reason::kNone) v_.reason = out_.reason;
  }

  // How late this step began, by the true angle; followed without wrapping while locked.
  void judge() {
    const bool back = drive_.sequence().reverse();
    const int k = (out_.step + (back ? 3 : 0)) % 6;
    const double theta = plant_.state().electrical_angle * kDegrees;
    double late = (back ? 90 + 60 * k - theta : theta - 30 - 60 * k) + s_.loop.advance_deg;
    late -= 360 * std::round((late - (following_ ? late_ : 0)) / 360);
    if (!following_) slip_ = 0;
    following_ = true;
    late_ = late;
    if (std::abs(late - slip_) > 60) ++v_.step_outs, slip_ = 60 * std::round(late / 60);
    ++judged_;
    v_.mean_error_deg += late;
    v_.rms_error_deg += late * late;
    v_.worst_error_deg = std::max(v_.worst_error_deg, std::abs(late));
  }

  void record(double t, const plant::State& state) {
    for (const double i : state.current) v_.peak_current = std::max(v_.peak_current, std::abs(i));
    path_.push_back({t, state.angle});
    const double rpm = std::abs(state.speed) * 30 / std::numbers::pi;
    if (v_.reached == 0 && out_.locked && std::abs(rpm / s_.scenario.speed_rpm - 1) < 0.02) {
      v_.reached = t;
    }
  }

  double mean_rpm(double from, double to) const {
    const auto after = [&](double t) {
      return std::lower_bound(path_.begin(), path_.end(), std::pair{t, -kNever});
    };
    const auto first = after(from), end = after(to);
    if (end - first < 2) return 0;
    const auto last = end - 1;
    return (last->second - first->second) / (last->first - first->first) * 30 / std::numbers::pi;
  }

  void finish() {
    const auto& n = s_.scenario;
    const double end = std::min({at(n.load_step_s), at(n.reverse_s), at(n.stop_s), n.duration_s});
    if (v_.reached > 0 && v_.reached < end) v_.mean_rpm = mean_rpm((v_.reached + end) / 2, end);
    v_.loaded_rpm =
        mean_rpm(at(n.load_off_s) - (at(n.load_off_s) - at(n.load_step_s)) / 4, at(n.load_off_s));
    v_.reversed_rpm = mean_rpm(at(n.stop_s) - 0.1, at(n.stop_s));
    if (judged_ > 0)
      v_.mean_error_deg /= judged_, v_.rms_error_deg = std::sqrt(v_.rms_error_deg / judged_);
    v_.last_state = out_.state;
  }

  const design::Settings& s_;
  plant::Plant plant_;
  reference::Drive drive_;
  reference::Output out_;
  Verdict v_;
  double base_load_, load_ = 0, late_ = 0, slip_ = 0, judged_ = 0;
  bool following_ = false;
  std::vector<std::pair<double, double>> path_;  // s, rad
};

}  // namespace steplock::test
