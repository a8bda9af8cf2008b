#include "testbench/drive/six_step/recorder.hpp"

#include "testbench/run/units.hpp"

namespace steplock {

const WaveTable& SixStepRecording::wave() {
  static const WaveTable kTable = {
      .logic = {{"step", 3}, {"locked", 1}, {"crossing", 1}, {"missed", 1}},
      .pins = true,
      .analog = {"iu_a", "iv_a", "iw_a", "vu_v", "vv_v", "vw_v", "neutral_v", "bus_v", "torque_mnm", "load_mnm",
                 "theta_deg", "speed_rpm", "drive_speed_rpm", "duty_percent", "phase_error_deg"}};
  return kTable;
}

void SixStepRecording::trace_logic(TraceWriter& to, const Sample& s) const {
  to.logic(s.time, s.watch.gate_bits(),
           {static_cast<std::uint32_t>(s.watch.step()), s.watch.locked(), s.watch.crossing(), s.watch.missed()},
           name_of(s.watch.state()), name_of(s.watch.reason()));
}

void SixStepRecording::trace_analog(TraceWriter& to, const Sample& s) const {
  const plant::State& p = s.plant;
  to.analog(s.time, {p.current[0], p.current[1], p.current[2], p.voltage[0], p.voltage[1], p.voltage[2],
                     p.neutral, p.bus_voltage, 1e3 * p.torque, 1e3 * s.load_nm, turn_of(p.electrical_angle),
                     rpm(p.speed), rpm_of_steps(s.drive.steps_per_second, to.pole_pairs()), 100 * s.drive.duty,
                     s.drive.phase_error_deg});
}

template class RecorderOf<SixStepRecording>;

}  // namespace steplock
