// The register words of the fixed-point drive, from what the blocks are set to in SI units.
//
// A word is found by its name, which is that of hls/six_step/config.hpp and of the drive's port: "speed.kp" (model/ and hls/
// do not include each other).  Each is the nearest one; WordRow keeps what was wanted and what the word means, so that the
// rounding of every coefficient can be printed.
//
//     frequency, ramp, slew   u0.32 VCO turns per clock (per tick): f 2^divide 2^32 / clock
//     phase                   u0.16 turns of a step          duty   u1.15
//     loop ki, kp             u2.14; per second times `scale`, chosen so that kp fills its word;
//                             the filter reads scale without its lowest four bits, alpha (u1.15)
//                             without its lowest one
//     speed kp, bemf, loaded  u4.12 and ki u0.16 per tick, per frequency >> shift
//
// Doc: docs/design.md   Test: tests/model/design/config_test.cpp
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/design/parameters.hpp"

namespace steplock::design {

using Word = std::uint32_t;

class Config {
 public:
  // Throws std::out_of_range, which names it, where there is none of that name.
  Word operator[](std::string_view name) const {
    const auto at = config_.find(name);
    if (at == config_.end()) throw std::out_of_range("a drive has no word " + std::string(name));
    return at->second;
  }
  void set(std::string name, Word word) { config_.insert_or_assign(std::move(name), word); }
  const std::map<std::string, Word, std::less<>>& all() const { return config_; }

 private:
  std::map<std::string, Word, std::less<>> config_;
};

struct WordRow {
  std::string name, unit;
  double wanted = 0;  // in the unit
  Word word = 0;
  double meant = 0;  // what the word stands for, in the unit
  double error() const { return meant - wanted; }
};

struct Quantised {
  Config config;
  std::vector<WordRow> rows;
  std::vector<std::string>
      problems;  // words that do not fit: "speed.kp needs 81234; at most 65535"
};

Quantised quantise(const Parameters&, double clock_hz);

// 1/(step/s): the greatest speed.kp that its word holds, with this loop's greatest frequency.
double most_duty_per_speed(const LoopParameters&, double clock_hz);

// Clocks between a pin and the block that reads it: the synchroniser's two flops.
inline constexpr int kPinClocks = 2;

}  // namespace steplock::design
