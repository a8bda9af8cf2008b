#include "testbench/drive/sinusoidal/config.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "hls/bus/sinusoidal_rows.hpp"
#include "hls/sinusoidal/sinusoidal_standalone.hpp"
#include "testbench/drive/sinusoidal/watch.hpp"
#include "testbench/engine/config_by_name.hpp"

namespace steplock::sinusoidal {
namespace {

// Enumerators have the same order on both sides.
static_assert(int(State::kPattern) == int(SinusoidalState::kPattern));
static_assert(int(State::kRun) == int(SinusoidalState::kRun));
static_assert(int(State::kFault) == int(SinusoidalState::kFault));
static_assert(int(Reason::kSaturated) == int(SinusoidalReason::kSaturated));
static_assert(int(Reason::kNoLock) == int(SinusoidalReason::kNoLock));
static_assert(int(Reason::kNoPolarity) == int(SinusoidalReason::kNoPolarity));

}  // namespace

SinusoidalConfig hls_config(const design::Config& d) { return config_by_name<SinusoidalConfig>(kSinusoidalWordRows, d); }

SinusoidalConfig config_of(const design::Settings& s) {
  const auto q = design::sinusoidal::quantise(s);
  std::string lines;
  for (const std::string& line : q.problems) lines += (lines.empty() ? "" : "\n") + line;
  if (!lines.empty()) throw std::invalid_argument(lines);
  return hls_config(q.config);
}

SpiAdcConfig adc_config_of(const design::Settings& s) {
  constexpr double kFastest = 20e6, kAcquire = 300e-9;  // Hz, s: data sheet of the AD7928
  const double clock_hz = s.control.clock_hz;
  const auto clocks = [](double wanted) { return static_cast<int>(std::ceil(wanted - 1e-6)); };
  const int half = clocks(clock_hz / 2 / kFastest), quiet = clocks(kAcquire * clock_hz);
  const int needed = SinusoidalStandalone::clocks_of_a_sample(half, quiet);
  const int period = static_cast<int>(std::lround(clock_hz / s.control.pwm_hz));
  if (needed > period) {
    throw std::invalid_argument(
        fmt::format("control.pwm_hz is {:g} Hz, {} clocks; must be {} or more, which a sample takes over "
                    "SPI: lower it, or raise control.clock_hz",
                    s.control.pwm_hz, period, needed));
  }
  return {.half = half, .quiet = quiet, .u = 0, .v = 1, .dc = 2};
}

}  // namespace steplock::sinusoidal
