// The reference drive and the plant, closed: runs a drive file's scenario in doubles and judges it
// from outside, by the rotor's true angle.
//
// Test: tests/model/reference/closed_loop_test.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "model/design/design.hpp"
#include "model/plant/plant.hpp"
#include "model/reference/drive.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock::test {

struct Verdict {
  bool locked = false;          // at least once
  double lock_time = 0;         // s after `run`, the first time
  int locks_lost = 0;           // left kRun or kSlowDown for kRest or kFault
  int step_outs = 0;            // the true angle slipped by more than a step while locked
  int tries = 0;
  double mean_rpm = 0;          // over the last half between reaching the set speed and the load step
  double reached = 0;           // s, first within 2 % of the set speed
  double loaded_rpm = 0;        // mean over the last quarter of the load step
  double reversed_rpm = 0;      // mean over the last 0.1 s before the stop, if it reverses
  double peak_current = 0;      // A
  double worst_error_deg = 0;   // commutation, |late| while locked
  double mean_error_deg = 0, rms_error_deg = 0;
  reference::State last_state = reference::State::kIdle;
  reference::Reason reason = reference::Reason::kNone;
};

using Watch = std::function<void(double t, const reference::Output&, const plant::State&)>;

inline Verdict run_closed_loop(const design::Settings& s, const design::Parameters& p,
                               const plant::Parameters& plant_parameters, double angle_deg,
                               const Watch& watch = {}, double watch_every = 1e-3) {
  const auto& scene = s.scenario;
  plant::Plant plant(plant_parameters, initial_state(s, angle_deg));
  reference::Drive drive(p);
  Verdict v;
  reference::Command command{.brake_to_stop = scene.brake_to_stop};
  reference::Output out;
  const double never = 1e9;
  const double load_on = scene.load_step_s.value_or(never), load_off = scene.load_off_s.value_or(never),
               reverse = scene.reverse_s.value_or(never), stop = scene.stop_s.value_or(never);
  const double base = plant_parameters.load.opposing_torque, step = design::load_step_torque(s);
  double load = base, next_watch = 0, slip = 0, sum = 0, squares = 0, last_late = 0;
  long judged = 0;
  bool following = false;
  struct Span {
    double from, to;
  };
  const Span loaded{load_on + 0.75 * (load_off - load_on), load_off},
      reversed{stop - 0.1, stop};
  std::vector<std::pair<double, double>> path;  // time, angle

  for (double t = 0; t < scene.duration_s;) {
    command.run = t >= scene.run_s && t < stop;
    command.reverse = scene.reverse != (t >= reverse);
    const double wanted = base + (t >= load_on && t < load_off ? step : 0);
    if (wanted != load) plant.set_load_torque(load = wanted);

    reference::Pins pins;
    const auto read = [&] {
      pins = {.comparator = plant.pins().comparator, .limit = plant.pins().limit,
              .hall = plant.pins().hall};
    };
    read();
    const auto was = out.state;
    const bool was_locked = out.locked;
    out = drive.update(t, pins, command);
    const auto& g = out.gates;
    const plant::Gates gates{g[0], g[1], g[2], g[3], g[4], g[5]};
    if (gates != plant.gates()) plant.set_gates(gates);

    if (out.state != was) {
      if (out.state == reference::State::kAccelerate) ++v.tries;
      if (out.locked && !v.locked) v.locked = true, v.lock_time = t - scene.run_s;
      if (was_locked && (out.state == reference::State::kRest ||
                         out.state == reference::State::kFault)) {
        ++v.locks_lost;
        v.reason = out.reason;
      }
    }
    if (!out.locked) following = false;
    if (out.commutate || t >= next_watch) {
      const auto state = plant.state();
      for (const double i : state.current) v.peak_current = std::max(v.peak_current, std::abs(i));
      if (out.commutate && out.locked) {
        const bool back = drive.sequence().reverse();
        const int k = (out.step + (back ? 3 : 0)) % 6;
        const double theta = state.electrical_angle * 180 / std::numbers::pi;
        double late = back ? 90 + 60 * k - theta : theta - 30 - 60 * k;
        late += s.loop.advance_deg;
        late -= 360 * std::round((late - (following ? last_late : 0)) / 360);
        if (!following) slip = 0;
        following = true;
        last_late = late;
        if (std::abs(late - slip) > 60) ++v.step_outs, slip = 60 * std::round(late / 60);
        ++judged;
        sum += late;
        squares += late * late;
        v.worst_error_deg = std::max(v.worst_error_deg, std::abs(late));
      }
      if (t >= next_watch) {
        path.push_back({t, state.angle});
        const double rpm = state.speed * 30 / std::numbers::pi;
        if (v.reached == 0 && out.locked && std::abs(std::abs(rpm) / scene.speed_rpm - 1) < 0.02) {
          v.reached = t;
        }
        if (watch) watch(t, out, state);
        next_watch += watch_every;
      }
    }
    double next = std::min({drive.next_event(), plant.next_event(), scene.duration_s, next_watch});
    for (const double event : {scene.run_s, load_on, load_off, reverse, stop}) {
      if (event > t) next = std::min(next, event);
    }
    plant.advance_to(next);
    t = next;
  }
  const auto mean = [&](double from, double to) {
    double t0 = -1, a0 = 0, t1 = 0, a1 = 0;
    for (const auto& [t, a] : path) {
      if (t < from || t > to) continue;
      if (t0 < 0) t0 = t, a0 = a;
      t1 = t, a1 = a;
    }
    return t1 > t0 ? (a1 - a0) / (t1 - t0) * 30 / std::numbers::pi : 0;
  };
  const double steady_end = std::min({load_on, reverse, stop, scene.duration_s});
  if (v.reached > 0 && v.reached < steady_end) {
    v.mean_rpm = mean((v.reached + steady_end) / 2, steady_end);
  }
  v.loaded_rpm = mean(loaded.from, loaded.to);
  v.reversed_rpm = mean(reversed.from, reversed.to);
  v.mean_error_deg = judged ? sum / double(judged) : 0;
  v.rms_error_deg = judged ? std::sqrt(squares / double(judged)) : 0;
  v.last_state = out.state;
  if (out.reason != reference::Reason::kNone) v.reason = out.reason;
  return v;
}

}  // namespace steplock::test
