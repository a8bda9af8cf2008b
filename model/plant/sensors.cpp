#include "model/plant/sensors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/plant/crossing.hpp"

namespace steplock::plant {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kFarthestNoise = 6.7;  // |gaussian()| never exceeds sqrt(64 ln 2) = 6.66

std::uint64_t scramble(std::uint64_t x) {  // SplitMix64's finaliser
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

}  // namespace

Sensors::Sensors(const Sensing& sensing)
    : reference_(sensing.reference),
      seed_(sensing.seed),
      limit_offset_(sensing.limit.offset),
      signal_{sensing.comparator[0], sensing.comparator[1], sensing.comparator[2], sensing.limit} {
  set_limit_threshold(sensing.limit_threshold);
  for (int s = 0; s < kSignals; ++s) delay_[s] = s < kHall ? signal_[s].delay : sensing.hall_delay;
  for (int k = 0; k < 3; ++k) {
    hall_edge_[k] = (30 + 120 * k + sensing.hall_error_deg[k]) * kTurn / 360;
  }
}

double Sensors::gaussian(std::uint64_t seed, int source, std::int64_t cell) {
  const std::uint64_t stream = scramble(seed * 8 + static_cast<std::uint64_t>(source));
  const std::uint64_t bits = scramble(stream ^ static_cast<std::uint64_t>(cell));
  const double radius = (static_cast<double>(bits >> 32) + 1) * 0x1p-32;  // (0, 1]
  const double angle = static_cast<double>(bits & 0xFFFFFFFFu) * 0x1p-32;
  return std::sqrt(-2 * std::log(radius)) * std::cos(kTurn * angle);  // Box and Muller
}

double Sensors::input(int signal, const Point& point) const {
  if (signal == kLimit) return point.out.bridge_current;
  const Phases& v = point.out.terminals.voltage;
  switch (reference_) {
    case Sensing::Reference::kVirtualNeutral:
      return v[signal] - (v[0] + v[1] + v[2]) / 3;
    case Sensing::Reference::kHalfBus:
      return v[signal] - point.y[kBus] / 2;
    default:
      return v[signal] - point.out.terminals.neutral;
  }
}

bool Sensors::decide(double input, bool level, const Comparator& comparator) {
  const double half = comparator.hysteresis / 2;
  return input > comparator.offset + (level ? -half : half);
}

bool Sensors::hall_level(int hall, const Point& point) const {
  const double half_turns = (point.y[kAngle] - hall_edge_[hall]) / (kTurn / 2);
  return whole_below(half_turns) % 2 == 0;
}

void Sensors::start(const Arc& arc) {
  const Point& begin = arc.points()[0];
  for (int s = 0; s < kHall; ++s) level_[s] = decide(input(s, begin), false, signal_[s]);
  for (int k = 0; k < 3; ++k) level_[kHall + k] = hall_level(k, begin);
  for (int s = 0; s < kSignals; ++s) apply({0, 0, s, level_[s]});
}

void Sensors::search(const Arc& arc, double time) {
  planned_.clear();
  for (int s = 0; s < kHall; ++s) {
    if (signal_[s].noise > 0) {
      search_noisy(s, arc, time);
    } else {
      search_quiet(s, arc, time);
    }
  }
  for (int k = 0; k < 3; ++k) search_hall(k, arc, time);
  if (planned_.size() > 1) {
    std::stable_sort(planned_.begin(), planned_.end(),
                     [](const Change& a, const Change& b) { return a.crossing < b.crossing; });
  }
  reach(time);
}

void Sensors::search_quiet(int signal, const Arc& arc, double time) {
  const Comparator& comparator = signal_[signal];
  const auto& points = arc.points();
  bool level = level_[signal];
  for (int p = 0; p < 3; ++p) {
    const double x = input(signal, points[p]);
    if (decide(x, level, comparator) == level) continue;
    double at = 0;
    if (p > 0) {
      const double sign = level ? 1 : -1;  // of a margin that falls below zero at the crossing
      const double threshold = comparator.offset - sign * comparator.hysteresis / 2;
      const auto margin = [&](double input) { return sign * (input - threshold); };
      const Point& before = points[p - 1];
      at = falls_below_zero([&](double t) { return margin(this->input(signal, arc.point(t))); },
                            before.elapsed, margin(input(signal, before)), points[p].elapsed,
                            margin(x), kEventTolerance);
    }
    level = !level;
    add(signal, time + at, level);
  }
}

void Sensors::search_noisy(int signal, const Arc& arc, double time) {
  const Comparator& comparator = signal_[signal];
  const auto& points = arc.points();
  const double length = arc.length();
  const double begin = input(signal, points[0]), middle = input(signal, points[1]),
               end = input(signal, points[2]);
  bool level = level_[signal];

  const double band = comparator.hysteresis / 2 + kFarthestNoise * comparator.noise;
  const double high = std::max({begin, middle, end}) - comparator.offset;
  const double low = std::min({begin, middle, end}) - comparator.offset;
  if (low > band || high < -band) {
    const bool above = low > band;
    if (level != above) add(signal, time, above);
    return;
  }

  const auto smooth = [&](double elapsed) {  // parabola through the three points
    const double c = elapsed / length;
    return begin + c * ((4 * middle - 3 * begin - end) + c * 2 * (begin + end - 2 * middle));
  };
  std::int64_t cell = whole_below(time / comparator.noise_interval);
  for (double from = 0; from < length; ++cell) {
    const double next = static_cast<double>(cell + 1) * comparator.noise_interval - time;
    const double to = std::min(next, length);
    if (to <= from) continue;
    const double noise = comparator.noise * gaussian(seed_, signal, cell);
    const double first = smooth(from) + noise, last = smooth(to) + noise;
    if (decide(first, level, comparator) != level) add(signal, time + from, level = !level);
    if (decide(last, level, comparator) != level) {
      const double half = comparator.hysteresis / 2;
      const double threshold = comparator.offset + (level ? -half : half);
      const double share = (threshold - first) / (last - first);
      add(signal, time + from + std::clamp(share, 0.0, 1.0) * (to - from), level = !level);
    }
    from = to;
  }
}

void Sensors::search_hall(int hall, const Arc& arc, double time) {
  const auto& points = arc.points();
  bool level = level_[kHall + hall];
  if (hall_level(hall, points[0]) != level) add(kHall + hall, time, level = !level);
  // At most a third of a right angle per arc, so one edge at most.
  if (hall_level(hall, points[2]) == level) return;
  const double half_turn = kTurn / 2;
  const double direction = arc.regime().direction;
  const double from = (points[0].y[kAngle] - hall_edge_[hall]) / half_turn;
  const double edge =
      static_cast<double>(whole_below(from) + (direction > 0)) * half_turn + hall_edge_[hall];
  const auto left = [&](const Variables& y) { return direction * (edge - y[kAngle]); };
  const double at =
      falls_below_zero([&](double t) { return left(arc.at(t)); }, 0, left(points[0].y),
                       arc.length(), left(points[2].y), kEventTolerance);
  add(kHall + hall, time + at, !level);
}

void Sensors::add(int signal, double crossing, bool level) {
  planned_.push_back({crossing, crossing + delay_[signal], signal, level});
}

void Sensors::apply(const Change& change) {
  if (change.signal < kLimit) {
    pins_.comparator[change.signal] = change.level;
  } else if (change.signal == kLimit) {
    pins_.limit = change.level;
  } else {
    pins_.hall[change.signal - kHall] = change.level;
  }
}

void Sensors::reach(double time) {
  auto crossed = planned_.begin();
  for (; crossed != planned_.end() && crossed->crossing <= time; ++crossed) {
    level_[crossed->signal] = crossed->level;
    const auto later = [&](const Change& c) { return c.arrival > crossed->arrival; };
    underway_.insert(std::find_if(underway_.begin(), underway_.end(), later), *crossed);
  }
  planned_.erase(planned_.begin(), crossed);

  auto arrived = underway_.begin();
  for (; arrived != underway_.end() && arrived->arrival <= time; ++arrived) apply(*arrived);
  underway_.erase(underway_.begin(), arrived);

  next_ = underway_.empty() ? kNever : underway_.front().arrival;
  for (const Change& change : planned_) next_ = std::min(next_, change.arrival);
}

}  // namespace steplock::plant
