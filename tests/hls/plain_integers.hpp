// A block's arithmetic once more in plain integers: its equations with the roundings that its header states, without widths.  What
// is equal to that bit for bit has no rounding half a place off, and no word that is too narrow.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "hls/numeric/bits.hpp"

namespace steplock::plain {

using Integer = std::int64_t;

template <int W, bool S>
Integer of(Bits<W, S> x) { return static_cast<Integer>(x.raw()); }

inline Integer down(Integer x, int places) { return x >> places; }  // towards minus infinity
inline Integer nearest(Integer x, int places) { return (x + (Integer{1} << (places - 1))) >> places; }
// Held within a word of so many bits.
inline Integer held(Integer x, int bits) { return std::clamp(x, -(Integer{1} << (bits - 1)), (Integer{1} << (bits - 1)) - 1); }
inline Integer held_unsigned(Integer x, int bits) { return std::clamp(x, Integer{0}, (Integer{1} << bits) - 1); }
// The low bits alone, as an angle goes round.
inline Integer turned(Integer x, int bits) { return x & ((Integer{1} << bits) - 1); }
// A constant with so many bits behind the point.
inline Integer constant(double x, int places) { return std::llround(std::ldexp(x, places)); }

// Words of which every fourth is a corner: the ends, zero, and what is next to them.
class Drawn {
 public:
  explicit Drawn(std::uint32_t seed) : any_(seed) {}

  int below(int end) { return std::uniform_int_distribution<>(0, end - 1)(any_); }
  bool one_in(int n) { return below(n) == 0; }
  int between(int least, int most) {
    if (one_in(4)) {
      const int corners[] = {least, most, 0, 1, -1, least + 1, most - 1};
      return std::clamp(corners[below(7)], least, most);
    }
    return std::uniform_int_distribution<>(least, most)(any_);
  }
  template <int W, bool S>
  void into(Bits<W, S>& word) {
    word = S ? between(-(1 << (W - 1)), (1 << (W - 1)) - 1) : between(0, (1 << W) - 1);
  }

 private:
  std::mt19937 any_;
};

}  // namespace steplock::plain
