#include "testbench/compare/corner_inputs.hpp"

#include <algorithm>
#include <optional>
#include <random>

#include "hls/six_step/phase_detector.hpp"

namespace steplock {
namespace {

// Steps that lead, lag, and hide their crossing after each.
std::vector<DetectorInput> detector_corners(const LoopConfig& w) {
  std::vector<DetectorInput> told;
  PhaseDetector block;
  const auto clock = [&](PhaseDetector::In in) {
    in.detector_source = DetectorSource::kCrossings;
    in.expected = w.expected, in.lead_error = w.lead_error;
    return block.tick(in);
  };
  const auto step = [&](std::optional<Phase> crossing, bool before) {
    clock({.before_seen = before});
    clock(crossing ? PhaseDetector::In{.crossing = true, .crossing_phase = *crossing, .before_seen = before}
                   : PhaseDetector::In{.before_seen = before, .commutate = true});
    told.push_back({.crossing = crossing.has_value(), .before_seen = before, .crossing_phase = crossing.value_or(0),
                    .error = clock({}).error, .begins = told.empty()});
    if (crossing) clock({.commutate = true});
  };
  clock({.commutate = true});
  const int expected = int(w.expected.raw());
  for (const int lead : {0, 0x800, 0x1800, 0x3000, -0x3000}) {
    step(Phase::of(std::uint64_t(std::clamp(expected - lead, 0, 0xFFFF))), true);
    step({}, false);
    step({}, false);
    step({}, true);
  }
  return told;
}

std::vector<LoopInput> loop_corners(const SixStepConfig& w) {
  constexpr int kMost = 20000, kLast = 160;  // updates: two windows of law_errors.hpp
  std::vector<LoopInput> told;
  std::mt19937 random(1);
  LoopFilterLaw law;
  const auto update = [&](int error) {
    LoopInput u{.in = {.loop = Loop::kTrack, .error = error, .bandwidth = w.loop.bandwidth,
                       .delay = w.loop.delay >> int(w.loop.divide.raw()), .ki = w.loop.ki, .kp = w.loop.kp, .alpha = w.loop.alpha,
                       .scale = w.loop.scale, .minimum = w.loop.minimum, .maximum = w.loop.maximum, .hand_over = w.start.hand_over,
                       .stall = w.protection.stall},
                .before = law.frequency(), .begins = told.empty()};
    if (u.begins) {
      u.before = w.start.hand_over;
      law.x = law.y = wrap<UInt<30>>(u.before << 4);
      law.fresh = false;
    }
    law.update(u.in);
    u.after = law.frequency();
    told.push_back(u);
  };
  const auto noise = [&] {
    for (int k = 0; k < 128; ++k) update(int(random() % 0x1000) - 0x800);
  };
  noise();
  for (const int error : {0x4000, -0x4000}) {
    int held = 0;
    for (int k = 0; k < kMost && held < kLast; ++k) {
      update(error);
      held += error > 0 ? law.at_top : law.at_bottom;
    }
    noise();
  }
  return told;
}

std::vector<SpeedInput> speed_corners(const SixStepConfig& w) {
  std::vector<SpeedInput> told;
  std::mt19937 random(2);
  SpeedControlLaw law;
  const auto tick = [&](SpeedMode mode, double f, double target, bool limited = false, bool masked_lead = false,
                        bool freewheels = false) {
    const auto part = [&](double x) { return Frequency::of(std::uint64_t(x * double(w.speed.target.raw()))); };
    SpeedInput u{.in = {.mode = mode, .fixed_duty = mode == SpeedMode::kFixed ? 0x3000 : 0, .frequency = part(f),
                        .target = part(target), .limited = limited, .masked_lead = masked_lead, .freewheels = freewheels,
                        .period = w.pwm.period, .slip = w.protection.slip, .config = w.speed}};
    law.tick(u.in);
    u.after = law.duty;
    told.push_back(u);
  };
  constexpr int kTicks = 200;
  tick(SpeedMode::kFixed, 0.7, 1);
  for (int k = 0; k < kTicks; ++k) tick(SpeedMode::kControl, 0.7 + 0.001 * (random() % 100), 1);
  // Too slow for good, and too fast: the duty's ends.
  constexpr int kMost = 20000, kLast = 160;
  const auto drive = [&](double f, Duty end) {
    for (int k = 0, held = 0; k < kMost && held < kLast; ++k) {
      tick(SpeedMode::kControl, f, 1);
      held += law.duty == end;
    }
  };
  drive(0.3, wrap<Duty>(w.speed.maximum));
  drive(1.2, wrap<Duty>(w.speed.minimum));
  // Down to half the speed with no duty left, where control begins once more, time and again.
  for (int turn = 0; turn < 4; ++turn) {
    tick(SpeedMode::kFixed, 1, 1);
    const auto down = [&] { return law.descends && 2 * double(law.reference.raw()) <= double(w.speed.target.raw()); };
    for (int k = 0; k < kMost && (law.duty != w.speed.minimum || !down()); ++k) tick(SpeedMode::kControl, 0.9997, 0.5);
    // Never at the target itself, where a last place decides.
    for (double f = 0.9997; f > 0.48; f -= 0.01) tick(SpeedMode::kControl, f, 0.5);
    for (int k = 0; k < kTicks; ++k) tick(SpeedMode::kControl, 0.4797, 0.5);
  }
  // What limit and freewheeling say; above the least duty, below which the block yields to freewheeling and the reference does not.
  tick(SpeedMode::kFixed, 0.5, 0.8);
  for (int k = 0; k < 4 * kTicks; ++k) {
    const unsigned of = random() % 32;
    tick(SpeedMode::kControl, 0.3 + 0.001 * (random() % 200), 0.8, of < 4, of == 4, of > 3 && of < 7);
  }
  return told;
}

}  // namespace

LawInputs corner_inputs(const SixStepConfig& w, double clock_hz) {
  LawInputs told{detector_corners(w.loop), loop_corners(w), speed_corners(w)};
  const double tick = double(w.pwm.period.raw()) * double(w.pwm.tick_periods.raw()) / clock_hz;
  for (std::size_t k = 0; k < told.speed.size(); ++k) told.speed[k].time = double(k) * tick;
  for (std::size_t k = 0; k < told.loop.size(); ++k) told.loop[k].time = double(k) * tick;
  return told;
}

}  // namespace steplock
