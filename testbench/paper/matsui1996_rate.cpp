// The same motor sampled faster than the paper could: 20 and 50 kHz.
#include <fmt/format.h>

#include <algorithm>

#include "testbench/paper/matsui1996.hpp"

namespace steplock::matsui1996 {

PaperSection loop_rates(const design::Settings& drive, const PaperOptions& options, Found& found) {
  constexpr double kAim = 0.2;         // %, the stricter of both estimators
  constexpr double kDeadTime = 1e-6;  // s
  PaperSection s{
      .title = "Faster than the paper",
      .text = fmt::format(
          "The same motor and ADCs with a dead time of {:g} us, which at 50 kHz leaves room "
          "for pulses. A sample and its program are those of 5 kHz: at 50 kHz a new one begins "
          "almost as soon as the last is done. Torque 0, 100, -100 %, 0.8 A of gamma current; engine "
          "`fixed`, and `{}` where it says so.",
          1e6 * kDeadTime, name_of(options.engine))};
  const auto sampled = [&](double khz) {
    design::Settings fast = drive;
    fast.control.pwm_hz = 1e3 * khz;
    fast.inverter.dead_time_s = kDeadTime;
    return fast;
  };
  for (const double khz : {20.0, 50.0}) {
    const design::Settings fast = sampled(khz);
    bool all_good = true;
    for (const auto estimator : {design::Estimator::kCurrent, design::Estimator::kVoltage}) {
      const char* name =
          estimator == design::Estimator::kCurrent ? "current model" : "voltage model";
      double worst = 0;
      bool held = true;
      std::string each;
      for (const double rpm : {100.0, 1200.0}) {
        const Case c{.estimator = estimator, .rpm = rpm, .i_gamma = 0.8, .torques = {0, 1, -1}};
        const auto points = measure(fast, fast, c, options,
                                    fmt::format("{:g} kHz, {}, {:g} r/min", khz, name, rpm));
        worst = std::max(worst, worst_error(points));
        held = held && all_held(points);
        each += fmt::format("{}{:g} r/min: {}", each.empty() ? "" : ", ", rpm,
                            all_held(points) ? fmt::format("{:.2g} %", worst_error(points)) : "lost");
      }
      const bool good = held && worst <= kAim;
      s.claims.push_back({fmt::format("{:g} kHz, {}: worst error", khz, name), "%", {},
                          "not reached", worst,
                          good ? each : fmt::format("**missed** ({:g} %); {}", kAim, each)});
      all_good = all_good && good;
      if (!held) s.failures.push_back(fmt::format("the lock at {:g} kHz", khz));
    }
    if (all_good) found.loop_khz = khz;
  }
  const Case c{.rpm = 1200, .torques = {1}};
  s.claims.push_back(rtl_point(sampled(50), c, "50 kHz, 1200 r/min", options, s.failures));
  return s;
}

}  // namespace steplock::matsui1996
