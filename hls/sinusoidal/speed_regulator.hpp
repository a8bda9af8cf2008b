// Speed regulator: from a set speed and the estimated one to the current that makes torque.
//
//     reference  moves towards the target by at most `slew`
//     speed     += filter (step - speed)
//     i_delta*   = PI(reference - speed), within +-limit, from 0 to limit until the lock; an integral stands where it would
//                  wind up, and begins at `start_current`
//
// The first current turns the rotor from the first sample on: offsets and dead times may move the estimate of a rotor at rest
// along with the reference, and as long as they do the PI part asks for none.  A current that brakes because of an estimate that is
// not yet to be believed turns the rotor backwards.
//
// All in the wanted direction: with `reverse` step, EMF and current change their signs on the way
// in and out.  With `slow_down` the target is three quarters of the stop speed.  Without `enable`
// all outputs are 0. Beside it stand the comparisons that need this speed: fast enough to be trusted, slow,
// slower than the stop speed, and whether an EMF belongs to it (between emf_low and emf_high times
// K_E speed).
//
//     step                 s-4.23 turns per sample, which is s0.19 of 1/16 turn
//     speed, thresholds    s0.15, u0.15 of 1/16 turn per sample;  reference, target   s0.25, u0.25
//     slew                 u0.25 per sample;  filter   u0.15
//     k_p, k_i             u7.8, u-2.17 per sample: current per speed
//     limit, start_current u0.15 of the current
//     speed, integral      s0.27 inside; the error and its part of the integral are rounded, not
//                          cut: half a place of the error is 0.06 % of 10 r/min in matsui1996
//     multipliers          8 products of 16 x 16 bits
//
// Doc: docs/blocks/speed_regulator.md   Test: tests/hls/speed_regulator_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

struct RegulatorConfig {
  UInt<25> target = 0;    // u0.25
  UInt<15> slew = 0;      // u0.25, per sample
  UInt<15> filter = 0;    // u0.15, per sample
  UInt<15> k_p = 0;       // u7.8
  UInt<15> k_i = 0;       // u-2.17, per sample
  UInt<15> limit = 0;     // u0.15, of the current
  UInt<15> start_current = 0;  // u0.15: where the integral begins
  UInt<15> lock = 0;      // u0.15: above, the estimate may be trusted
  UInt<15> slow = 0;      // u0.15: below, it may not
  UInt<15> stop = 0;      // u0.15: below, the drive lets go
  UInt<15> emf_low = 0;   // u2.13
  UInt<15> emf_high = 0;  // u2.13
};

class SpeedRegulator {
 public:
  struct In {
    bool enable = false;     // false: no current, the reference at 0, the integral at the start's current
    bool reverse = false;    // the wanted direction
    bool slow_down = false;  // towards a stop
    bool locked = false;     // the estimate is to be believed: the current may brake
    Int<20> step = 0;        // s0.19
    Int<20> emf_step = 0;    // s0.19, the EMF over K_E
    RegulatorConfig config;
  };

  struct Out {
    Int<16> current = 0;      // s0.15, i_delta*
    Int<16> speed = 0;        // s0.15, smoothed
    Int<16> reference = 0;    // s0.15, in the wanted direction
    bool saturated = false;   // the current is at the limit
    bool fast = false;        // above `lock`
    bool slow = false;        // below `slow`
    bool stopping = false;    // below `stop`
    bool plausible = false;   // the EMF belongs to the speed
  };

  Out tick(const In& in) {
    const RegulatorConfig& config = in.config;
    const auto forward = [&](auto x) {
      return saturate<decltype(x)>(in.reverse ? -x : Bits<decltype(x)::width + 1, true>(x));
    };
    const auto crawl = wrap<UInt<25>>((UInt<25>(config.stop) << 10) - (UInt<25>(config.stop) << 8));
    const UInt<25> target = in.slow_down ? crawl : config.target;
    const auto way = target - reference_;
    const bool far_up = way > config.slew, far_down = way < -config.slew;
    const auto reference = wrap<Int<26>>(far_up     ? reference_ + config.slew
                                         : far_down ? reference_ - config.slew
                                                    : Int<27>(target));

    const auto behind = (Int<28>(forward(in.step)) << 8) - speed_;
    const auto speed = saturate<Int<28>>(speed_ + ((behind * config.filter) >> 15));
    const auto error = saturate<Int<20>>(((Int<28>(reference) << 2) - speed + (1 << 7)) >> 8);
    const auto wanted = ((error * config.k_p) >> 12) + (integral_ >> 12);
    const Int<16> least = in.locked ? wrap<Int<16>>(-config.limit) : Int<16>(0);
    const bool above = wanted > config.limit, below = wanted < least;
    const Int<28> most = Int<28>(config.limit) << 12;
    const auto moved = integral_ + ((error * config.k_i + (1 << 8)) >> 9);
    const Int<28> lowest = Int<28>(least) << 12;
    const auto integral = moved > most     ? most
                          : moved < lowest ? lowest
                                           : wrap<Int<28>>(moved);
    const auto current = above   ? Int<16>(config.limit)
                         : below ? least
                                 : wrap<Int<16>>(wanted);

    const auto shown = wrap<Int<16>>(speed >> 12);
    const auto emf = wrap<Int<16>>(forward(in.emf_step) >> 4);
    const auto emf_low = (shown * config.emf_low) >> 13, emf_high = (shown * config.emf_high) >> 13;
    if (!in.enable) {
      reference_ = 0;
      speed_ = 0;
      integral_ = Int<28>(config.start_current) << 12;
      return {};
    }
    reference_ = reference;
    speed_ = speed;
    const bool winds_up = (above && !error.negative()) || (below && error.negative());
    if (!winds_up) integral_ = integral;
    return {.current = forward(current),
            .speed = forward(shown),
            .reference = wrap<Int<16>>(reference >> 10),
            .saturated = above || (below && in.locked),
            .fast = shown > config.lock,
            .slow = shown < config.slow,
            .stopping = shown < config.stop,
            .plausible = shown > 0 && emf > emf_low && emf < emf_high};
  }

 private:
  Int<26> reference_ = 0;  // s0.25
  Int<28> speed_ = 0;      // s0.27
  Int<28> integral_ = 0;   // s0.27, current
};

}  // namespace steplock
