#include "testbench/drive/six_step/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/design/design.hpp"
#include "testbench/run/advice.hpp"

namespace steplock {
namespace {

// The least part of the current's torque that one of three steps gives at any angle (hls/six_step/follow_law.hpp).
constexpr double kWorstStep = 0.87;

std::string held_at_rest(const design::Settings& s) {
  const double holds = std::max(s.motor.coulomb_nm, s.motor.static_nm.value_or(0)) + s.load.breakaway_nm + s.load.opposing_nm;
  const auto motor = design::motor_constants(s);
  const double gives = kWorstStep * motor.k_e * s.sensors.limit_a;
  if (holds <= gives) return {};
  // Twice, since a start drives for a part of the time alone; and of the bus a part is left for the back-EMF.
  const double needed = 2 * holds / (kWorstStep * motor.k_e), most = 0.6 * s.inverter.bus_v / motor.r_loop;
  const std::string cause = fmt::format("friction and load hold the rotor with {:.3g} N m, and {:.3g} A move {:.3g} N m at the worst angle: ", holds,
                                        s.sensors.limit_a, gives);
  if (needed <= most) return cause + fmt::format("raise sensors.limit_a to {:.3g}", needed);
  return cause + fmt::format("it takes {:.3g} A to start that, and this bus is good for {:.3g}; the load has to be less than {:.3g} N m", needed,
                             most, kWorstStep * motor.k_e * most / 2);
}

// Between two looks a rotor at rest gains so little that comparators keep what the freewheeling left: they tell no sector.
std::string hidden_by_hysteresis(const design::Settings& s) {
  if (s.drive.kind != design::DriveKind::kSixStep || s.start.method != design::Method::kFollow) return {};
  const auto d = design::design_drive(s);
  const double current = std::min(s.sensors.limit_a, s.inverter.bus_v / d.motor.r_loop);
  const double torque = d.motor.k_e * current - s.motor.coulomb_nm - s.load.opposing_nm;
  // V, of a phase at its peak.
  const double gives = s.motor.pole_pairs * s.motor.flux_vs * torque * d.parameters.start.probe / d.motor.inertia;
  if (gives <= 0 || s.sensors.comparator_hysteresis_v <= gives) return {};
  return fmt::format("one drive of the start gives a rotor at rest {:.2g} V of back-EMF, less than the comparators' hysteresis: lower "
                     "sensors.comparator_hysteresis_v to {:.2g}", gives, gives / 2);  // offset and noise want their part
}

// One that brakes by nothing but friction keeps the speed that it has.
std::string runs_on(const design::Settings& s, const Summary& sum) {
  const double too_fast = sum.steady.error_percent * (sum.set_speed_rpm < 0 ? -1 : 1);
  if (s.control.chopping != design::Chopping::kHighSide || too_fast < kSpeedTolerancePercent) return {};
  return "with control.chopping = \"high_side\" nothing but friction brakes a rotor, and this one has little: write \"complementary\", or the "
         "friction that it has as motor.coulomb_nm";
}

std::string bus_gives_no_more(const Summary& sum, const Record& record) {
  double duty = 1;
  for (const Sample& x : record.overview) {
    if (x.time >= sum.steady.from_s && x.time <= sum.steady.to_s) duty = std::min(duty, x.drive.duty);
  }
  const double reached = std::abs(sum.steady.mean_rpm);
  if (duty < 0.98 || reached <= 0 || reached > 0.995 * std::abs(sum.set_speed_rpm)) return {};
  return fmt::format("the drive takes all of the bus and turns {:.0f} r/min: lower scenario.speed_rpm to {:.0f}, or raise inverter.bus_v", reached,
                     0.95 * reached);
}

}  // namespace

std::vector<std::string> advice(const design::Settings& s, const Summary& sum, const Record& record) {
  std::vector<std::string> all;
  if (sum.interrupted || sum.failures().empty()) return all;
  const double lock = sum.lock_time_s.value_or(0);
  const std::string bus = bus_gives_no_more(sum, record);
  const bool under_way = sum.lock_time_s && sum.lost_locks == 0 && bus.empty();
  std::string late;
  if (under_way) late = ends_too_soon(s, gaining(record.overview, lock, sum.steady.to_s, sum.set_speed_rpm));
  for (const std::string& line :
       {sum.lock_time_s ? std::string() : held_at_rest(s), hidden_by_hysteresis(s), runs_on(s, sum), bus, late, load_step_beyond(s)}) {
    if (!line.empty()) all.push_back(line);
  }
  return all;
}

}  // namespace steplock
