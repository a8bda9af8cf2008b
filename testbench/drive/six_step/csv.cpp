#include "testbench/drive/six_step/csv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "testbench/run/units.hpp"

namespace steplock {

std::string samples_csv(const std::vector<Sample>& samples, int pole_pairs) {
  std::string text =
      "time_s,speed_rpm,drive_speed_rpm,iu_a,iv_a,iw_a,vu_v,vv_v,vw_v,neutral_v,bus_v,torque_nm,"
      "load_nm,theta_deg,step,state,duty,phase_error_deg,commutation_error_deg\n";
  for (const Sample& s : samples) {
    const plant::State& p = s.plant;
    const double theta = degrees(p.electrical_angle);
    fmt::format_to(
        std::back_inserter(text),
        "{:.9f},{:.6g},{:.6g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},"
        "{:.3f},{},{},{:.5g},{:.4g},{:.4g}\n",
        s.time, rpm(p.speed), rpm_of_steps(s.drive.steps_per_second, pole_pairs), p.current[0],
        p.current[1], p.current[2], p.voltage[0], p.voltage[1], p.voltage[2], p.neutral,
        p.bus_voltage, p.torque, s.load_nm, theta - 360 * std::floor(theta / 360), s.watch.step(),
        name_of(s.watch.state()), s.drive.duty, s.drive.phase_error_deg, s.commutation_error_deg);
  }
  return text;
}

}  // namespace steplock
