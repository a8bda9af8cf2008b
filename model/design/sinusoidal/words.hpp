// The register words of the fixed-point sinusoidal drive, from what its blocks are set to in SI
// units.
//
// Words mirrors hls/sinusoidal/words.hpp by name with plain integers (model/ and hls/ do not
// include each other; the bench copies member by member).  Each word is the nearest one; WordRow
// keeps what was wanted and what the word means.
//
//     full scales   current  range I of the ADC, of a phase's peak: sqrt(3/2) I of a vector
//                   voltage  range U of the ADC, likewise
//                   speed    W = 2 pi / (16 T) electrical rad/s: 1/16 turn per sample
//     times         PWM periods
//
// Doc: docs/sinusoidal.md   Test: tests/model/design/sinusoidal_words_test.cpp
#pragma once

#include "model/design/sinusoidal/design.hpp"
#include "model/design/words.hpp"

namespace steplock::design::sinusoidal {

struct BridgeWords {
  Word period = 0, minimum = 0, dead_time = 0, dead_time_loss = 0;
  bool compensate = false, sine_pwm = false;
  Word reciprocal = 0;
};
struct EstimatorWords {
  bool voltage = false, average = false;
  Word decay = 0, gain = 0, k_theta = 0, k_e = 0, k_speed = 0, k_emf = 0, k_si = 0;
};
struct RegulatorWords {
  Word target = 0, slew = 0, filter = 0, k_p = 0, k_i = 0, limit = 0, start_current = 0;
  Word lock = 0, slow = 0, stop = 0, emf_low = 0, emf_high = 0;
};
struct ControlWords {
  Word set_gamma = 0, k_p = 0, k_i = 0, inductance = 0, emf = 0, limit = 0;
};
struct SequenceWords {
  bool arbitrary = false, pilot = false;
  Word hold_voltage = 0, pattern = 0, lock = 0, give_up = 0, brake = 0, retry_delay = 0, retries = 0;
};
struct PilotWords {
  Word short_periods = 0, long_periods = 0, rounds = 0, decayed = 0, saliency = 0, polarity = 0;
};
struct FaultWords {
  Word over_current = 0, saturated = 0, slow = 0, emf = 0, lost_samples = 0;
};
struct Words {
  BridgeWords bridge;
  EstimatorWords estimator;
  RegulatorWords speed;
  ControlWords control;
  SequenceWords sequence;
  PilotWords pilot;
  FaultWords fault;
};

struct Quantised {
  Words words;
  std::vector<WordRow> rows;
  // What the blocks cannot do, and words that do not fit: "speed.k_p needs 81234; at most 32767".
  std::vector<std::string> problems;
};

Quantised quantise(const Settings&);

// The target's word for another set speed.
Word target_word(const Settings&, double rpm);

// Clocks of dead time that the gate guard never undercuts.
inline constexpr int kDeadTimeFloor = 12;

// Clocks of a sample, in which the arithmetic takes nothing new: the least of a PWM period.
inline constexpr int kSampleClocks = 480;

}  // namespace steplock::design::sinusoidal
