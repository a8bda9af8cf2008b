#include "testbench/run/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/design/design.hpp"
#include "model/design/sinusoidal/design.hpp"
#include "testbench/run/units.hpp"

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

// N m, at any angle, of the drive's most current and of the motor's rated one.
struct Torque {
  double most = 0, rated = 0;
};
Torque torque_of(const design::Settings& s) {
  if (s.drive.kind == design::DriveKind::kSixStep) {
    const double k_e = design::motor_constants(s).k_e;
    return {k_e * s.sensors.limit_a, k_e * s.motor.rated_current_a};
  }
  const double k_t = 1.5 * s.motor.pole_pairs * s.motor.flux_vs;
  return {k_t * design::sinusoidal::design_drive(s).parameters.speed.limit, k_t * s.motor.rated_current_a};
}

}  // namespace

std::string ends_too_soon(const design::Settings& s, const Gaining& g) {
  const double missing = s.scenario.speed_rpm * (1 - 0.01 * kSpeedTolerancePercent) - g.to_rpm;
  const double gains = (g.to_rpm - g.from_rpm) / (g.to_s - g.from_s);
  // As much as it lacks within the time that it had: else it is something else that holds it.
  if (!(g.to_s > g.from_s) || missing <= 0 || !(gains * g.to_s > missing)) return {};
  const auto& n = s.scenario;
  std::string key = "duration_s";
  double first = n.duration_s;
  for (const auto& [name, at] : {std::pair{"load_step_s", n.load_step_s}, {"inertia_step_s", n.inertia_step_s}, {"reverse_s", n.reverse_s},
                                 {"stop_s", n.stop_s}}) {
    if (at && *at < first) key = name, first = *at;
  }
  // A swing about the end of the ramp, and as long again for the mean that is judged.
  const double until = g.to_s + 2 * missing / gains + 0.5 * g.to_s;
  return fmt::format("the rotor still gains {:.3g} r/min a second and is at {:.0f} of {:.0f}: raise scenario.{} to {:.2g}{}", gains, g.to_rpm, n.speed_rpm, key,
                     until, key == "duration_s" ? "" : ", and what follows by as much");
}

std::string load_step_beyond(const design::Settings& s) {
  if (!s.scenario.load_step_s) return {};
  const double speed = s.scenario.speed_rpm * std::numbers::pi / 30;
  const double own = s.motor.coulomb_nm + s.motor.viscous_nms * speed + s.load.opposing_nm + s.load.fan_nms2 * speed * speed;
  const auto [most, rated] = torque_of(s);
  const double step = design::load_step_torque(s);
  if (step + own <= most || own >= most) return {};
  // What is left would do for a load that comes slowly; a step stops a light rotor before speed control sees it.
  return fmt::format("the load step asks for {:.3g} N m beside {:.3g} of friction and load, and the limit's current gives {:.3g}: lower "
                     "scenario.load_step_nm to {:.2g}, or raise sensors.limit_a", step, own, most,
                     std::min(0.8 * (most - own), rated / 2));
}

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
