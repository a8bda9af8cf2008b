// Synchroniser: two flip-flops for each asynchronous pin of the drive.
//
// The only place where a pin meets the clock.  The first flop may go metastable; nothing but the
// second reads it.
//
//     latency      2 clocks     registers  16 bits     multipliers  none
//
// Doc: docs/blocks/synchroniser.md   Test: tests/hls/synchroniser_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

class Synchroniser {
 public:
  // Pins and their synchronised copies have the same names.
  struct Pins {
    bool comparator_u = false;  // terminal U above the reference
    bool comparator_v = false;  // terminal V above the reference
    bool comparator_w = false;  // terminal W above the reference
    bool limit = false;         // shunt current above the limit
    bool fault = false;         // external fault, active high
    bool hall_u = false;        // Hall sensor U
    bool hall_v = false;        // Hall sensor V
    bool hall_w = false;        // Hall sensor W
    bool operator==(const Pins&) const = default;
  };
  using In = Pins;
  using Out = Pins;

  Out tick(const In& in) {
    const Out out = second_;
    second_ = first_;
    first_ = in;
    return out;
  }

  // Quiet clocks: what the pins say has come through.
  bool settled(const In& in) const { return first_ == in && second_ == in; }
  bool operator==(const Synchroniser&) const = default;

 private:
  Pins first_;
  Pins second_;
};

}  // namespace steplock
