#include "testbench/sinusoidal/recorder.hpp"

#include <algorithm>
#include <cmath>

#include "testbench/run/units.hpp"

namespace steplock::sinusoidal {

double north_pole_deg(const plant::State& s) {
  const double deg = degrees(s.electrical_angle) + 180;
  return deg - 360 * std::floor(deg / 360);
}

std::optional<double> AngleError::at_sample(const plant::State& s, const View& view) {
  std::optional<double> error;
  if (view.estimating && sampled_) error = std::remainder(sampled_deg_ - view.angle_deg, 360);
  sampled_deg_ = north_pole_deg(s);
  sampled_ = view.estimating;
  return error;
}

Recorder::Recorder(double duration_s, std::size_t samples)
    : interval_(duration_s / static_cast<double>(samples)) {}

// Currents as straight lines between gate edges, where they have their corners.
void Recorder::integrate(const plant::State& s) {
  double squares = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = last_current_[k], b = s.current[k];
    squares += (a * a + a * b + b * b) / 3;
    record_.peak_current = std::max(record_.peak_current, std::abs(b));
  }
  totals_.current_squared += (s.time - last_time_) * squares / 3;
  last_time_ = s.time;
  last_current_ = s.current;
  if (s.time == 0) record_.least_angle_rad = record_.greatest_angle_rad = s.angle;
  record_.least_angle_rad = std::min(record_.least_angle_rad, s.angle);
  record_.greatest_angle_rad = std::max(record_.greatest_angle_rad, s.angle);
}

void Recorder::changed(const plant::State& s, Watch was, Watch now, const View& view,
                       double load_nm) {
  integrate(s);
  if (now.state() != was.state() || now.reason() != was.reason()) {
    record_.changes.push_back(
        {s.time, now.state(), now.reason(), north_pole_deg(s), s.angle, view});
  }
  if (now.sample() && !was.sample()) {
    if (const auto error = error_.at_sample(s, view)) {
      delta_deg_ = *error;
      totals_.angle_deg += delta_deg_;
      totals_.angle_squared += delta_deg_ * delta_deg_;
      ++totals_.angles;
    }
  }
  if (s.time >= next_sample_) sample(s, now, view, load_nm);
}

void Recorder::sample(const plant::State& s, Watch w, const View& view, double load_nm) {
  integrate(s);
  record_.overview.push_back({.time = s.time, .plant = s, .drive = view, .watch = w,
                              .load_nm = load_nm, .delta_theta_deg = delta_deg_,
                              .totals = totals_});
  next_sample_ = std::max(next_sample_ + interval_, s.time);
}

}  // namespace steplock::sinusoidal
