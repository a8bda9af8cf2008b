// Telemetry: counts what happened since the drive was last told to run.
//
// Each counter stops at 65535 instead of wrapping: a large number stays large.  Left out by COUNTS they are 0.
//
//     latency      1 clock     registers  80 bits     multipliers  none
//
// Doc: docs/blocks/telemetry.md   Test: tests/hls/telemetry_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/parameter.hpp"

namespace steplock {

class Telemetry {
 public:
  using Count = UInt<16>;

  struct In {
    Parameter<true> counts;
    bool clear = false;           // wins over every event
    bool crossing = false;        // a zero crossing was found
    bool missed = false;          // a step ended without one
    bool freewheel_long = false;  // a step freewheeled for too long
    bool limit_hit = false;       // the current limit cut a pulse
    bool retry = false;           // an attempt failed
  };

  struct Out {
    Count crossings = 0;       // events, stops at 65535
    Count missed = 0;          // events, stops at 65535
    Count freewheel_long = 0;  // events, stops at 65535
    Count limit_hits = 0;      // events, stops at 65535
    Count retries = 0;         // events, stops at 65535
    bool operator==(const Out&) const = default;
  };

  Out tick(const In& in) {
    const Out out = counts_;
    const bool clears = in.clear || !in.counts;
    count(counts_.crossings, in.crossing, clears);
    count(counts_.missed, in.missed, clears);
    count(counts_.freewheel_long, in.freewheel_long, clears);
    count(counts_.limit_hits, in.limit_hit, clears);
    count(counts_.retries, in.retry, clears);
    return out;
  }

  bool operator==(const Telemetry&) const = default;

 private:
  static void count(Count& counter, bool event, bool clear) {
    if (clear) {
      counter = 0;
    } else if (event && counter != Count::max()) {
      counter = wrap<Count>(counter + 1);
    }
  }

  Out counts_;
};

}  // namespace steplock
