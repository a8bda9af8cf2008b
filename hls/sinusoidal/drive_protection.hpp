// What ends a run of the sinusoidal drive, or an attempt: once per sample.
//
//     over-current   any phase beyond its limit                            fault at once
//     lost sample    so many periods in a row without one                  fault at once
//     saturated      a regulator at its limit for too long                 the attempt has failed
//     EMF            one that does not belong to the speed, for too long   "
//     too slow       for too long more than not, while locked              "
//
// The EMF test is the one against speeds that only exist in the estimator.  `restart` begins anew.
//
//     latency      1 clock, to `failed` 2; reasons are registers
//     registers    74 bits     multipliers  none
//
// Doc: docs/blocks/drive_protection.md   Test: tests/hls/drive_protection_test.cpp

#pragma once

#include "hls/sinusoidal/config.hpp"

namespace steplock {

class DriveProtection {
 public:
  struct In {
    bool restart = false;       // all counts to 0
    bool period = false;        // a PWM period begins: a sample is due
    bool sampled = false;       // one has been worked through
    bool over_current = false;
    bool regulating = false;
    bool saturated = false;     // a regulator is at its limit
    bool locked = false;
    bool fast = false;          // fast enough for the EMF's test
    bool slow = false;
    bool plausible = false;     // the EMF belongs to the speed
    FaultConfig config;
  };

  struct Out {
    SinusoidalReason fatal = SinusoidalReason::kNone;   // ends the run
    SinusoidalReason failed = SinusoidalReason::kNone;  // ends the attempt
  };

  Out tick(const In& in) {
    const Out out{.fatal = fatal_, .failed = failed_};
    const FaultConfig& config = in.config;
    // Of the counts as they stand, a clock after they changed: counting and comparing are a path each.
    failed_ = config.saturated != 0 && saturated_ > config.saturated ? SinusoidalReason::kSaturated
              : config.emf != 0 && emf_ > config.emf                 ? SinusoidalReason::kEmf
              : config.slow != 0 && slow_ > config.slow              ? SinusoidalReason::kTooSlow
                                                                   : SinusoidalReason::kNone;
    if (in.restart) {
      fatal_ = SinusoidalReason::kNone;
      failed_ = SinusoidalReason::kNone;
      saturated_ = 0;
      slow_ = 0;
      emf_ = 0;
      lost_ = 0;
    } else if (in.sampled) {
      lost_ = 0;
      saturated_ = in.regulating && in.saturated ? more(saturated_) : Periods(0);
      emf_ = in.locked && in.fast && !in.plausible ? more(emf_) : Periods(0);
      slow_ = !in.locked ? Periods(0) : in.slow ? more(slow_) : less(slow_);
      fatal_ = in.over_current ? SinusoidalReason::kOverCurrent : SinusoidalReason::kNone;
    } else if (in.period && awaited_) {
      if (config.lost_samples != 0 && lost_ + 1 >= config.lost_samples) {
        fatal_ = SinusoidalReason::kLostSample;
      } else {
        lost_ = saturate<UInt<4>>(lost_ + 1);
      }
    }
    awaited_ = in.period || (awaited_ && !in.sampled);
    return out;
  }

 private:
  static Periods more(Periods n) { return saturate<Periods>(n + 1); }
  static Periods less(Periods n) { return saturate<Periods>(n - 1); }

  SinusoidalReason fatal_ = SinusoidalReason::kNone;
  SinusoidalReason failed_ = SinusoidalReason::kNone;
  Periods saturated_ = 0;  // samples in a row
  Periods slow_ = 0;       // samples, balance
  Periods emf_ = 0;        // samples in a row
  UInt<4> lost_ = 0;       // periods in a row
  bool awaited_ = false;   // a sample is due
};

}  // namespace steplock
