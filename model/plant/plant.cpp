#include "model/plant/plant.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/plant/arc.hpp"
#include "model/plant/dynamics.hpp"
#include "model/plant/sensors.hpp"

namespace steplock::plant {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

Parameters checked(const Parameters& parameters) {
  std::string lines;
  for (const std::string& problem : validate(parameters)) {
    lines += (lines.empty() ? "" : "\n") + problem;
  }
  require(lines.empty(), lines.c_str());
  return parameters;
}

}  // namespace

// The present arc begins at `arc_start`; the plant itself stands at `now`, somewhere on it.
struct Plant::Core {
  Core(const Parameters& p, const InitialState& initial)
      : parameters(checked(p)), dynamics(parameters), sensors(parameters.sensing) {
    inputs.opposing_torque = p.load.opposing_torque;
    inputs.active_torque = p.load.active_torque;
    inputs.breakaway_torque = p.load.breakaway_torque;
    inputs.source_voltage = p.bus.voltage;
    const Phases& i = initial.current;
    const double sum = i[0] + i[1] + i[2];
    require(std::abs(sum) <= 1e-9 * (1 + std::abs(i[0]) + std::abs(i[1])),
            "initial currents must sum to zero");
    // A stiff bus has no state of its own.
    const bool own = initial.bus_voltage >= 0 && p.bus.resistance > 0;
    start({i[0], i[1], -i[0] - i[1], initial.speed, initial.angle * dynamics.pole_pairs(),
           own ? initial.bus_voltage : p.bus.voltage, dynamics.springs() ? initial.speed : 0, 0});
  }

  void start(Variables y) {
    take_out_turns(y);
    plan_from(y);
    stored_at_start = dynamics.stored(arc.regime(), y).stored();
    sensors.start(arc);
    search();
  }

  void plan_from(const Variables& y) {
    arc_start = now;
    const Regime regime = dynamics.regime(y, inputs, turns);
    if (regime.turning != 0) inputs.breakaway_torque = 0;
    steps += arc.plan(dynamics, regime, y, parameters.accuracy, next_step);
    arc_end = arc_start + arc.length();
  }

  void search() {
    sensors.search(arc, arc_start);
    next_event = std::min(arc_end, sensors.next_change());
  }

  // Leaves the present arc at `now`.
  Variables leave() {
    const double elapsed = now < arc_end ? now - arc_start : arc.length();
    const Powers energies = arc.energies(elapsed);
    for (std::size_t k = 0; k < spent.size(); ++k) spent[k] += energies[k];
    Variables y = arc.settled(elapsed);
    take_out_turns(y);
    return y;
  }

  // Keeps the electrical angle in [0, one turn), so that it stays exact however long the run.
  void take_out_turns(Variables& y) {
    const auto whole = static_cast<double>(whole_below(y[kAngle] / kTurn));
    turns += whole;
    y[kAngle] -= whole * kTurn;
  }

  void replan() {
    Variables y = leave();
    if (parameters.bus.resistance == 0) y[kBus] = inputs.source_voltage;
    plan_from(y);
    search();
  }

  void advance_to(double t) {
    while (t >= arc_end) {
      now = arc_end;
      sensors.reach(now);
      plan_from(leave());
      search();
    }
    now = t;
    sensors.reach(now);
    next_event = std::min(arc_end, sensors.next_change());
  }

  Parameters parameters;
  Dynamics dynamics;
  Sensors sensors;
  Inputs inputs;
  Arc arc;
  double arc_start = 0, arc_end = 0, now = 0, next_event = 0;
  double next_step = 1e-6;
  double turns = 0;  // whole electrical turns taken out of the angle
  Powers spent = {};
  double coupled_inertia = 0;
  double stored_at_start = 0;
  std::uint64_t steps = 0, shoot_throughs = 0;
};

Plant::Plant(const Parameters& parameters, const InitialState& initial)
    : core_(std::make_unique<Core>(parameters, initial)) {}
Plant::Plant(Plant&&) noexcept = default;
Plant& Plant::operator=(Plant&&) noexcept = default;
Plant::~Plant() = default;

