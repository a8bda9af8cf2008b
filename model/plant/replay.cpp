#include "model/plant/replay.hpp"

#include <cmath>
#include <stdexcept>

namespace steplock::plant {

void replay(const Parameters& parameters, const InitialState& initial,
            std::span<const GateEvent> events, double dt, double duration,
            const std::function<void(const Sample&)>& take) {
  if (!(dt > 0)) throw std::invalid_argument("dt must be above 0");
  if (!(duration >= 0)) throw std::invalid_argument("duration must be 0 or above");
  double last = 0;
  for (const GateEvent& event : events) {
    if (!(event.time >= last)) {
      throw std::invalid_argument("gate events must come in order of time, from 0 on");
    }
    last = event.time;
  }

  Plant plant(parameters, initial);
  auto next = events.begin();
  const auto samples = static_cast<long long>(std::floor(duration / dt + 0.5));
  for (long long n = 0; n <= samples; ++n) {
    const double time = static_cast<double>(n) * dt;
    for (; next != events.end() && next->time <= time; ++next) {
      plant.advance_to(next->time);
      plant.set_gates(next->gates);
      plant.set_load_torque(next->load_torque);
    }
    plant.advance_to(time);
    const State s = plant.state();
    take({time, s.current[0], s.current[1], s.current[2], s.voltage[0], s.voltage[1], s.voltage[2],
          s.speed, s.angle, s.neutral, s.bus_voltage, s.source_current, s.torque});
  }
}

}  // namespace steplock::plant
