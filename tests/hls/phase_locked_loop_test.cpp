// Detector, filter, VCO and divider closed around an ideal rotor, which crosses zero in the middle
// of each of its own steps.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "hls/six_step/divide_by_n.hpp"
#include "hls/six_step/loop_filter.hpp"
#include "hls/six_step/phase_detector.hpp"
#include "hls/six_step/vco_counter.hpp"

namespace steplock {
namespace {

constexpr double kTurn = 4294967296.0;

struct Loop6 {
  VcoCounter vco;
  DivideByN divider;
  PhaseDetector detector;
  LoopFilter filter;
  PhaseDetector::In detect{.detector_source = DetectorSource::kCrossings, .window = 0x1000};
  LoopFilter::In tune{.loop = Loop::kTrack, .alpha = 0x8000, .maximum = Frequency::max()};
  int divide = 0;

  VcoCounter::Out turn;
  double rotor = 0.5;  // steps; the VCO begins in the middle of step 0
  long step = 0;       // steps that the divider has begun
  bool crossed = false;
  int missed = 0, good = 0;
  double error = 0;    // turns of a step

  // Frequencies of the rotor and of the loop's outside are in steps per clock.
  explicit Loop6(double frequency, int divide_by = 0) : divide(divide_by) {
    // Ticks of a ramp take the filter to its frequency.
    auto left = std::int64_t(std::ldexp(frequency, divide) * kTurn);
    while (left > 0) {
      const auto ramp = std::min<std::int64_t>(left, 1 << 19);
      for (int i = 0; i < 200; ++i) {
        filter.tick({.loop = Loop::kRamp,
                     .tick = i == 1,  // a new `loop` counts from the next clock on
                     .ramp = ramp,
                     .maximum = Frequency::max()});
      }
      left -= ramp;
    }
    divider.tick({.divide = divide, .load = true, .half = true});
    vco.tick({.load = true, .half = divide == 0});
  }

  double frequency() { return std::ldexp(double(out.frequency.raw()) / kTurn, -divide); }

  void clock(double rotor_frequency, bool tick = false) {
    rotor += rotor_frequency;
    const auto d = divider.tick({.pulse = turn.pulse, .phase = turn.phase, .divide = divide});
    if (d.commutate) {
      ++step;
      crossed = false;
    }
    const bool after = rotor >= double(step) + 0.5;
    auto in = detect;
    in.commutate = d.commutate;
    in.step = d.step;
    in.before_seen = before && !d.commutate;
    in.crossing = before && after && !crossed && !d.commutate;
    in.crossing_phase = d.phase;
    before = !after || (before && !d.commutate);
    crossed = crossed || in.crossing;
    const auto e = detector.tick(in);
    missed += e.missed;
    if (e.update) {
      good = e.good ? good + 1 : 0;
      error = double(e.error.raw()) / 65536;
    }
    auto filter_in = tune;
    filter_in.error = e.error;
    filter_in.update = e.update;
    filter_in.tick = tick;
    out = filter.tick(filter_in);
    turn = vco.tick({.enable = true, .frequency = out.frequency});
  }

