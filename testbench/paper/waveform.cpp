#include "testbench/paper/waveform.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace steplock {
namespace {

template <class F>
std::vector<Point> curve(const std::vector<Sample>& samples, F&& value) {
  std::vector<Point> all;
  for (const Sample& s : samples) all.push_back({s.time, value(s)});
  return all;
}

// Edges of the pulses of either sign.  A pulse has a dent where the other two phases commutate, so its
// edges are measured against its mean height, not against its peak.
void add_pulses(const std::vector<Point>& current, double amplitude, Waveform& w) {
  const double nothing = amplitude / 50;
  int pulses = 0;
  for (std::size_t i = 1; i < current.size();) {
    if (std::abs(current[i].y) <= nothing || std::abs(current[i - 1].y) > nothing) {
      ++i;
      continue;
    }
    const bool positive = current[i].y > 0;
    std::size_t end = i;
    double height = 0;
    while (end < current.size() && (current[end].y > 0) == positive &&
           std::abs(current[end].y) > nothing) {
      height += std::abs(current[end++].y);
    }
    height /= static_cast<double>(end - i);
    // A pulse cut off by the end of the record says nothing; nor does a spike of the freewheeling.
    if (end < current.size() && height > amplitude / 4) {
      const auto from = current.begin() + static_cast<std::ptrdiff_t>(i);
      const auto to = current.begin() + static_cast<std::ptrdiff_t>(end);
      const auto first = [&](double level) {
        return std::find_if(from, to, [=](const Point& p) { return std::abs(p.y) >= level; })->x;
      };
      const auto last = [&](double level) {
        return std::find_if(std::reverse_iterator(to), std::reverse_iterator(from),
                            [=](const Point& p) { return std::abs(p.y) >= level; })->x;
      };
      w.rise_s += first(0.9 * height) - first(0.1 * height);
      w.fall_s += last(0.1 * height) - last(0.9 * height);
      ++pulses;
    }
    i = end;
  }
  if (pulses > 0) {
    w.rise_s /= pulses;
    w.fall_s /= pulses;
  }
}

}  // namespace

std::vector<Point> averaged(const std::vector<Point>& points, double width) {
  if (points.size() < 2) return points;
  std::vector<double> area(points.size(), 0);  // up to each point, trapezoids
  for (std::size_t i = 1; i < points.size(); ++i) {
    area[i] = area[i - 1] +
              (points[i].x - points[i - 1].x) * (points[i].y + points[i - 1].y) / 2;
  }
  const auto area_to = [&](double x) {
    const auto after = std::ranges::lower_bound(points, x, {}, &Point::x);
    if (after == points.begin()) return 0.0;
    if (after == points.end()) return area.back();
    const auto i = static_cast<std::size_t>(after - points.begin());
    const double dx = x - points[i - 1].x, part = dx / (points[i].x - points[i - 1].x);
    const double y = points[i - 1].y + part * (points[i].y - points[i - 1].y);
    return area[i - 1] + dx * (points[i - 1].y + y) / 2;
  };
  std::vector<Point> result;
  for (const Point& p : points) {
    const double from = p.x - width / 2, to = p.x + width / 2;
    if (from < points.front().x || to > points.back().x) continue;
    result.push_back({p.x, (area_to(to) - area_to(from)) / width});
  }
  return result;
}

Waveform waveform(const std::vector<Sample>& samples, double pwm_s, int phase) {
  Waveform w;
  if (samples.size() < 3) return w;
  const auto k = static_cast<std::size_t>(phase);
  const auto current =
      averaged(curve(samples, [k](const Sample& s) { return s.plant.current[k]; }), pwm_s);
  const auto torque =
      averaged(curve(samples, [](const Sample& s) { return s.plant.torque; }), pwm_s);
  if (current.empty()) return w;
  for (const Point& p : current) w.amplitude = std::max(w.amplitude, std::abs(p.y));
  const auto squares = curve(samples, [k](const Sample& s) {
    return s.plant.current[k] * s.plant.current[k];
  });
  const double span = samples.back().time - samples.front().time;
  double area = 0;
  for (std::size_t i = 1; i < squares.size(); ++i) {
    area += (squares[i].x - squares[i - 1].x) * (squares[i].y + squares[i - 1].y) / 2;
  }
  w.rms = std::sqrt(area / span);
  add_pulses(current, w.amplitude, w);
  const auto [least, most] = std::ranges::minmax_element(torque, {}, &Point::y);
  for (const Point& p : torque) w.torque_mean += p.y / static_cast<double>(torque.size());
  w.torque_ripple = (most->y - least->y) / w.torque_mean;
  return w;
}

}  // namespace steplock
