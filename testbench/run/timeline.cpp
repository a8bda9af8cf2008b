#include "testbench/run/timeline.hpp"

#include <algorithm>
#include <cmath>

#include "model/design/design.hpp"

namespace steplock {
namespace {

struct Moment {
  double time;
  const char* what;
  double value = 0;  // of a profile
};

std::vector<Moment> moments(const design::ScenarioSection& n) {
  std::vector<Moment> all{{n.run_s, "run"}};
  if (n.load_step_s) all.push_back({*n.load_step_s, "load step"});
  if (n.load_off_s) all.push_back({*n.load_off_s, "load off"});
  if (n.inertia_step_s) all.push_back({*n.inertia_step_s, "inertia step"});
  if (n.reverse_s) all.push_back({*n.reverse_s, "reverse"});
  if (n.stop_s) all.push_back({*n.stop_s, "stop"});
  for (std::size_t k = 0; k < n.set_speed_s.size(); ++k) all.push_back({n.set_speed_s[k], kSetSpeed, n.set_speed_rpm[k]});
  for (std::size_t k = 0; k < n.load_s.size(); ++k) all.push_back({n.load_s[k], kLoad, n.load_nm[k]});
  std::ranges::stable_sort(all, {}, &Moment::time);
  return all;
}

}  // namespace

void drop_events(design::ScenarioSection& n) {
  n.load_step_s = n.load_off_s = n.reverse_s = n.stop_s = std::nullopt;
  for (auto* list : {&n.set_speed_s, &n.set_speed_rpm, &n.load_s, &n.load_nm}) list->clear();
}

double load_end(const design::ScenarioSection& n) {
  return std::min({n.load_off_s.value_or(n.duration_s), n.reverse_s.value_or(n.duration_s), n.stop_s.value_or(n.duration_s),
                   n.set_speed_s.empty() ? n.duration_s : n.set_speed_s.front()});
}

Timeline timeline(const design::Settings& s) {
  const design::ScenarioSection& n = s.scenario;
  const auto clock_of = [&](double t) {
    return static_cast<std::uint64_t>(std::llround(t * s.control.clock_hz));
  };
  Timeline t;
  t.clocks = clock_of(n.duration_s);
  t.load_step_nm = design::load_step_torque(s);
  t.steady_end_s = n.duration_s;

  Event now{.clock = 0,
            .command = {.reverse = n.reverse, .brake_to_stop = n.brake_to_stop},
            .load_nm = s.load.opposing_nm,
            .what = "gates off"};
  t.events.push_back(now);
  bool undisturbed = true;
  for (const Moment& moment : moments(n)) {
    now.clock = clock_of(moment.time);
    now.what = moment.what;
    if (now.what == "run") now.command.run = true;
    if (now.what == "load step") now.load_nm += t.load_step_nm;
    if (now.what == "load off") now.load_nm = s.load.opposing_nm;
    if (now.what == kSetSpeed) now.command.set_speed = design::steps_per_second(s, moment.value);
    if (now.what == kLoad) now.load_nm = s.load.opposing_nm + moment.value;
    if (now.what == "inertia step") {
      now.inertia_kgm2 = n.inertia_step_kgm2.value_or(3 * (s.motor.inertia_kgm2 + s.load.inertia_kgm2));
    }
    if (now.what == "reverse") now.command.reverse = !now.command.reverse;
    if (now.what == "stop") now.command.run = false;
    if (undisturbed && now.what != "run") t.steady_end_s = moment.time;
    undisturbed = undisturbed && now.what == "run";
    if (now.clock < t.clocks) t.events.push_back(now);
  }
  return t;
}

}  // namespace steplock
