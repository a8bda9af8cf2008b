// One-hot: a set of the values of an enumeration, a bit for each; a state is a set of one.
//
//     enum class Stage : std::uint8_t { kIdle, kWork, kDone };       // 0, 1, 2 ...
//     OneHot<Stage, 3> at_ = only(Stage::kIdle);                     // a register of three bits
//     at_.holds(Stage::kWork)                                        // one flip-flop, no decoder
//
// A state in as many flip-flops as there are states costs a few more than its code, and saves the look-up
// tables, in a row, that every question about a code takes.
//
// Doc: docs/blocks/one_hot.md   Test: tests/hls/one_hot_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

template <class Value, int N>
struct OneHot {
  constexpr OneHot() = default;
  constexpr OneHot(Value value) : bits(UInt<N>::of(std::uint64_t{1} << static_cast<int>(value))) {}
  constexpr explicit OneHot(UInt<N> of) : bits(of) {}

  bool holds(Value value) const { return bits.bit(static_cast<int>(value)); }
  template <class... Values>
  bool holds_one_of(Values... values) const { return (holds(values) || ...); }

  friend OneHot operator|(OneHot a, OneHot b) { return OneHot(a.bits | b.bits); }
  // The set itself if `condition`, else none.
  OneHot when(bool condition) const { return condition ? *this : OneHot(); }
  // Each value's successor; the last one's is the first.
  OneHot next() const { return OneHot(wrap<UInt<N>>(bits << 1) | UInt<N>(bits.bit(N - 1))); }
  // The code of the only value.
  Value value() const {
    int code = 0;
    for (int i = 0; i < N; ++i) code |= bits.bit(i) ? i : 0;
    return static_cast<Value>(code);
  }
  bool operator==(const OneHot&) const = default;

  UInt<N> bits = 0;  // public, for a set to be a port
};

}  // namespace steplock
