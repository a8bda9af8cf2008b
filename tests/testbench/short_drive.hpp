// The drive that tests run, and the shortest ways to change and run it.
#pragma once

#include "testbench/run/check.hpp"
#include "testbench/drive/six_step/run.hpp"
#include "testbench/drive/six_step/summary.hpp"

namespace steplock {

inline design::Settings short_drive() {
  return open_drive_file(STEPLOCK_TESTS "/short.toml").settings;
}

inline Summary run_short(const design::Settings& s, EngineKind engine, double angle_deg = 0) {
  const RunOptions options{.engine = engine, .angle_deg = angle_deg};
  return summarise(s, options, run_drive(s, options));
}

inline std::string why(const Summary& s) {
  std::string all;
  for (const std::string& f : s.failures()) all += f + "; ";
  return all;
}

}  // namespace steplock
