#include "testbench/drive/sinusoidal/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/design/sinusoidal/config.hpp"
#include "model/design/sinusoidal/design.hpp"
#include "testbench/run/advice.hpp"
#include "testbench/run/timeline.hpp"

namespace steplock::sinusoidal {
namespace {

constexpr double kSwingsPercent = 25;  // of the set speed, peak to peak, as Matsui's page counts them

// Without load the phase currents stay near zero, where nobody knows which way dead time acts: the estimated angle hunts, and the
// rotor with it (docs/papers/matsui1996.md, "What swings at low speed").
std::string swings_without_current(const design::Settings& s, const Result& r) {
  if (s.sinusoidal.i_gamma_a != 0) return {};
  // V: what dead time takes from a phase, that of the gate guard where the file's is shorter.
  const double dead_s = std::max(s.inverter.dead_time_s, design::sinusoidal::kDeadTimeFloor / s.control.clock_hz);
  const double lost = dead_s * s.control.pwm_hz * s.inverter.bus_v;
  const auto line = [&](double set_rpm, const Swing& speed) {
    const double percent = 100 * (speed.greatest - speed.least) / std::abs(set_rpm);
    const double emf = s.motor.flux_vs * design::sinusoidal::speed_of(s, std::abs(set_rpm));
    // Where it takes less than a tenth of the EMF it is something else that swings.
    if (set_rpm == 0 || percent < kSwingsPercent || 10 * lost < emf) return std::string();
    return fmt::format("the rotor swings from {:.3g} to {:.3g} r/min about {:.3g}: at low speed with little current dead time hides which "
                       "way a phase is driven; write sinusoidal.i_gamma_a = {:.2g}",
                       speed.least, speed.greatest, set_rpm, 0.1 * s.motor.rated_current_a);
  };
  if (r.locked) {
    if (const std::string steady = line(r.set_speed_rpm, r.ripple.speed_rpm); !steady.empty()) return steady;
  }
  for (const Piece& p : r.profile) {
    if (const std::string piece = line(p.set_rpm, p.speed_rpm); !piece.empty()) return piece;
  }
  return {};
}

}  // namespace

std::vector<std::string> advice(const design::Settings& s, const Result& r, const Record& record) {
  if (r.interrupted) return {};
  std::vector<std::string> all = {swings_without_current(s, r)};
  if (!r.failures().empty()) {
    if (r.lock_time_s && r.reasons.empty() && !r.speed_time_s) {
      const double steady_end = std::min(timeline(s).steady_end_s, record.simulated_s);
      all.push_back(ends_too_soon(s, gaining(record.overview, *r.lock_time_s, steady_end, r.set_speed_rpm)));
    }
    all.push_back(load_step_beyond(s));
  }
  std::erase(all, "");
  return all;
}

}  // namespace steplock::sinusoidal
