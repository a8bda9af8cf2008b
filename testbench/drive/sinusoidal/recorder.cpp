#include "testbench/drive/sinusoidal/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

RotorCurrent rotor_current(const plant::State& s) {
  RotorCurrent i;
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = (north_pole_deg(s) - 120.0 * static_cast<double>(k)) * std::numbers::pi / 180;
    i.d += 2.0 / 3 * s.current[k] * std::cos(angle);
    i.q -= 2.0 / 3 * s.current[k] * std::sin(angle);
  }
  return i;
}

const WaveTable& Recording::wave() {
  static const WaveTable kTable = {
      .logic = {{"sample", 1}, {"locked", 1}, {"estimating", 1}},
      .pins = false,
      .analog = {"iu_a", "iv_a", "iw_a", "id_a", "iq_a", "vu_v", "vv_v", "vw_v", "neutral_v", "bus_v", "torque_mnm",
                 "load_mnm", "north_deg", "drive_deg", "delta_theta_deg", "speed_rpm", "drive_speed_rpm",
                 "reference_rpm", "i_gamma_a", "i_delta_a", "i_wanted_a"}};
  return kTable;
}

void Recording::change(StateChange& c, const plant::State& s, const View& view) const {
  c.angle_deg = north_pole_deg(s);
  c.mechanical_rad = s.angle;
  c.drive = view;
}

void Recording::pass(const plant::State& s, Record& record) const {
  if (s.time == 0) record.least_angle_rad = record.greatest_angle_rad = s.angle;
  record.least_angle_rad = std::min(record.least_angle_rad, s.angle);
  record.greatest_angle_rad = std::max(record.greatest_angle_rad, s.angle);
}

void Recording::follow(const plant::State& s, Watch was, Watch now, const View& view, Totals& totals) {
  if (!now.sample() || was.sample()) return;
  const auto error = error_.at_sample(s, view);
  if (!error) return;
  delta_deg_ = *error;
  totals.angle_deg += delta_deg_;
  totals.angle_squared += delta_deg_ * delta_deg_;
  ++totals.angles;
}

void Recording::trace_logic(TraceWriter& to, const Sample& s) const {
  to.logic(s.time, s.watch.gate_bits(), {s.watch.sample(), s.watch.locked(), s.drive.estimating},
           name_of(s.watch.state()), name_of(s.watch.reason()));
}

void Recording::trace_analog(TraceWriter& to, const Sample& s) const {
  const plant::State& p = s.plant;
  const RotorCurrent i = rotor_current(p);
  to.analog(s.time,
            {p.current[0], p.current[1], p.current[2], i.d, i.q, p.voltage[0], p.voltage[1], p.voltage[2],
             p.neutral, p.bus_voltage, 1e3 * p.torque, 1e3 * s.load_nm, north_pole_deg(p), s.drive.angle_deg,
             s.delta_theta_deg, rpm(p.speed), s.drive.speed_rpm, s.drive.reference_rpm, s.drive.i_gamma,
             s.drive.i_delta, s.drive.i_wanted});
}

}  // namespace steplock::sinusoidal

namespace steplock {
template class RecorderOf<sinusoidal::Recording>;
}
