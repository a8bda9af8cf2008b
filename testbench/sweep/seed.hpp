// The seed of one run: everything about it but the drive file.
//
//     bit   53        a start with a hardship; never outside the envelope
//     bits  52 .. 3   drawn from the sweep's seed and the run's index
//           2         repeated on the RTL
//           1         a disturbance of a running drive, else a start alone
//           0         drawn from outside the envelope
//
// 53 bits, and an even number beyond, so that it is exact wherever numbers are doubles.
//
// Doc: docs/sweep.md   Test: tests/testbench/conditions_test.cpp
#pragma once

#include "testbench/sweep/draw.hpp"

namespace steplock {

inline constexpr std::uint64_t kHardSeed = std::uint64_t{1} << 53;
inline constexpr std::uint64_t kSeedEnd = 2 * kHardSeed;

struct RunSeed {
  std::uint64_t value = 0;

  bool outside() const { return (value & 1) != 0; }
  bool disturbed() const { return (value & 2) != 0; }
  bool hard() const { return (value & kHardSeed) != 0; }
  bool on_rtl() const { return (value & 4) != 0; }
  // A start whose lock is watched for long.  It takes four times as long to simulate, so not every one is.
  bool watched() const { return !disturbed() && !on_rtl() && Draw(value).unit(kWatch) < kWatchedPart; }
  static constexpr double kWatchedPart = 0.2;
  static constexpr std::uint64_t kWatch = 1 << 16;
};

enum class Matrix { kStart, kDisturb, kHard };

struct SweepKind {
  Matrix matrix = Matrix::kStart;
  std::uint64_t seed = 1;
  double outside = 0;  // part of the runs drawn outside the envelope
  double rtl = 0.01;   // part of the runs repeated on the RTL
};

inline RunSeed run_seed(const SweepKind& kind, std::uint64_t index) {
  const Draw draw(scramble(kind.seed) ^ index);
  const bool hard = kind.matrix == Matrix::kHard;
  const std::uint64_t flags = (hard ? kHardSeed : 0) | std::uint64_t{!hard && draw.unit(1) < kind.outside} |
                              std::uint64_t{kind.matrix == Matrix::kDisturb} << 1 |
                              std::uint64_t{draw.unit(2) < kind.rtl} << 2;
  return {draw.bits(0) >> 14 << 3 | flags};
}

}  // namespace steplock
