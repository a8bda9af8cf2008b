// A six-step drive on Hall sensors, for tests: it commutates at the plant's own Hall edges, not at
// a clock's, so that two runs of different tolerance differ by the plant alone.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "model/plant/bemf.hpp"
#include "model/plant/plant.hpp"

namespace steplock::plant {

inline constexpr double kDegree = std::numbers::pi / 180;

struct Step {
  int high, low;  // phases that carry the current in and out
};

// The step that pulls forward most, by the plant's table in plant.hpp.
inline Step forward_step(const std::array<bool, 3>& hall) {
  switch (hall[0] * 4 + hall[1] * 2 + hall[2]) {
    case 0b101:
      return {0, 1};
    case 0b100:
      return {0, 2};
    case 0b110:
      return {1, 2};
    case 0b010:
      return {1, 0};
    case 0b011:
      return {2, 0};
    default:
      return {2, 1};
  }
}

inline Gates gates_of(const std::array<bool, 3>& high, const std::array<bool, 3>& low) {
  return {high[0], low[0], high[1], low[1], high[2], low[2]};
}

// High-side chopping: the low side of the step is on throughout.
inline Gates chopped(Step step, bool on) {
  std::array<bool, 3> high = {}, low = {};
  high[step.high] = on;
  low[step.low] = true;
  return gates_of(high, low);
}

class SixStep {
 public:
  SixStep(double frequency, double duty) : period_(1 / frequency), on_time_(duty * period_) {}

  // Runs the plant to `until`; `observe(plant)` is called after each event.
  template <typename Observe>
  void run(Plant& plant, double until, const Observe& observe) {
    while (plant.time() < until) {
      const double edge = on_ ? start_ + on_time_ : start_ + period_;
      const double next = std::min({edge, plant.next_event(), until});
      plant.advance_to(next);
      if (next == edge) {
        if (!on_) start_ += period_;
        on_ = !on_ && on_time_ > 0;
      }
      plant.set_gates(chopped(forward_step(plant.pins().hall), on_));
      observe(plant);
    }
  }
  void run(Plant& plant, double until) {
    run(plant, until, [](const Plant&) {});
  }

 private:
  double period_, on_time_;
  double start_ = 0;  // of the present PWM period
  bool on_ = true;
};

}  // namespace steplock::plant
