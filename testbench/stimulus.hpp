// Stimulus: numbers of a given width that look for trouble, from a seed.
//
// Corners come as often as the middle: 0, 1, all ones, the sign bit, its complement, one bit set, small
// numbers.  Inputs also have to stand still, or no counter ever runs out: each keeps its last value
// with a probability of its own, drawn anew every epoch, between "never" and "nearly always".
//
// Test: tests/rtl/stimulus_test.cpp

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace steplock {

class Stimulus {
 public:
  __extension__ using Number = unsigned __int128;

  explicit Stimulus(std::uint64_t seed) : random_(seed) {}

  // Call before each set of inputs, then bits() once per input, in the same order.
  void next() {
    input_ = 0;
    if (clock_++ % kEpoch == 0) inputs_.clear();
  }

  Number bits(int width) {
    if (input_ == inputs_.size()) inputs_.push_back({fresh(width), draw_hold()});
    Input& input = inputs_[input_++];
    if (real() >= input.hold) input.value = fresh(width);
    return input.value;
  }

  bool bit(double probability) { return real() < probability; }

 private:
  static constexpr std::uint64_t kEpoch = 4096;  // clocks

  struct Input {
    Number value = 0;
    double hold = 0;  // probability of keeping it for a clock
  };

  double real() { return std::uniform_real_distribution<>(0, 1)(random_); }

  double draw_hold() {
    constexpr std::array holds = {0.0, 0.5, 0.9, 0.99, 0.999, 0.9999};
    return holds[random_() % holds.size()];
  }

  Number fresh(int width) {
    const Number all = width >= 128 ? ~Number{0} : (Number{1} << width) - 1;
    const Number sign = Number{1} << (width - 1);
    switch (random_() % 12) {
      case 0: return 0;
      case 1: return 1 & all;
      case 2: return all;
      case 3: return sign;
      case 4: return all ^ sign;
      case 5: return Number{1} << (random_() % static_cast<unsigned>(width));
      case 6:
      case 7: return (random_() % 16) & all;
      case 8: return (random_() % 256) & all;
      default: return (Number{random_()} << 64 | random_()) & all;
    }
  }

  std::mt19937_64 random_;
  std::uint64_t clock_ = 0;
  std::size_t input_ = 0;
  std::vector<Input> inputs_;
};

}  // namespace steplock