double Plant::time() const { return core_->now; }
const Pins& Plant::pins() const { return core_->sensors.pins(); }
double Plant::next_event() const { return core_->next_event; }
const Gates& Plant::gates() const { return core_->inputs.gates; }
std::uint64_t Plant::shoot_throughs() const { return core_->shoot_throughs; }
std::uint64_t Plant::steps() const { return core_->steps; }

void Plant::advance_to(double t) {
  if (t < core_->next_event && t >= core_->now) {
    core_->now = t;
    return;
  }
  require(t >= core_->now, "the plant cannot go back in time");
  core_->advance_to(t);
}

void Plant::set_gates(const Gates& gates) {
  const Gates before = core_->inputs.gates;
  if (gates == before) return;
  const auto legs = [](const Gates& g) {
    return std::array{g.uh && g.ul, g.vh && g.vl, g.wh && g.wl};
  };
  const auto was = legs(before), is = legs(gates);
  for (int k = 0; k < 3; ++k) core_->shoot_throughs += is[k] && !was[k];
  core_->inputs.gates = gates;
  core_->replan();
}

void Plant::set_load_torque(double opposing) {
  require(opposing >= 0, "an opposing load torque is not negative; use set_active_torque");
  if (opposing == core_->inputs.opposing_torque) return;
  core_->inputs.opposing_torque = opposing;
  core_->replan();
}

void Plant::set_active_torque(double torque) {
  require(std::isfinite(torque), "the active torque must be finite");
  if (torque == core_->inputs.active_torque) return;
  core_->inputs.active_torque = torque;
  core_->replan();
}

void Plant::set_bus_voltage(double source) {
  require(source > 0, "the bus voltage must be above 0");
  if (source == core_->inputs.source_voltage) return;
  core_->inputs.source_voltage = source;
  core_->replan();
}

void Plant::set_limit_threshold(double amps) {
  require(amps > 0, "the current limit must be above 0");
  core_->sensors.set_limit_threshold(amps);
  core_->replan();
}

void Plant::set_coupled_inertia(double inertia) {
  require(inertia >= 0, "a coupled inertia is not negative");
  Core& core = *core_;
  if (inertia == core.coupled_inertia) return;
  const double speed = state().speed;
  core.stored_at_start += 0.5 * (inertia - core.coupled_inertia) * speed * speed;
  core.coupled_inertia = inertia;
  core.dynamics.couple(inertia);
  core.replan();
}

void Plant::set_open(int k, bool open) {
  require(k >= 0 && k < 3, "a winding is 0, 1 or 2");
  if (open == core_->inputs.open[static_cast<std::size_t>(k)]) return;
  core_->inputs.open[static_cast<std::size_t>(k)] = open;
  core_->replan();
}

State Plant::state() const {
  const Core& core = *core_;
  const double elapsed = core.now - core.arc_start;
  const Point point = core.arc.point(elapsed);
  const Regime& regime = core.arc.regime();
  State s;
  s.time = core.now;
  s.current = {point.y[kIu], point.y[kIv], point.y[kIw]};
  s.voltage = point.out.terminals.voltage;
  s.neutral = point.out.terminals.neutral;
  s.virtual_neutral = (s.voltage[0] + s.voltage[1] + s.voltage[2]) / 3;
  s.emf = point.out.emf;
  s.bus_voltage = point.y[kBus];
  s.source_current = point.out.source_current;
  s.shunt_current = point.out.bridge_current;
  s.torque = point.out.torque;
  s.speed = point.y[kSpeed];
  s.electrical_angle = core.turns * kTurn + point.y[kAngle];
  s.angle = s.electrical_angle / core.dynamics.pole_pairs();
  s.stuck = regime.turning == 0;
  for (int k = 0; k < 3; ++k) s.floating[k] = regime.circuit.on[k] == 0;

  const Powers recent = core.arc.energies(elapsed);
  const auto spent = [&](Power p) { return core.spent[p] + recent[p]; };
  s.energy = core.dynamics.stored(regime, point.y);
  s.energy.supplied = spent(kSupplied);
  s.energy.copper = spent(kCopper);
  s.energy.bridge = spent(kBridge);
  s.energy.bus_resistance = spent(kBusResistance);
  s.energy.friction = spent(kFriction);
  s.energy.load = spent(kLoad);
  s.energy.stored_at_start = core.stored_at_start;
  return s;
}

}  // namespace steplock::plant
