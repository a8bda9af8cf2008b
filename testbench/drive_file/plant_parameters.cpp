// From the sections of a drive file to the plant's parameters: the same numbers, other names.
#include "testbench/drive_file/drive_file.hpp"

#include <numbers>

#include "model/design/sinusoidal/design.hpp"

namespace steplock {

plant::Parameters plant_parameters(const design::Settings& s) {
  using Kind = plant::BackEmfShape::Kind;
  using Reference = plant::Sensing::Reference;
  plant::Parameters p;

  const auto& m = s.motor;
  p.motor.resistance = m.resistance_ohm;
  p.motor.inductance = m.inductance_h;
  p.motor.mutual = m.mutual_h;
  p.motor.inductance_d = m.inductance_d_h.value_or(0);
  p.motor.inductance_q = m.inductance_q_h.value_or(0);
  p.motor.saturation = m.saturation;
  p.motor.saturation_current = m.saturation_a;
  p.motor.flux = m.flux_vs;
  p.motor.pole_pairs = m.pole_pairs;
  switch (m.shape) {
    case design::Shape::kTrapezoidal: p.motor.shape.kind = Kind::kTrapezoidal; break;
    case design::Shape::kSinusoidal: p.motor.shape.kind = Kind::kSinusoidal; break;
    case design::Shape::kTable: p.motor.shape.kind = Kind::kTable; break;
  }
  p.motor.shape.flat_top_deg = m.flat_top_deg;
  p.motor.shape.rounded_flanks = m.rounded_flanks;
  p.motor.shape.table = m.table;
  p.motor.inertia = m.inertia_kgm2;
  p.motor.cogging_torque = m.cogging_nm;
  p.motor.cogging_periods = m.cogging_periods;
  p.motor.coulomb_friction = m.coulomb_nm;
  p.motor.static_friction = m.static_nm.value_or(m.coulomb_nm);
  p.motor.viscous_friction = m.viscous_nms;
  p.motor.fan_friction = s.load.fan_nms2;

  p.load.inertia = s.load.inertia_kgm2;
  p.load.opposing_torque = s.load.opposing_nm;
  constexpr double kPi = std::numbers::pi;
  p.load.breakaway_torque = s.load.breakaway_nm;
  p.load.unbalance_torque = s.load.unbalance_nm;
  p.load.unbalance_angle = s.load.unbalance_deg * kPi / 180;
  p.load.wind_speed = s.load.wind_rpm * kPi / 30;
  p.load.spring_stiffness = s.load.spring_nm_rad;
  p.load.spring_damping = s.load.spring_nms_rad;

  const auto& i = s.inverter;
  p.bus = {.voltage = i.bus_v, .resistance = i.bus_resistance_ohm,
           .capacitance = i.bus_capacitance_f, .sinks = i.bus_sinks};
  p.bridge = {.on_resistance = i.on_resistance_ohm, .diode_drop = i.diode_drop_v,
              .diode_resistance = i.diode_resistance_ohm};

  const auto& e = s.sensors;
  switch (e.reference) {
    case design::Reference::kVirtualNeutral: p.sensing.reference = Reference::kVirtualNeutral; break;
    case design::Reference::kHalfBus: p.sensing.reference = Reference::kHalfBus; break;
    case design::Reference::kStarPoint: p.sensing.reference = Reference::kStarPoint; break;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    p.sensing.comparator[k] = {.offset = e.comparator_offset_v[k],
                               .hysteresis = e.comparator_hysteresis_v,
                               .delay = e.comparator_delay_s,
                               .noise = e.comparator_noise_v,
                               .noise_interval = e.comparator_noise_interval_s};
  }
  p.sensing.limit_threshold = e.limit_a;
  p.sensing.limit.hysteresis = e.limit_hysteresis_a;
  p.sensing.limit.delay = e.limit_delay_s;
  p.sensing.hall_error_deg = e.hall_error_deg;
  p.sensing.hall_delay = e.hall_delay_s;
  p.sensing.seed = static_cast<std::uint64_t>(e.seed);

  p.accuracy = {.tolerance = s.accuracy.tolerance, .max_step = s.accuracy.max_step_s};
  return p;
}

plant::AdcParameters adc_parameters(const design::Settings& s) {
  const auto& a = s.adc;
  return {.bits = a.bits,
          .current_range = design::sinusoidal::current_range(s),
          .current_offset = a.current_offset_a,
          .current_noise = a.current_noise_a,
          .voltage_range = design::sinusoidal::voltage_range(s),
          .voltage_noise = a.voltage_noise_v,
          .seed = static_cast<std::uint64_t>(s.sensors.seed)};
}

plant::InitialState initial_state(const design::Settings& s, double angle_deg) {
  constexpr double kRadian = std::numbers::pi / 180;
  return {.angle = angle_deg * kRadian / s.motor.pole_pairs,
          .speed = s.scenario.start_speed_rpm * std::numbers::pi / 30};
}

}  // namespace steplock
