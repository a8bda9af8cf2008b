// How far the speed of a run may be off, of either drive.
//
// Test: tests/testbench/summary_test.cpp
#pragma once

namespace steplock {

inline constexpr double kSpeedTolerancePercent = 0.5;  // steady
inline constexpr double kRecoveredPercent = 2;         // in the last fifth of a load step

}  // namespace steplock
