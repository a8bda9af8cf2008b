// What a scheduled block may take, as its C++ says it: steplock::Budget of
// hls/numeric/scheduled.hpp.

#pragma once

namespace hlsgen {

struct Budget {
  unsigned width = 16;         // bits of the multiplier's first factor, signed
  unsigned second_width = 16;  // of its second
  unsigned clocks = 2;         // from start to done
  unsigned early = 0;          // from start to the outputs in `early`; 0: none
};

}  // namespace hlsgen
