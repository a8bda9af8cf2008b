// Pilot pulses, the law: the rotor's position from the currents of all pulses, as equations.
//
// PilotPulses does the same one sample at a time, with waits for what decays, and is held to this bit for bit.  What the ADCs
// and the current control do in between stands for two functions: `peak(pulse, axis)`, the current along `axis` at the end of a
// pulse, and `seen(u, v, from)`, the sum (its parts along windings u and v) from a direction.  What ends a search that is under way
// (a lost sample, a current that does not decay) is no part of it.
//
// Doc: docs/blocks/pilot_pulses.md   Test: tests/hls/pilot_pulses_law_test.cpp

#pragma once

#include "hls/sinusoidal/pilot_pulses.hpp"

namespace steplock {

struct PilotPulsesLaw {
  struct Pulse {
    int winding = 0;  // u, v, w; high, the others low
    bool reversed = false;
    int periods = 0;
    bool operator==(const Pulse&) const = default;
  };
  struct Seen {
    Int<16> along = 0;      // s0.15
    bool backward = false;  // the part across is negative
  };

  // law
  UInt<13> angle = 0;  // u0.13 turns, of the N pole from winding u
  SinusoidalReason failed = SinusoidalReason::kNone;

  template <class Peak, class SeenFrom>
  void find(const PilotConfig& config, const Peak& peak, const SeenFrom& seen) {
    // The sum of e^(ja) i over all six directions a leaves 6 Delta I_o e^(2j theta).
    Int<16> u = 0, v = 0;  // s0.15, modulo: its part along u from even rounds, along v from odd ones
    for (int round = 0; round < int(config.rounds.raw()); ++round) {
      const int along = round % 2;
      Int<16>& part = along == 0 ? u : v;
      for (const int winding : {0, 1, 2}) {
        for (const bool reversed : {false, true}) {
          const Pulse pulse{winding, reversed, int(config.short_periods.raw())};
          part = wrap<Int<16>>(part + peak(pulse, direction(along - winding, reversed)));
        }
      }
    }

    // 2 theta is the direction from which the sum has no part across: twelve halvings.
    Seen sum;
    for (int bit = kHalf / 2; bit != 0; bit /= 2) {
      const auto tried = angle | UInt<13>(bit);
      sum = seen(u, v, Angle(tried) << 12);
      if (!sum.backward) angle = tried;
    }
    if (sum.along < config.saliency) {
      failed = SinusoidalReason::kNoSaliency;
      return;
    }

    // Along the direction nearest to theta, and back: the current that strengthens the magnet is the greater one.
    Pulse pulse = nearest(int(config.long_periods.raw()));
    const Angle axis = direction(pulse.winding, pulse.reversed);
    const Int<16> forth = peak(pulse, axis);
    pulse.reversed = !pulse.reversed;
    const Int<16> both = wrap<Int<16>>(forth + peak(pulse, axis));
    if (both < -config.polarity) {
      angle = angle | UInt<13>(kHalf);
    } else if (both <= config.polarity) {
      failed = SinusoidalReason::kNoPolarity;
    }
  }

 private:
  static constexpr int kHalf = 1 << 12;  // u0.13: half a turn

  // u0.24: so many thirds of a turn, and a half.
  static Angle direction(int thirds, bool half) {
    return Angle(UInt<16>(0x5555 * ((thirds + 3) % 3)) ^ UInt<16>(half ? 0x8000 : 0)) << 8;
  }

  // While theta is less than half a turn: from 33.75 degrees on w reversed, from 90 v, from 146.25 u reversed.
  Pulse nearest(int periods) const {
    const int place = int(angle.raw()) >> 8;  // sixteenths of half a turn
    if (place < 3) return {0, false, periods};
    if (place < 8) return {2, true, periods};
    if (place < 13) return {1, false, periods};
    return {0, true, periods};
  }
  // end of law
};

}  // namespace steplock