  LoopFilter::Out out;
  bool before = false;
};

void per_step(Loop6& loop, double bandwidth, double damping) {
  loop.tune.ki = int(bandwidth * bandwidth * 16384);
  loop.tune.kp = int(2 * damping * bandwidth * 16384);
}

// Bandwidth 0.2 per step, damping 1: the slowest part of the answer fades with exp(-0.2) per step,
// so after 100 steps what is left is below the phase's resolution, which at 3000 clocks a step is
// 1/3000.
RC_GTEST_PROP(PhaseLockedLoop, LocksFromATwentyPercentFrequencyError, ()) {
  const double rotor = 1.0 / 3000;
  const int divide = *rc::gen::inRange(0, 4);
  Loop6 loop(rotor * *rc::gen::inRange(80, 121) / 100.0, divide);
  per_step(loop, 0.2, 1);
  for (int i = 0; i < 100 * 3000; ++i) loop.clock(rotor);
  RC_ASSERT(std::abs(loop.error) < 2.0 / 3000);
  RC_ASSERT(std::abs(loop.frequency() / rotor - 1) < 0.4 * 2 / 3000);
  RC_ASSERT(loop.good > 60);
}

// The negative control of the test above: without an integrator the frequency error stays as phase.
TEST(PhaseLockedLoop, WithoutItsIntegratorAFrequencyErrorStaysAsPhaseError) {
  const double rotor = 1.0 / 3000;
  Loop6 loop(rotor * 0.9);
  loop.tune.kp = int(0.4 * 16384);
  for (int i = 0; i < 100 * 3000; ++i) loop.clock(rotor);
  // x (1 + kp e)... v = x + kp e v with x = 0.9 of the rotor's: e = 0.1 / 0.4.
  EXPECT_NEAR(loop.error, 0.1 / 0.4, 0.005);
}

// The integrator must grow by the acceleration per step, a / f, and grows by ki e f: e = a / (ki
// f^2).
TEST(PhaseLockedLoop, PerStepARampLeavesThePredictedError) {
  const double f = 1.0 / 3000, a = 0.002 * f * f;  // 0.2 % faster each step
  Loop6 loop(f);
  per_step(loop, 0.2, 1);
  double rotor = f;
  for (int i = 0; i < 80 * 3000; ++i) loop.clock(rotor += a);
  const double predicted = a / (0.04 * rotor * rotor);
  // ki has 14 bits, the phase 1/3000 steps of resolution; the rest is the ramp's own bend.
  EXPECT_NEAR(loop.error, predicted, 0.05 * predicted + 1.0 / 3000);
  EXPECT_EQ(loop.missed, 0);
}

// Per second the integrator grows by ki e scale per tick, and needs a T.
TEST(PhaseLockedLoop, PerSecondARampLeavesThePredictedError) {
  const double f = 1.0 / 3000, tick = 1000;
  Loop6 loop(f);
  loop.tune.bandwidth = Bandwidth::kPerSecond;
  loop.tune.scale = int(f * kTurn);
  // A natural frequency of 0.03 per tick, far below the three ticks of a step; damping 1.
  loop.tune.ki = int(0.03 * 0.03 / (f * tick) * 16384);
  loop.tune.kp = int(2 * 0.03 / (f * tick) * 16384);
  const double a = 1e-4 * f * f;
  double rotor = f;
  for (int i = 0; i < 400 * 3000; ++i) loop.clock(rotor += a, i % int(tick) == 0);
  const double predicted = a * tick / (loop.tune.ki.raw() / 16384.0 * f);
  EXPECT_NEAR(loop.error, predicted, 0.05 * predicted + 1.0 / 3000);
  EXPECT_EQ(loop.missed, 0);
}

// The paper's form sees one crossing in six steps, so each update acts on the phase six times: 0.12
// per turn of bandwidth needs 6 kp = 2 * 0.12 and 6 ki = 0.12^2.
TEST(PhaseLockedLoop, LocksOnOneCrossingPerTurnToo) {
  const double rotor = 1.0 / 1000;
  Loop6 loop(rotor * 1.03);
  loop.detect.detector = Detector::kOncePerTurn;
  loop.tune.ki = int(0.0024 * 16384);
  loop.tune.kp = int(0.04 * 16384);
  for (int i = 0; i < 1200 * 1000; ++i) loop.clock(rotor);
  EXPECT_LT(std::abs(loop.error), 2.0 / 1000);
  EXPECT_LT(std::abs(loop.frequency() / rotor - 1), 2.0 / 1000);
}

// 15 degrees of advance: the crossing stands at 3/4 of the step, so commutation comes 1/4 early.
TEST(PhaseLockedLoop, PhaseAdvanceCommutatesEarlier) {
  const double rotor = 1.0 / 3000;
  Loop6 loop(rotor);
  per_step(loop, 0.2, 1);
  loop.detect.expected = 0xC000;
  for (int i = 0; i < 100 * 3000; ++i) loop.clock(rotor);
  const double vco = double(loop.step) + double(loop.turn.phase.raw()) / 65536;
  EXPECT_NEAR(vco - loop.rotor, 0.25, 2.0 / 3000);
}

// A VCO that stands still in a turning field is pulled along from whatever phase it has.
RC_GTEST_PROP(PhaseLockedLoop, LocksFromEveryPhase, ()) {
  const double rotor = 1.0 / 2000;
  Loop6 loop(rotor);
  per_step(loop, 0.2, 1);
  loop.detect.lead_error = 0x4000;
  loop.rotor = *rc::gen::inRange(0, 100) / 100.0;
  for (int i = 0; i < 120 * 2000; ++i) loop.clock(rotor);
  RC_ASSERT(std::abs(loop.error) < 2.0 / 2000);
}

}  // namespace
}  // namespace steplock
