// Random words for the tests of laws: corners, and numbers of random length, so that small ones are as likely as large ones.
#pragma once

#include <cstdint>
#include <random>

#include "hls/numeric/bits.hpp"

namespace steplock {

class RandomConfig {
 public:
  explicit RandomConfig(std::uint32_t seed) : random_(seed) {}

  template <int W>
  UInt<W> word() {
    const std::uint64_t most = (std::uint64_t{1} << W) - 1;
    switch (random_() % 16) {
      case 0: return UInt<W>::of(0);
      case 1: return UInt<W>::of(1);
      case 2: return UInt<W>::of(most);
      case 3: return UInt<W>::of(most / 2 + 1);
      case 4: return UInt<W>::of(most / 2);
      default: return UInt<W>::of((random_() & most) >> random_() % W);
    }
  }
  std::uint32_t below(std::uint32_t n) { return random_() % n; }
  bool one_in(std::uint32_t n) { return below(n) == 0; }

 private:
  std::mt19937 random_;
};

}  // namespace steplock
