// Analog-to-digital converters for the phase currents and the bus voltage: sample and hold at one
// instant, with offset, white noise, range and resolution.
//
//     current code   round((i + offset_k + noise) / lsb)   lsb = 2 range / 2^bits, clipped to s.bits
//     voltage code   round((v + offset + noise) / lsb)     lsb = range / 2^bits, clipped to u.bits
//
// Noise is drawn from (seed, channel, number of the sample): same seed, same codes, whatever else
// the run did.  The instant is the caller's, who hands over the plant's state there.
//
// Doc: docs/plant.md   Test: tests/model/plant/adc_test.cpp
#pragma once

#include <array>
#include <cstdint>

#include "model/plant/plant.hpp"

namespace steplock::plant {

struct AdcParameters {
  int bits = 12;                                 // 4 .. 24, of every channel
  double current_range = 10;                     // A, of either sign, > 0
  std::array<double, 3> current_offset = {};     // A
  double current_noise = 0;                      // A, standard deviation
  double voltage_range = 60;                     // V, > 0
  double voltage_offset = 0, voltage_noise = 0;  // V
  std::uint64_t seed = 1;
};

struct AdcCodes {
  std::array<int, 3> current = {};
  int bus = 0;
  bool operator==(const AdcCodes&) const = default;
};

class Adc {
 public:
  explicit Adc(const AdcParameters& p) : p_(p) {}

  double current_lsb() const;  // A
  double voltage_lsb() const;  // V
  AdcCodes sample(const State&, std::int64_t number) const;

 private:
  AdcParameters p_;
};

}  // namespace steplock::plant
