#include "model/plant/arc.hpp"

#include <algorithm>
#include <cmath>

#include "model/plant/crossing.hpp"

namespace steplock::plant {
namespace {

constexpr double kLongestTurn = 20.0 / 360 * kTurn;  // electrical rad per step
constexpr double kShortestStep = 1e-12;              // s, an error that persists below is accepted

}  // namespace

int Arc::plan(const Dynamics& dynamics, const Regime& regime, const Variables& start,
              const Accuracy& accuracy, double& step) {
  dynamics_ = &dynamics;
  regime_ = regime;
  const double electrical_speed = std::abs(start[kSpeed]) * dynamics.pole_pairs();
  double h = std::min(step, accuracy.max_step);
  if (h * electrical_speed > kLongestTurn) h = kLongestTurn / electrical_speed;

  int tries = 0;
  for (;;) {
    ++tries;
    const double error = step_.attempt(start, h, dynamics.scale(),
                                       [&](const Variables& y, Variables& slope, Powers& power) {
                                         dynamics.derivative(regime_, y, slope, power);
                                       }) /
                         accuracy.tolerance;
    // The usual controller for an error that grows with h^5.
    const double factor = std::clamp(0.9 * std::pow(std::max(error, 1e-8), -0.2), 0.2, 4.0);
    step = std::min(h * factor, accuracy.max_step);
    if (error <= 1 || h <= kShortestStep) break;
    h *= std::min(factor, 0.9);
  }
  step_.prepare_dense();

  points_[0] = {0, start, dynamics.outputs(regime_, start)};
  points_[1] = point(h / 2);
  points_[2] = {h, step_.end(), dynamics.outputs(regime_, step_.end())};
  watch();
  find_end();
  return tries;
}

Variables Arc::at(double elapsed) const {
  return elapsed >= step_.length() ? step_.end() : step_.at(elapsed);
}

Point Arc::point(double elapsed) const {
  const Variables y = at(elapsed);
  return {elapsed, y, dynamics_->outputs(regime_, y)};
}

Variables Arc::settled(double elapsed) const {
  Variables y = at(elapsed);
  if (hit_ < 0 || elapsed < length()) return y;
  const Guard guard = guards_[hit_];
  if (guard.kind == Kind::kReversal) y[kSpeed] = 0;
  if (guard.kind == Kind::kCurrent || guard.kind == Kind::kContact) {
    const double residue = std::abs(y[guard.leg]);
    y[guard.leg] = 0;
    // The other legs keep the sum at zero: both of them, or the one that conducts.  A diode's current that is no larger
    // than what was cut off ends with it: half of that would turn it round, and two diodes would chatter for ever.
    const int a = (guard.leg + 1) % 3, b = (guard.leg + 2) % 3;
    const Phases& on = regime_.circuit.on;
    const auto ends = [&](int leg) { return regime_.circuit.is_diode(leg) && std::abs(y[leg]) <= residue; };
    if (on[a] + on[b] == 2 && !ends(a) && !ends(b)) {
      const double half = (y[a] + y[b]) / 2;
      y[a] -= half;
      y[b] -= half;
    } else {
      y[a] = y[b] = 0;
    }
  }
  return y;
}

void Arc::watch() {
  guard_count_ = 0;
  const auto add = [&](Kind kind, int leg = 0) { guards_[guard_count_++] = {kind, leg}; };
  for (int k = 0; k < 3; ++k) {
    const LegMode mode = regime_.circuit.mode[k];
    if (regime_.circuit.is_diode(k)) {
      add(Kind::kCurrent, k);
    } else if (regime_.opening[k]) {
      add(Kind::kContact, k);
    }
    if (mode != LegMode::kFloating) continue;
    if (regime_.circuit.inverse_count > 0) add(Kind::kLowClamp, k);
    add(Kind::kHighClamp, k);
  }
  if (regime_.turning != 0) {
    if (std::isfinite(regime_.piece.high)) add(Kind::kCorner);
    add(Kind::kReversal);
  } else {
    add(Kind::kBreakaway);
  }
  if (dynamics_->source_can_block()) add(Kind::kSource);
}

double Arc::value(Guard guard, const Point& point) const {
  const Variables& y = point.y;
  const double v = point.out.terminals.voltage[guard.leg];
  switch (guard.kind) {
    case Kind::kCurrent:
      return regime_.circuit.mode[guard.leg] == LegMode::kLowDiode ? y[guard.leg] : -y[guard.leg];
    case Kind::kContact:
      return points_[0].y[guard.leg] > 0 ? y[guard.leg] : -y[guard.leg];
    case Kind::kLowClamp:
      return v + regime_.circuit.drop;
    case Kind::kHighClamp:
      return y[kBus] + regime_.circuit.drop - v;
    case Kind::kCorner:
      return regime_.direction > 0 ? regime_.piece.high - y[kAngle] : y[kAngle] - regime_.piece.low;
    case Kind::kReversal:
      return regime_.direction * y[kSpeed];
    case Kind::kBreakaway:
      return regime_.hold - std::abs(point.out.pull);
    case Kind::kSource:
      break;
  }
  const double below = regime_.source_voltage - y[kBus];
  return regime_.source_conducts != 0 ? below : -below;
}

void Arc::find_end() {
  hit_ = -1;
  double end = points_[2].elapsed;
  for (int g = 0; g < guard_count_; ++g) {
    const double middle = value(guards_[g], points_[1]), last = value(guards_[g], points_[2]);
    if (middle >= 0 && last >= 0) continue;
    const int high = middle < 0 ? 1 : 2;
    const double before = high == 1 ? value(guards_[g], points_[0]) : middle;
    double at = kEventTolerance;  // already past: a tie within rounding, go on at once
    if (before >= 0) {
      at = falls_below_zero([&](double x) { return value(guards_[g], point(x)); },
                            points_[high - 1].elapsed, before, points_[high].elapsed,
                            high == 1 ? middle : last, kEventTolerance);
    }
    if (at < end || hit_ < 0) {
      end = std::min(at, end);
      hit_ = g;
    }
  }
  if (hit_ < 0 || end >= points_[2].elapsed) return;
  points_[1] = point(end / 2);
  points_[2] = point(end);
}

}  // namespace steplock::plant
