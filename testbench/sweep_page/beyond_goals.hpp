// What of a page of starts lies beyond its goals, and the physics that explains it.
//
// Test: tests/testbench/beyond_goals_test.cpp
#pragma once

#include <string>
#include <vector>

#include "testbench/sweep/row.hpp"
#include "testbench/sweep/setup.hpp"

namespace steplock {

// The goals of one run, which hold for the highest of all.
inline constexpr double kPeakGoal = 1.15, kLockGoal = 5, kKickGoal = 360, kSpeedGoal = 1.1;

// A section of the page; empty if nothing lies beyond.
std::string beyond_goals(const SweepSetup&, const std::vector<Row>&);

}  // namespace steplock
