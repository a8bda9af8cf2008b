// A rotor that turns as it is told, whatever the drive does, and comparators without fault: what the
// phase-locked loop alone makes of a back-EMF.
//
//     phase(t) = f t + sum of amplitude sin(omega t)      turns, electrical; e_u rises through zero at 0
//
// Test: tests/testbench/loop_response_test.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "testbench/drive/six_step/watch.hpp"
#include "testbench/run/advance.hpp"

namespace steplock {

struct Tone {
  double omega, amplitude;  // rad/s, turns
};

class IdealRotor {
 public:
  explicit IdealRotor(double turns_per_second, std::vector<Tone> tones = {})
      : frequency_(turns_per_second), tones_(std::move(tones)) {}

  double frequency() const { return frequency_; }
  double phase(double t) const {
    double turns = frequency_ * t;
    for (const Tone& tone : tones_) turns += tone.amplitude * std::sin(tone.omega * t);
    return turns;
  }
  // When the phase passes k sixths of a turn.  The tones must leave it rising.
  double crossing(std::int64_t k) const {
    const double wanted = static_cast<double>(k) / 6;
    double t = wanted / frequency_;
    // Modulation is slow and small against the turning: each round gains more than two digits.
    for (int i = 0; i < 12; ++i) t += (wanted - phase(t)) / frequency_;
    return t;
  }
  // After crossing k and before the next one.
  static plant::Pins pins(std::int64_t k) {
    const auto sector = static_cast<int>(((k % 6) + 6) % 6);
    plant::Pins p;
    for (int phase = 0; phase < 3; ++phase) {
      p.comparator[static_cast<std::size_t>(phase)] = (sector - 2 * phase + 6) % 6 < 3;
    }
    return p;
  }

 private:
  double frequency_;
  std::vector<Tone> tones_;
};

struct StepTaken {
  double time;     // s
  int step;
};

// Lets the engine run on the rotor's comparators; its commutations while it claims a lock.
template <class Engine>
std::vector<StepTaken> commutations_on(Engine& engine, const IdealRotor& rotor, double clock_hz,
                                         double seconds) {
  std::vector<StepTaken> all;
  engine.set_command({.run = true});
  std::int64_t next = 0;
  int step = -1;
  const auto end = static_cast<std::uint64_t>(seconds * clock_hz);
  std::uint64_t visit = 0;
  for (std::uint64_t clock = 0; clock < end;) {
    if (clock >= visit) {
      engine.set_pins(IdealRotor::pins(next++));
      const double at = std::ceil(rotor.crossing(next) * clock_hz);
      visit = std::max(clock + 1, static_cast<std::uint64_t>(at));
    }
    clock += advance(engine, std::min(end, visit) - clock) - 1;
    const Watch now = engine.watch();
    if (now.step() != step) {
      step = now.step();
      if (now.locked()) all.push_back({static_cast<double>(clock) / clock_hz, step});
    }
    ++clock;
  }
  return all;
}

}  // namespace steplock
