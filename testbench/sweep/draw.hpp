// Random numbers that a run can be repeated from: counter-based, so that a quantity's value depends on
// the run's seed and the quantity's own number alone, never on what else was drawn or in which order.
//
//     bits(k) = scramble(scramble(seed) + k * golden)       scramble: the finaliser of splitmix64
//     unit(k) = bits(k) / 2^64, the upper 53 bits of it, in [0, 1)
//
// (The distributions of <random> are not the same in every standard library; these are.)
//
// Doc: docs/sweep.md   Test: tests/testbench/conditions_test.cpp
#pragma once

#include <cmath>
#include <cstdint>

namespace steplock {

constexpr std::uint64_t scramble(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}

class Draw {
 public:
  explicit constexpr Draw(std::uint64_t seed) : start_(scramble(seed + kGolden)) {}

  constexpr std::uint64_t bits(std::uint64_t k) const { return scramble(start_ + (k + 1) * kGolden); }
  constexpr double unit(std::uint64_t k) const {
    return static_cast<double>(bits(k) >> 11) * 0x1p-53;
  }
  constexpr double uniform(std::uint64_t k, double low, double high) const {
    return low + unit(k) * (high - low);
  }
  // Every ratio is as likely as any other of the same size; both ends above 0.
  double by_ratio(std::uint64_t k, double low, double high) const {
    return low * std::pow(high / low, unit(k));
  }
  constexpr std::uint64_t below(std::uint64_t k, std::uint64_t count) const {
    return static_cast<std::uint64_t>(unit(k) * static_cast<double>(count));
  }

 private:
  static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15u;
  std::uint64_t start_;
};

}  // namespace steplock
