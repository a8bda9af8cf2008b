#include "testbench/sweep/disturbance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/design/design.hpp"

namespace steplock {
namespace {

// Numbers of the quantities in Draw, apart from those of the conditions.
enum Quantity : std::uint64_t {
  kKind = 100, kSize, kDuration, kSpeedBefore, kWait, kPlace, kPhase, kCouples
};

constexpr std::array<double, 2> kPulseTurns = {2, 100};
constexpr std::array<double, 2> kDipSeconds = {1e-3, 0.2};
constexpr double kWaitTurns = 6;
// A load below this part of the greatest is no disturbance.
constexpr double kLeast = 0.2;
constexpr double kDemagnetisingLoad = 0.5;  // part of the rated torque

// The load step, part of the rated torque, that takes `rate` of the rotor's speed per commutation step.
double step_of_rate(const design::Settings& file, const Conditions& c, double set_speed, double rate) {
  const double f = set_speed * design::steps_per_second(file, file.scenario.speed_rpm);
  const double speed = f / 6 * 2 * std::numbers::pi / file.motor.pole_pairs;
  const double inertia = (file.motor.inertia_kgm2 + file.load.inertia_kgm2) * c.inertia;
  return rate * speed * f * inertia / rated_torque(file);
}

}  // namespace

const char* name_of(Trouble t) {
  constexpr const char* kNames[kTroubles] = {
      "load_step", "load_pulse", "set_speed", "bus_dip", "stuck_steps", "stuck_for_good",
      "missing_crossing", "extra_crossing", "open_phase", "demagnetisation", "inertia"};
  return kNames[static_cast<int>(t)];
}

Disturbance draw_disturbance(const design::Settings& file, const Conditions& c, RunSeed seed) {
  const design::DisturbanceSection& most = file.disturbance;
  const Draw draw(seed.value);
  const double turn_s = 6 / design::steps_per_second(file, file.scenario.speed_rpm);
  const auto up_to = [&](double greatest) { return draw.uniform(kSize, kLeast * greatest, greatest); };
  // The last kind came later: it takes its share from the others, whose seeds mostly stay theirs.
  const bool couples = draw.unit(kCouples) < 1.0 / kTroubles;
  Disturbance d{.kind = couples ? Trouble::kInertia : static_cast<Trouble>(draw.below(kKind, kTroubles - 1)),
                .set_speed = draw.uniform(kSpeedBefore, most.set_speed[0], most.set_speed[1]),
                .wait_turns = draw.uniform(kWait, 0, kWaitTurns),
                .place = draw.unit(kPlace),
                .phase = static_cast<int>(draw.below(kPhase, 3))};
  const double load = std::min(most.load_step, step_of_rate(file, c, d.set_speed, most.load_rate));
  switch (d.kind) {
    case Trouble::kLoadStep: d.size = up_to(load); break;
    case Trouble::kLoadPulse:
      d.size = up_to(load);
      d.duration_s = turn_s * draw.by_ratio(kDuration, kPulseTurns[0], kPulseTurns[1]);
      break;
    case Trouble::kSetSpeed:
      d.size = draw.uniform(kSize, most.set_speed[0], most.set_speed[1]);
      break;
    case Trouble::kBusDip:
      d.size = up_to(most.bus_dip);
      d.duration_s = draw.by_ratio(kDuration, kDipSeconds[0], kDipSeconds[1]);
      break;
    case Trouble::kStuckSteps:
      d.size = 1 + static_cast<double>(draw.below(kSize, static_cast<std::uint64_t>(most.stuck_steps)));
      break;
    case Trouble::kStuckForGood:
    case Trouble::kMissingCrossing: d.size = static_cast<double>(draw.below(kSize, 2)); break;
    case Trouble::kExtraCrossing: d.size = draw.by_ratio(kSize, 0.002, 1); break;
    case Trouble::kOpenPhase: d.size = d.phase; break;
    case Trouble::kDemagnetisation: d.size = up_to(most.demagnetisation_deg); break;
    case Trouble::kInertia: d.size = draw.uniform(kSize, 1, most.inertia_step); break;
  }
  d.steps_per_s = speed_after(file, d);
  return d;
}

// A phase that the high side leaves freewheels against its low diode.  The star point stands at a third
// of the phase's back-EMF E then, so that 4/3 E takes the current down: L di/dt = -4/3 E.  (One that the
// low side leaves has two thirds of the bus, and is quicker.)
double inductance_for(const design::Settings& under, const Disturbance& d) {
  const double k_e = design::motor_constants(under).k_e;
  const double amps = kDemagnetisingLoad * under.motor.rated_current_a +
                      (under.motor.coulomb_nm + under.load.opposing_nm) / k_e;
  const double hertz = d.set_speed * design::steps_per_second(under, under.scenario.speed_rpm) / 6;
  const double emf = k_e / 2 * 2 * std::numbers::pi * hertz / under.motor.pole_pairs;
  const double henry = d.size / 360 / hertz * 4 / 3 * emf / amps;
  return henry / (under.motor.inductance_h - under.motor.mutual_h);
}

double speed_after(const design::Settings& file, const Disturbance& d) {
  const auto& speeds = file.disturbance.set_speed;
  const double part = d.kind == Trouble::kSetSpeed   ? d.size
                      : d.kind == Trouble::kInertia ? std::lerp(speeds[0], speeds[1], d.place)
                                                     : d.set_speed;
  return part * design::steps_per_second(file, file.scenario.speed_rpm);
}

std::uint64_t add_disturbance(Timeline& t, std::vector<PinFault>& faults, const Disturbance& d,
                              const design::Settings& file, const design::Settings& under,
                              std::uint64_t clock) {
  const double clock_hz = file.control.clock_hz;
  const double step_s = 1 / (d.set_speed * design::steps_per_second(file, file.scenario.speed_rpm));
  const auto clocks = [&](double s) { return static_cast<std::uint64_t>(std::llround(s * clock_hz)); };
  const std::uint64_t from = clock + 1 + clocks(6 * d.wait_turns * step_s);
  const Event before = t.events.back();
  Event event = before;
  event.clock = from;
  event.what = name_of(d.kind);
  PinFault fault{.from = from};
  const auto torque = [&](double part) { event.load_nm += part * rated_torque(file); };
  const auto level = [&] { return d.size != 0 ? PinFault::Kind::kHigh : PinFault::Kind::kLow; };
  switch (d.kind) {
    case Trouble::kLoadStep:
    case Trouble::kLoadPulse: torque(d.size); break;
    case Trouble::kDemagnetisation: torque(kDemagnetisingLoad); break;
    case Trouble::kInertia:
      event.inertia_kgm2 = (d.size - 1) * (under.motor.inertia_kgm2 + under.load.inertia_kgm2);
      event.command.set_speed = speed_after(file, d);
      break;
    case Trouble::kSetSpeed: event.command.set_speed = speed_after(file, d); break;
    case Trouble::kBusDip: event.source_v = (1 - d.size) * under.inverter.bus_v; break;
    case Trouble::kOpenPhase: event.open[static_cast<std::size_t>(d.phase)] = true; break;
    case Trouble::kStuckSteps:
      fault.comparator = d.phase;
      fault.steps = static_cast<int>(d.size);
      // A drive that has lost the rotor commutates no more.
      fault.clocks = clocks(4 * d.size * step_s);
      break;
    case Trouble::kStuckForGood:
      fault.comparator = d.phase;
      fault.kind = level();
      break;
    case Trouble::kMissingCrossing:
      fault.at_commutation = true;
      fault.kind = level();
      fault.steps = 1;
      fault.clocks = clocks(4 * step_s);
      break;
    case Trouble::kExtraCrossing:
      fault.at_commutation = true;
      fault.kind = PinFault::Kind::kInverted;
      fault.delay = clocks(d.place * step_s);
      fault.clocks = std::max<std::uint64_t>(1, clocks(d.size * step_s));
      break;
  }
  t.events.push_back(event);
  if (d.duration_s > 0) {
    Event back = before;
    back.clock = from + std::max<std::uint64_t>(1, clocks(d.duration_s));
    back.what = std::string(name_of(d.kind)) + " ends";
    back.source_v = under.inverter.bus_v;
    t.events.push_back(back);
  }
  const bool pins = d.kind == Trouble::kStuckSteps || d.kind == Trouble::kStuckForGood ||
                    d.kind == Trouble::kMissingCrossing || d.kind == Trouble::kExtraCrossing;
  if (pins) faults.push_back(fault);
  return from;
}

}  // namespace steplock
