// One engine, one plant, one scenario: the loop that every command and either drive share.
//
// Test: tests/testbench/run_drive_test.cpp
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/run/cosimulation.hpp"
#include "testbench/run/recorder_of.hpp"
#include "testbench/run/run_options.hpp"
#include "testbench/run/timeline.hpp"

namespace steplock {

RecorderSettings recorder_settings(const design::Settings&, const Timeline&);

// What the end of a simulation tells beside what was recorded on the way.
template <class Record, class Simulation>
void conclude(Record& record, const Simulation& simulation, const plant::Plant& plant, double clock_hz) {
  const plant::Energy energy = plant.state().energy;
  record.clocks = simulation.clock();
  record.simulated_s = static_cast<double>(record.clocks) / clock_hz;
  record.shoot_throughs = plant.shoot_throughs();
  record.energy_residual = energy.supplied > 0 ? energy.residual() / energy.supplied : 0;
}

template <class Engine, class Recording>
typename Recording::Record run_recorded(Engine& engine, const design::Settings& s, const RunOptions& options) {
  using Clock = std::chrono::steady_clock;
  const auto cpu_seconds = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const Timeline events = timeline(s);
  plant::Plant plant(plant_parameters(s), initial_state(s, options.angle_deg));
  Recording recorder(recorder_settings(s, events), options.trace);
  Cosimulation simulation(engine, plant, events, recorder, s.control.clock_hz);

  const auto wall = Clock::now();
  const double cpu = cpu_seconds();
  auto reported = wall;
  bool interrupted = false;
  const std::uint64_t chunk = options.watch ? 1 << 15 : 1 << 18;  // clocks between two looks at the wall clock
  while (simulation.clock() < events.clocks && !interrupted) {
    simulation.run_until(std::min(events.clocks, simulation.clock() + chunk));
    if (options.watch) options.watch(plant.state(), state_name(engine.watch()));
    const auto now = Clock::now();
    if (options.progress && now - reported > std::chrono::milliseconds(100)) {
      reported = now;
      interrupted = !options.progress(static_cast<double>(simulation.clock()) /
                                      static_cast<double>(events.clocks));
    }
  }
  typename Recording::Record record = recorder.take();
  conclude(record, simulation, plant, s.control.clock_hz);
  record.interrupted = interrupted;
  record.wall_s = std::chrono::duration<double>(Clock::now() - wall).count();
  record.cpu_s = cpu_seconds() - cpu;
  return record;
}

}  // namespace steplock
