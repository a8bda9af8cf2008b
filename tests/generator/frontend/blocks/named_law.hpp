// Of the block in named.hpp: what stands in a header of its own.

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock::test {

struct Law {
  template <class Number>
  Int<12> corrected(Number value, Int<8> gain) const {
    const auto steep = wrap<Int<12>>(value + gain);
    return wrap<Int<12>>(steep - (steep >> 3));
  }
};

}  // namespace steplock::test
