// A rotor that coasts, for tests of what is read off its terminals: sinusoidal, too heavy to notice, on a stiff bus.
#pragma once

#include <numbers>
#include <vector>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {

inline constexpr double kSpeed3000 = 2 * std::numbers::pi * 50;  // 200 electrical turns per second
inline constexpr double kPerDegree = 1 / (200 * 360.0);          // s

inline Parameters steady() {
  Parameters p;
  p.load.inertia = 1;
  p.bus.resistance = 0;
  for (auto& c : p.sensing.comparator) c = {.hysteresis = 0, .delay = 0};
  p.motor.shape.kind = BackEmfShape::Kind::kSinusoidal;
  return p;
}

struct Edge {
  double time;
  Pins pins;
};

// All pin changes of a coasting rotor.
inline std::vector<Edge> coast(const Parameters& p, const InitialState& initial, double until) {
  Plant plant(p, initial);
  std::vector<Edge> edges;
  Pins last = plant.pins();
  while (plant.next_event() < until) {
    plant.advance_to(plant.next_event());
    if (!(plant.pins() == last)) edges.push_back({plant.time(), last = plant.pins()});
  }
  return edges;
}

}  // namespace steplock::plant
