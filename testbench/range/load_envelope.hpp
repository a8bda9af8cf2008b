// How much load a drive takes at each speed: the torque is raised slowly until the rotor is lost.
//
//     held   the greatest opposing torque at which the speed stayed within kHeld of the set speed
//     kept   the greatest at which the lock was kept, at whatever speed the voltage allowed
//     how    the lock ended (the reason that the drive gave), or that it never did
//
// The words are the file's; only the target speed changes, as a host would write it.
//
// Doc: docs/load.md (printed)   Test: tests/testbench/load_envelope_test.cpp
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/report/figure.hpp"

namespace steplock {

struct LoadPoint {
  double rpm = 0;
  bool locked = false;       // before any torque was added
  double held_nm = 0, kept_nm = 0;
  double least_rpm = 0;      // mean speed at kept_nm
  std::string how;           // "step_out", "stall", ...; "silent" if the drive noticed nothing
};

struct LoadEnvelope {
  std::string drive, file;   // its name; the stem of its file
  double rated_nm = 0, no_load_rpm = 0;
  std::vector<LoadPoint> points;
};

// Raises the torque in twenty steps up to `most_nm`.
LoadPoint measure_load(const design::Settings&, double rpm, double most_nm);
// `only`: of its four set speeds this one alone, from 1; 0 is all.
LoadEnvelope measure_envelope(const DriveFile&, const std::string& stem, int only = 0,
                              const std::function<bool(double done)>& progress = {});

Figure envelope_figure(const LoadEnvelope&);
std::string envelope_page(const std::vector<LoadEnvelope>&);  // Markdown

}  // namespace steplock
