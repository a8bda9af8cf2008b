// What a scheduled block may take, as its C++ says it: steplock::Budget of
// hls/numeric/scheduled.hpp.

#pragma once

namespace hlsgen {

struct Budget {
  unsigned multipliers = 1;
  unsigned width = 16;         // bits of a multiplier's first factor, signed
  unsigned second_width = 16;  // of its second
  unsigned clocks = 2;         // from start to done
  unsigned levels = 12;        // look-up tables in a row between two registers
  bool held = false;           // the inputs stand still from start to done
  bool program = false;        // one datapath and a program, numbers in a memory
  unsigned early = 0;          // of a program: from start to the outputs in `early`; 0: none
};

}  // namespace hlsgen
