// Hall decoder: a three-bit code of 120-degree signals to the sector of a turn.
//
//     u v w    101 100 110 010 011 001      000, 111
//     sector    0   1   2   3   4   5       illegal: the sector holds
//
// Serves the Hall sensors of the baseline drive, and the back-EMF's signs at the comparators while
// all gates are off (docs/theory.md has the angles).  A code counts when it was the same in `samples`
// samples in a row.
//
//     latency      `samples` samples     registers  15 bits     multipliers  none
//
// Doc: docs/blocks/hall_decoder.md   Test: tests/hls/hall_decoder_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

class HallDecoder {
 public:
  struct In {
    bool u = false;        // synchronised
    bool v = false;        // synchronised
    bool w = false;        // synchronised
    bool sample = false;   // strobe: look at the code in this clock
    UInt<4> samples = 1;   // alike in a row before a code counts; 0 counts as 1
  };

  struct Out {
    UInt<3> sector = 0;    // 0 to 5
    bool changed = false;  // one clock: `sector` is new
    bool forward = false;  // the last change went up by one
    bool reverse = false;  // the last change went down by one; neither: it jumped
    bool illegal = false;  // the code is 000 or 111
  };

  Out tick(const In& in) {
    const Out out{.sector = sector_,
                  .changed = changed_,
                  .forward = forward_,
                  .reverse = reverse_,
                  .illegal = illegal_};
    changed_ = false;
    if (in.sample) look(in);
    return out;
  }

 private:
  void look(const In& in) {
    const UInt<3> code = (in.u ? 4 : 0) + (in.v ? 2 : 0) + (in.w ? 1 : 0);
    if (code != code_) {
      code_ = code;
      alike_ = 1;
    } else if (alike_ < in.samples) {
      alike_ = wrap<UInt<4>>(alike_ + 1);
    }
    if (alike_ >= in.samples) take(code);
  }

  void take(UInt<3> code) {
    illegal_ = code == 0 || code == 7;
    const UInt<3> sector = sector_of(code);
    if (illegal_ || sector == sector_) return;
    changed_ = true;
    forward_ = sector == (sector_ == 5 ? UInt<3>(0) : wrap<UInt<3>>(sector_ + 1));
    reverse_ = sector_ == (sector == 5 ? UInt<3>(0) : wrap<UInt<3>>(sector + 1));
    sector_ = sector;
  }

  static UInt<3> sector_of(UInt<3> code) {
    switch (int(code.raw())) {
      case 5: return 0;
      case 4: return 1;
      case 6: return 2;
      case 2: return 3;
      case 3: return 4;
      default: return 5;
    }
  }

  UInt<3> code_ = 0;     // of the last sample
  UInt<4> alike_ = 0;    // samples in a row with that code
  UInt<3> sector_ = 0;
  bool changed_ = false;
  bool forward_ = false;
  bool reverse_ = false;
  bool illegal_ = false;
};

}  // namespace steplock
