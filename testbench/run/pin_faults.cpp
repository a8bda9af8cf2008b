#include "testbench/run/pin_faults.hpp"

#include <algorithm>

namespace steplock {
namespace {

// The phase that floats in each step (docs/theory.md).
constexpr int kFloating[6] = {2, 1, 0, 2, 1, 0};

}  // namespace

void PinFaults::commutated(std::uint64_t clock, int step) {
  step_ = step;
  for (One& one : faults_) {
    const PinFault& f = one.fault;
    if (one.comparator >= 0 && f.steps > 0 && ++one.steps == f.steps) one.end = std::min(one.end, clock);
    if (f.at_commutation && one.begin == kNever && clock >= f.from) one.begin = clock + f.delay;
  }
}

plant::Pins PinFaults::seen(std::uint64_t clock, plant::Pins pins) {
  const plant::Pins real = pins;
  for (One& one : faults_) {
    const PinFault& f = one.fault;
    if (!f.at_commutation && one.begin == kNever) one.begin = f.from + f.delay;
    if (clock < one.begin || clock >= one.end) continue;
    if (one.comparator < 0) {
      one.comparator = f.comparator.value_or(kFloating[step_ % 6]);
      one.end = one.begin + f.clocks;
      if (clock >= one.end) continue;
      one.level = f.kind == PinFault::Kind::kHeld ? real.comparator[static_cast<std::size_t>(one.comparator)]
                                                  : f.kind == PinFault::Kind::kHigh;
    }
    bool& pin = pins.comparator[static_cast<std::size_t>(one.comparator)];
    pin = f.kind == PinFault::Kind::kInverted ? !pin : one.level;
  }
  return pins;
}

std::uint64_t PinFaults::next(std::uint64_t clock) const {
  std::uint64_t soonest = kNever;
  for (const One& one : faults_) {
    const PinFault& f = one.fault;
    const std::uint64_t begin = f.at_commutation ? one.begin : f.from + f.delay;
    for (const std::uint64_t t : {begin, one.end}) {
      if (t > clock) soonest = std::min(soonest, t);
    }
  }
  return soonest;
}

}  // namespace steplock
