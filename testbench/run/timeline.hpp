// What happens when: the scenario of a drive file as clock numbers, in order.  The scenario must be
// sound (design::problems()).
//
//     run_s        `run` rises (direction: scenario.reverse)
//     load_step_s  load torque rises by load_step_nm     load_off_s   and falls again
//     inertia_step_s  a mass that turns along is coupled
//     reverse_s    the direction changes                 stop_s       `run` falls
//     set_speed_s  the set speed changes                 load_s       the load torque does
//
// Test: tests/testbench/timeline_test.cpp
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/design/settings.hpp"
#include "testbench/engine/host_command.hpp"
#include "testbench/run/pin_faults.hpp"

namespace steplock {

struct Event {
  std::uint64_t clock = 0;
  HostCommand command;
  double load_nm = 0;  // opposing torque from here on
  std::string what;    // for people: "run", "load step", ...
  double source_v = 0;              // of the bus from here on; 0: as before
  std::array<bool, 3> open = {};    // windings without contact from here on
  double inertia_kgm2 = 0;          // coupled to the rotor from here on
};

// What the moments of a profile are called.
inline constexpr const char* kSetSpeed = "set speed";
inline constexpr const char* kLoad = "load";

struct Timeline {
  std::vector<Event> events;  // sorted by clock, the first one at clock 0
  std::vector<PinFault> faults;  // of the comparator pins
  std::uint64_t clocks = 0;   // of the whole scenario
  // The span in which the drive should stand at set speed undisturbed ends here.
  double steady_end_s = 0;
  double load_step_nm = 0;
};

Timeline timeline(const design::Settings&);

// Nothing but the start is left: for what has events of its own, such as a sweep.
void drop_events(design::ScenarioSection&);

// s: until when the load step lasts with set speed and direction as they were.
double load_end(const design::ScenarioSection&);

}  // namespace steplock
