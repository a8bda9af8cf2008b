#include "model/plant/adc.hpp"

#include <algorithm>
#include <cmath>

#include "model/plant/sensors.hpp"

namespace steplock::plant {
namespace {

constexpr int kPhases = 3;
constexpr std::uint64_t kStream = 0xADC0;  // apart from the comparators' noise of the same seed

int code(double value, double lsb, double low, double high) {
  return static_cast<int>(std::clamp(std::round(value / lsb), low, high));
}

}  // namespace

double Adc::current_lsb() const { return std::ldexp(p_.current_range, 1 - p_.bits); }
double Adc::voltage_lsb() const { return std::ldexp(p_.voltage_range, -p_.bits); }

AdcCodes Adc::sample(const State& s, std::int64_t number) const {
  const auto noise = [&](int channel, double deviation) {
    return deviation == 0 ? 0 : deviation * Sensors::gaussian(p_.seed ^ kStream, channel, number);
  };
  const double half = std::ldexp(1.0, p_.bits - 1);
  AdcCodes codes;
  for (int k = 0; k != kPhases; ++k) {
    codes.current[k] = code(s.current[k] + p_.current_offset[k] + noise(k, p_.current_noise),
                            current_lsb(), -half, half - 1);
  }
  codes.bus = code(s.bus_voltage + p_.voltage_offset + noise(3, p_.voltage_noise), voltage_lsb(), 0,
                   2 * half - 1);
  return codes;
}

}  // namespace steplock::plant
