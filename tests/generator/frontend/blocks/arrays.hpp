// Test blocks: arrays of registers and constant tables, read and written at variable places.

#pragma once

#include "hls/numeric/bits.hpp"

#include <array>

namespace steplock::test {

struct Sample {
  Int<10> value = 0;
  bool valid = false;
  friend constexpr bool operator==(const Sample& a, const Sample& b) {
    return a.value == b.value && a.valid == b.valid;
  }
};

class History {
 public:
  struct In {
    Int<10> value = 0;
    UInt<3> write = 0, read = 0;
    UInt<2> row = 0, column = 0;
    std::uint8_t any = 0;
    bool flag = false;
    std::array<UInt<4>, 3> gains = {};
    template <class F>
    void each(F f) {
      f(value), f(write), f(read), f(row), f(column), f(any), f(flag);
      for (auto& gain : gains) f(gain);
    }
  };
  struct Out {
    Int<10> value = 0;
    bool valid = false;
    UInt<7> cell = 0;
    Int<13> sum = 0;
    std::array<UInt<4>, 3> copies = {};
    UInt<8> chosen = 0;
    template <class F>
    void each(F f) {
      f(value), f(valid), f(cell), f(sum);
      for (auto& copy : copies) f(copy);
      f(chosen);
    }
  };

  Out tick(const In& in) {
    Out out;
    const Sample& sample = samples_[in.read.raw()];
    out.value = sample.value;
    out.valid = sample.valid;
    Sample fresh;
    fresh.value = in.value;
    fresh.valid = true;
    if (in.flag) samples_[in.write.raw()] = fresh;
    else samples_[in.write.raw()].valid = false;

    out.cell = grid_[in.row.raw()][in.column.raw()];
    if (in.any < 3) grid_[in.any][in.column.raw()] = wrap<UInt<7>>(out.cell + in.any);
    if (in.any == 77) {
      for (auto& row : grid_) row.fill(0);
    }
    if (in.any == 78) grid_[in.row.raw()] = grid_[0];

    for (const auto& s : samples_) out.sum = wrap<Int<13>>(out.sum + s.value);
    for (int i = 0; i < 3; ++i) out.copies[i] = in.gains[2 - i];

    int local[5] = {3, 1, 4, 1, 5};
    local[in.any % 4] = in.any;
    out.chosen = wrap<UInt<8>>(UInt<32>(static_cast<unsigned>(local[in.any & 3] + local[4])));
    return out;
  }

 private:
  std::array<Sample, 8> samples_ = {};
  std::array<std::array<UInt<7>, 4>, 4> grid_ = {{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10}, {11}}};
};

class Tables {
 public:
  struct In {
    UInt<4> angle = 0;
    UInt<3> step = 0;
    bool reverse = false;
    template <class F>
    void each(F f) { f(angle), f(step), f(reverse); }
  };
  struct Out {
    Int<9> sine = 0;
    UInt<3> high = 0, low = 0;
    UInt<8> prime = 0, nested = 0;
    template <class F>
    void each(F f) { f(sine), f(high), f(low), f(prime), f(nested); }
  };

  Out tick(const In& in) {
    static constexpr int kPrimes[] = {2, 3, 5, 7, 11, 13, 17, 19};
    constexpr std::array<std::array<std::uint8_t, 3>, 2> nested = {{{1, 2, 3}, {200, 100, 50}}};
    const auto step = in.step < 6 ? in.step : UInt<3>(0);
    Out out;
    out.sine = kSine[in.angle.raw()];
    const Pattern pattern = kPatterns[step.raw()];
    out.high = in.reverse ? pattern.low : pattern.high;
    out.low = in.reverse ? pattern.high : pattern.low;
    out.prime = kPrimes[in.step.raw()];
    if (in.step.raw() < 3) out.nested = nested[in.reverse][in.step.raw()];
    return out;
  }

 private:
  struct Pattern {
    UInt<3> high, low;
  };
  static constexpr std::array<Pattern, 6> kPatterns = {
      {{4, 2}, {4, 1}, {2, 1}, {2, 4}, {1, 4}, {1, 2}}};
  static constexpr std::array<Int<9>, 16> kSine = {0,  98,  181,  236,  255,  236,  181,  98,
                                                   0, -98, -181, -236, -255, -236, -181, -98};
};

}  // namespace steplock::test
