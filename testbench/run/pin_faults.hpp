// Faults of the comparator pins between plant and drive, in whole clocks.
//
//     held        the comparator keeps the level it had when the fault began
//     low, high   it keeps that level
//     inverted    the drive sees the other level
//
// A fault begins at clock `from`, or with the drive's first commutation from there on, and `delay`
// clocks later.  It ends after `clocks`, and earlier when the drive has commutated `steps` times, if
// that is not 0.  The drive sees it from the clock on in which it begins: no clock is skipped over it.
//
// Doc: docs/disturbances.md   Test: tests/testbench/pin_faults_test.cpp
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/plant/plant.hpp"

namespace steplock {

struct PinFault {
  enum class Kind { kHeld, kLow, kHigh, kInverted };
  static constexpr std::uint64_t kForGood = ~std::uint64_t{0} >> 1;

  Kind kind = Kind::kHeld;
  std::optional<int> comparator = {};  // 0, 1, 2: u, v, w; none: of the phase that then floats
  std::uint64_t from = 0;
  bool at_commutation = false;
  std::uint64_t delay = 0, clocks = kForGood;
  int steps = 0;
};

class PinFaults {
 public:
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};

  void add(const PinFault& fault) { faults_.push_back({fault}); }

  // The drive's step is `step` from `clock` on.
  void commutated(std::uint64_t clock, int step);
  // What the drive sees from `clock` on, and until next().  Clocks must not fall.
  plant::Pins seen(std::uint64_t clock, plant::Pins);
  std::uint64_t next(std::uint64_t clock) const;  // after `clock`; kNever: nothing changes by itself

 private:
  struct One {
    PinFault fault;
    std::uint64_t begin = kNever, end = kNever;
    int steps = 0;        // commutations since it began
    int comparator = -1;  // once it has begun
    bool level = false;
  };
  std::vector<One> faults_;
  int step_ = 0;
};

}  // namespace steplock
