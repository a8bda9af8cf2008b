// Whether a drive starts and holds its lock: from rest, with its file's own motor, until the lock has been kept for a while.
//
//     held      a lock, without a step slipped, kept for a second and 60 electrical turns of the set speed, 20 s at most, while the
//               drive accelerates to it
//     time      at most twice the bound of the lock's time (model/design/bounds.hpp), and what the lock has to be kept for
//
// Doc: docs/decades.md (printed)   Test: tests/testbench/hold_test.cpp
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock {

struct Hold {
  bool held = false;
  std::optional<double> lock_s;  // from `run` to the lock that was held, or to the last one
  int lost_locks = 0;            // of earlier ones
  double rpm = 0;                // at the end
  std::string reason;            // of a failed attempt, also one that another one followed
};

Hold start_and_hold(const design::Settings&);

// A line without a comma in it but those between the values, and back.
std::string to_line(const Hold&);
Hold hold_of(const std::string& line);

struct HeldMotor {
  std::string name;
  design::Settings settings;
  Hold hold;
};
// docs/decades.md.  `printed_by` is the command, `seed` that of the motors.
std::string decades_page(const std::vector<HeldMotor>&, const std::string& printed_by, std::uint64_t seed);

}  // namespace steplock
