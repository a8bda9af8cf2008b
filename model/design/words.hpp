// The register words of the fixed-point drive, from what the blocks are set to in SI units.
//
// Words mirrors hls/six_step/words.hpp by name with plain integers (model/ and hls/ do not include
// each other; the bench copies member by member).  Each word is the nearest one; WordRow keeps what
// was wanted and what the word means, so that the rounding of every coefficient can be printed.
//
//     frequency, ramp, slew   u0.32 VCO turns per clock (per tick): f 2^divide 2^32 / clock
//     phase                   u0.16 turns of a step          duty   u1.15
//     loop ki, kp             u2.14; per second times `scale`, chosen so that kp fills its word;
//                             the filter reads scale without its lowest four bits, pole (u1.15)
//                             without its lowest one
//     speed kp, bemf, loaded  u4.12 and ki u0.16 per tick, per frequency >> shift
//
// Doc: docs/design.md   Test: tests/model/design/register_words_test.cpp
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/design/parameters.hpp"

namespace steplock::design {

using Word = std::uint32_t;

struct PwmWords {
  Word period = 0, minimum = 0;
  bool centred = false, complementary = false;
  Word dead_time = 0, tick_periods = 1;
};
struct LimitWords {
  Word blanking = 0, off_time = 0;
};
struct BemfWords {
  Sampling sampling = Sampling::kBoth;
  Word blanking = 0, sample_every = 1, samples = 1;
};
struct LoopWords {
  Detector detector = Detector::kEveryStep;
  LoopForm bandwidth = LoopForm::kPerStep;
  Word divide = 0, expected = 0x8000, lead_error = 0x4000, delay = 0;
  Word ki = 0, kp = 0, pole = 0x8000, scale = 0, minimum = 0, maximum = 0;
};
struct StartWords {
  Word pre_align = 0, align = 0, align_duty = 0, start_duty = 0, ramp = 0, hand_over = 0, window = 0;
  Word good_crossings = 0, pull_in = 0, detect_spin = 0, slow_down = 0, brake = 0, brake_duty = 0;
  Word retry_delay = 0, retries = 0;
  Method method = Method::kRamp;
  Word look = 0, probe = 0, still = 0;
};
struct SpeedWords {
  Word target = 0, slew = 0, shift = 0, kp = 0, ki = 0, bemf = 0, loaded = 0;
  Word minimum = 0, maximum = 0, duty_slew = 0;
};
struct ProtectionWords {
  Word misses = 0, stall = 0, slip = 0, freewheel = 0, wrong_lock = 0, over_current = 0;
};
struct Words {
  PwmWords pwm;
  LimitWords limit;
  BemfWords bemf;
  LoopWords loop;
  StartWords start;
  SpeedWords speed;
  ProtectionWords protection;
  Source source = Source::kBemf;
};

struct WordRow {
  std::string name, unit;
  double wanted = 0;  // in the unit
  Word word = 0;
  double meant = 0;  // what the word stands for, in the unit
  double error() const { return meant - wanted; }
};

struct Quantised {
  Words words;
  std::vector<WordRow> rows;
  std::vector<std::string>
      problems;  // words that do not fit: "speed.kp needs 81234; at most 65535"
};

Quantised quantise(const Parameters&, double clock_hz);

// 1/(step/s): the greatest speed.kp that its word holds, with this loop's greatest frequency.
double most_speed_kp(const LoopParameters&, double clock_hz);

// Clocks between a pin and the block that reads it: the synchroniser's two flops.
inline constexpr int kPinClocks = 2;

}  // namespace steplock::design
