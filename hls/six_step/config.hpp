// The words of the six-step drive: what firmware sets, and what it reads back.
//
// Every word is an input of the top and may change at any clock; where a change takes effect later,
// its comment says when.  Formats: u0.16 is an unsigned fraction with 16 bits behind the point.
// "Turn" alone is a turn of the VCO: one commutation step, 60 electrical degrees, when divide = 0.
// What both drives share stands in hls/bridge/bridge.hpp.
//
// Doc: docs/theory.md

#pragma once

#include "hls/bridge/bridge.hpp"
#include "hls/numeric/bits.hpp"
#include "hls/numeric/one_hot.hpp"
#include "hls/numeric/parameter.hpp"

namespace steplock {

using Frequency = UInt<26>;  // u0.32, VCO turns per clock, below 2^-6
using Phase = UInt<16>;      // u0.16, turns of one commutation step
using PhaseError = Int<16>;  // s0.16, turns of one step: +-30 electrical degrees

enum class Sampling : std::uint8_t { kOnTime, kOffTime, kBoth };
enum class Detector : std::uint8_t { kOncePerTurn, kEveryStep };
enum class Bandwidth : std::uint8_t { kPerSecond, kPerStep };
enum class Source : std::uint8_t { kBemf, kHall };
enum class Method : std::uint8_t { kRamp, kFollow };  // of a start

struct BemfConfig {
  Sampling sampling = Sampling::kBoth;
  UInt<10> blanking = 0;         // clocks after each edge of the chopped gate
  UInt<8> sample_every = 1;      // clocks between samples; 0 counts as 1
  UInt<4> samples = 1;           // of the filter, 1 to 15; 0 counts as 1
};

struct LoopConfig {
  Detector detector = Detector::kEveryStep;
  Bandwidth bandwidth = Bandwidth::kPerStep;
  UInt<2> divide = 0;            // N = 6 * 2^divide VCO turns per electrical turn
  Phase expected = 0x8000;       // u0.16: the crossing's place in the step; 1/2 + advance / 60 deg
  Phase lead_error = 0x4000;     // u0.16: error of a rotor that led and hides the level before
  UInt<10> delay = 0;            // clocks from the crossing at the motor to the sample, taken back
  UInt<16> ki = 0;               // u2.14
  UInt<16> kp = 0;               // u2.14
  UInt<16> alpha = 0x8000;       // u1.15: 1 - exp(-omega_p T); 0x8000 is no pole; last bit unused
  Frequency scale = 0;           // u0.32: for the frequency, per second; last four bits unused
  Frequency minimum = 0;         // limits of the integrator and of the output
  Frequency maximum = 0;
};

struct StartConfig {
  Method method = Method::kRamp;  // kRamp: pre-align, align, ramp; kFollow: look, probe, still
  Ticks pre_align = 0;           // first pattern, so that a rotor opposite to the aligned position moves
  Ticks align = 0;               // alignment pattern: t_r of Eq. (22)
  Duty align_duty = 0;           // kRamp: twice that from the third attempt on, and so start_duty; kFollow: until followed
  Duty start_duty = 0;           // during acceleration and pull-in
  UInt<20> ramp = 0;             // u0.32 per tick: the VCO's acceleration; a quarter after each failed attempt
  UInt<16> look = 0;             // sample_every clocks, less one, with gates off until no current flows
  UInt<16> probe = 0;            // sample_every clocks of a drive between two looks
  UInt<8> still = 0;             // looks without news after which the step moves on
  Frequency hand_over = 0;       // f_a: fast enough for the PLL
  Phase window = 0;              // u0.16: a crossing closer than this to its place is a good one
  UInt<6> good_crossings = 0;    // in a row, for lock (and for catching)
  Ticks pull_in = 0;             // time limit from hand-over to lock
  Ticks detect_spin = 0;         // time to look for a rotor that already spins; 0 skips it
  Ticks slow_down = 0;           // time limit for slowing to hand-over speed before a reversal
  Ticks brake = 0;               // one braking interval, between two looks
  Duty brake_duty = 0;           // from which the back-EMF's is taken
  Ticks retry_delay = 0;         // gates off between a failure and the next attempt
  UInt<4> retries = 0;           // failed attempts before the fault latches
};

struct SpeedConfig {
  Frequency target = 0;          // u0.32
  UInt<20> slew = 0;             // u0.32 per tick
  UInt<4> shift = 0;             // speeds are normalised: frequency >> shift fits 15 bits
  UInt<16> kp = 0;               // u4.12: duty per normalised speed error (s1.15 against u1.15)
  UInt<16> ki = 0;               // u0.16 per tick
  UInt<16> bemf = 0;             // u4.12: duty of mean voltage equal to the back-EMF, per speed
  UInt<16> loaded = 0;           // u4.12: the same, and of commutating the largest current
  Duty minimum = 0;
  Duty maximum = 0;
  UInt<12> duty_slew = 0;        // u1.15 per tick
};

struct ProtectionConfig {
  UInt<6> misses = 0;            // lost lock: score of missed (4), hidden or far (1), good (-1) crossings; 0: off
  Frequency stall = 0;           // u0.32: slower than this in speed control is a stall
  Duty slip = 0;                 // duty above the back-EMF's that no right lock shows
  Phase freewheel = 0;           // u0.16: freewheeling for longer than this part of a step is wrong
  Ticks wrong_lock = 0;          // a wrong tick takes two of them; 0 disables the test
  UInt<4> over_current = 0;      // limit hits with the comparator never released; 0 disables
};

struct SixStepConfig {
  PwmConfig pwm;
  LimitConfig limit;
  BemfConfig bemf;
  LoopConfig loop;
  StartConfig start;
  SpeedConfig speed;
  ProtectionConfig protection;
  Source source = Source::kBemf;
};

// What a synthesis may leave out: parameters of every top.
struct Parts {
  Parameter<true> hall_decoder;  // for Hall sensors, and to catch a rotor that turns
  Parameter<true> ramp;          // the start by alignment and ramp
  Parameter<true> follower;      // the start that follows the rotor
  Parameter<true> telemetry;     // its counters
};

enum class State : std::uint8_t {
  kIdle, kDetectSpin, kBrake, kPreAlign, kAlign, kAccelerate, kPullIn, kRun, kSlowDown, kRetryDelay, kFault
};
using States = OneHot<State, 11>;  // how the blocks of the start hold and tell theirs

enum class Reason : std::uint8_t {
  kNone, kFaultPin, kOverCurrent, kStepOut, kStall, kWrongLock, kNoLock, kCannotStop, kHallCode,
  kBlocked
};

}  // namespace steplock
