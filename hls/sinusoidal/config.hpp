// The words of the sinusoidal drive: what firmware sets.
//
// Full scales: the ADCs' ranges for current and voltage, of a phase's peak; 1/16 electrical
// turn per sample for speeds.  One sample per PWM period; all slow times are counted in these
// periods.  The words stand still while the drive runs: a sample is computed over many clocks, and
// takes them where it needs them.
//
// Doc: docs/sinusoidal.md

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/sinusoidal/estimator.hpp"
#include "hls/sinusoidal/speed_regulator.hpp"

namespace steplock {

using Periods = UInt<20>;  // PWM periods

// Places as in the reference, so that a record reads the same.
enum class SinusoidalState : std::uint8_t {
  kIdle, kCalibrate, kPilot, kPattern, kStarting, kRun, kSlowDown, kBrake, kRetryDelay, kFault
};

enum class SinusoidalReason : std::uint8_t {
  kNone, kFaultPin, kOverCurrent, kLostSample, kSaturated, kTooSlow, kEmf, kNoLock, kNoDecay,
  kNoSaliency, kNoPolarity
};

struct BridgeConfig {
  LegClocks period = 0;    // clocks; 477 at least, a sample's
  LegClocks minimum = 0;   // clocks; shorter on or off times become 0 % or 100 %
  UInt<8> dead_time = 0;   // clocks; the guard's floor wins
  DeadClocks dead_time_loss = 0;  // u8.4 clocks that a leg loses by it, with its diode's drop
  bool compensate = false; // the on-times make up for it
  bool sine_pwm = false;   // no zero component
  UInt<15> reciprocal = 0; // u0.25: 1 / (3 period)
};

struct ControlConfig {
  Int<16> set_gamma = 0;    // s0.15
  UInt<15> k_p = 0;         // u3.12
  UInt<15> k_i = 0;         // u0.15, per sample
  UInt<15> inductance = 0;  // u5.10, voltage per current and speed
  UInt<15> emf = 0;         // u5.10, voltage per speed
  UInt<15> limit = 0;       // u0.15, of the dc voltage
};

struct SequenceConfig {
  bool arbitrary = false;     // no pattern before the loop is closed
  bool pilot = false;         // pilot pulses instead of the pattern: a salient rotor
  UInt<15> hold_voltage = 0;  // u0.15, of the pattern's leg, or of a pilot pulse's
  Periods pattern = 0;        // each third of it; all pilot pulses at most
  Periods lock = 0;           // the estimate has to be trusted for so long
  Periods give_up = 0;        // no lock in this time is a failed attempt
  Periods brake = 0;
  Periods retry_delay = 0;
  UInt<4> retries = 0;
};

struct PilotConfig {
  UInt<6> short_periods = 0;  // 0 counts as 1
  UInt<6> long_periods = 0;   // 0 counts as 1
  UInt<5> rounds = 0;         // of six short pulses; even
  UInt<15> decayed = 0;       // u0.15: below, a current is gone
  UInt<15> saliency = 0;      // u0.15: a smaller sum is no position
  UInt<15> polarity = 0;      // u0.15: a smaller difference of the long peaks is no polarity
};

struct FaultConfig {
  UInt<15> over_current = 0;  // u0.15, any phase
  Periods saturated = 0;      // a regulator at its limit for more than this; 0: no test
  Periods slow = 0;           // slow for more than this longer than not; 0: no test
  Periods emf = 0;            // an EMF that does not belong to the speed for more; 0: no test
  UInt<4> lost_samples = 0;   // in a row; 0: no test
};

struct SinusoidalConfig {
  BridgeConfig bridge;
  EstimatorConfig estimator;
  RegulatorConfig speed;
  ControlConfig control;
  SequenceConfig sequence;
  PilotConfig pilot;
  FaultConfig fault;
};

}  // namespace steplock
