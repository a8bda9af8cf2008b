#include "testbench/sweep/conditions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/design/design.hpp"
#include "model/design/sinusoidal/design.hpp"
#include "testbench/run/timeline.hpp"

namespace steplock {
namespace {

// Numbers of the quantities in Draw.  A new one takes a new number, so that old seeds keep their runs.
enum Quantity : std::uint64_t {
  kAngle, kLoad, kInertia, kBus, kResistance, kInductance, kFlux, kOffset, kOffsetU, kOffsetV, kOffsetW,
  kNoise, kDelay, kSpins, kSpeed, kNoiseSeed, kWhatBeyond, kWhichSide, kHowFar
};

using Range = std::array<double, 2>;

// Outside the envelope: this far beyond the range's end, drawn evenly by ratio.
constexpr Range kBeyond = {1.3, 4};
// Times the highest dry load, or the rated torque if there is none: up to a blocked rotor.
constexpr Range kBeyondLoad = {1.5, 6};

constexpr auto kLeaves = std::to_array<Quantity>(
    {kLoad, kInertia, kBus, kResistance, kInductance, kFlux, kOffset, kNoise, kSpeed});

bool sinusoidal(const design::Settings& s) { return s.drive.kind == design::DriveKind::kSinusoidal; }

// A sinusoidal drive whose envelope has no rotor that turns is not judged by one.
Quantity what_leaves(const design::Settings& s, const Draw& draw) {
  const std::size_t spared = sinusoidal(s) && s.envelope.spinning == 0;
  return kLeaves[draw.below(kWhatBeyond, kLeaves.size() - spared)];
}

// Of a current ADC, to which the envelope's factor applies: part of its range.
constexpr double kConverterOffset = 0.01;

class Drawing {
 public:
  Drawing(const design::Settings& s, const design::EnvelopeSection& e, RunSeed seed)
      : envelope_(e), draw_(seed.value), outside_(seed.outside()), leaves_(what_leaves(s, draw_)) {}

  double within(Quantity q, const Range& r) const { return draw_.uniform(q, r[0], r[1]); }
  bool leaves(Quantity q) const { return outside_ && leaves_ == q; }
  double beyond(const Range& how) const { return draw_.by_ratio(kHowFar, how[0], how[1]); }
  bool lower_side() const { return draw_.unit(kWhichSide) < 0.5; }

  // A factor of something that may be too small or too large.
  double factor(Quantity q, const Range& r, bool by_ratio = false) const {
    if (leaves(q)) return lower_side() ? r[0] / beyond(kBeyond) : r[1] * beyond(kBeyond);
    return by_ratio ? draw_.by_ratio(q, r[0], r[1]) : within(q, r);
  }
  // An imperfection, which can only be too large.
  double imperfection(Quantity q, const Range& r) const {
    return leaves(q) ? std::max(r[1], 1.0) * beyond(kBeyond) : within(q, r);
  }

  void load(Conditions& c) const {
    const std::size_t dry = envelope_.load.size();
    const bool fan = envelope_.fan > 0;
    const std::size_t k = draw_.below(kLoad, dry + fan);
    if (leaves(kLoad)) {
      const double most = dry > 0 ? *std::ranges::max_element(envelope_.load) : 0;
      c.load = (most > 0 ? most : 1) * beyond(kBeyondLoad);
    } else if (k < dry) {
      c.load = envelope_.load[k];
    } else {
      c.fan = envelope_.fan;
    }
  }

  double speed() const {
    const Range& r = envelope_.speed;
    if (leaves(kSpeed)) return (lower_side() ? r[0] : r[1]) * std::sqrt(beyond(kBeyond));
    return draw_.unit(kSpins) < envelope_.spinning ? within(kSpeed, r) : 0;
  }

  const Draw& draw() const { return draw_; }

 private:
  const design::EnvelopeSection& envelope_;
  Draw draw_;
  bool outside_;
  Quantity leaves_;
};

double greatest_offset(const design::SensorsSection& s) {
  double most = 0;
  for (const double o : s.comparator_offset_v) most = std::max(most, std::abs(o));
  return most;
}

}  // namespace

double rated_torque(const design::Settings& s) {
  if (sinusoidal(s)) return design::sinusoidal::design_drive(s).rated_torque;
  return design::motor_constants(s).k_e * s.motor.rated_current_a;
}

design::EnvelopeSection milder(const design::EnvelopeSection& e) {
  const auto half_way = [](const Range& r) { return Range{(1 + r[0]) / 2, (1 + r[1]) / 2}; };
  design::EnvelopeSection m = e;
  m.load.resize(std::min<std::size_t>(m.load.size(), 2));
  m.fan = e.fan / 2;
  m.inertia = {std::sqrt(e.inertia[0]), std::sqrt(e.inertia[1])};
  m.bus = half_way(e.bus);
  m.resistance = half_way(e.resistance);
  m.inductance = half_way(e.inductance);
  m.flux = half_way(e.flux);
  m.offset[1] = e.offset[1] / 2;
  m.noise[1] = e.noise[1] / 2;
  m.delay = half_way(e.delay);
  m.spinning = 0;
  return m;
}

Conditions draw_conditions(const design::Settings& s, RunSeed seed) {
  const design::EnvelopeSection e = seed.disturbed() ? milder(s.envelope) : s.envelope;
  const Drawing d(s, e, seed);
  Conditions c;
  c.angle_deg = d.draw().uniform(kAngle, 0, 360);
  d.load(c);
  c.inertia = d.factor(kInertia, e.inertia, true);
  c.bus = d.factor(kBus, e.bus);
  c.resistance = d.factor(kResistance, e.resistance);
  c.inductance = d.factor(kInductance, e.inductance);
  c.flux = d.factor(kFlux, e.flux);
  c.speed = d.speed();
  if (sinusoidal(s)) {
    const double most = d.imperfection(kOffset, e.offset) * kConverterOffset * design::sinusoidal::current_range(s);
    c.offset_u_a = d.draw().uniform(kOffsetU, -most, most);
    c.offset_v_a = d.draw().uniform(kOffsetV, -most, most);
    c.offset_w_a = d.draw().uniform(kOffsetW, -most, most);
    c.noise_a = d.imperfection(kNoise, e.noise) * s.adc.current_noise_a;
    return c;
  }
  const double offset = d.imperfection(kOffset, e.offset) * greatest_offset(s.sensors);
  c.offset_u_v = d.draw().uniform(kOffsetU, -offset, offset);
  c.offset_v_v = d.draw().uniform(kOffsetV, -offset, offset);
  c.offset_w_v = d.draw().uniform(kOffsetW, -offset, offset);
  c.noise_v = d.imperfection(kNoise, e.noise) * s.sensors.comparator_noise_v;
  c.delay_s = d.within(kDelay, e.delay) * s.sensors.comparator_delay_s;
  return c;
}

design::Settings settings_under(const design::Settings& file, const Conditions& c, RunSeed seed) {
  design::Settings s = file;
  const double rated = rated_torque(file);
  const double set = file.scenario.speed_rpm * std::numbers::pi / 30;
  s.motor.resistance_ohm *= c.resistance;
  s.motor.inductance_h *= c.inductance;
  s.motor.mutual_h *= c.inductance;
  if (s.motor.inductance_d_h) *s.motor.inductance_d_h *= c.inductance;
  if (s.motor.inductance_q_h) *s.motor.inductance_q_h *= c.inductance;
  s.motor.flux_vs *= c.flux;
  s.motor.inertia_kgm2 *= c.inertia;
  s.load.inertia_kgm2 *= c.inertia;
  s.load.opposing_nm += c.load * rated;
  s.load.fan_nms2 += c.fan * rated / (set * set);
  s.inverter.bus_v *= c.bus;
  s.sensors.comparator_offset_v = {c.offset_u_v, c.offset_v_v, c.offset_w_v};
  s.sensors.comparator_noise_v = c.noise_v;
  s.sensors.comparator_delay_s = c.delay_s;
  if (sinusoidal(file)) {
    // The ADCs' ranges are the drive's, whatever bus and motor it meets.
    s.adc.current_a = design::sinusoidal::current_range(file);
    s.adc.voltage_v = design::sinusoidal::voltage_range(file);
    s.adc.current_offset_a = {c.offset_u_a, c.offset_v_a, c.offset_w_a};
    s.adc.current_noise_a = c.noise_a;
  }
  s.sensors.seed = static_cast<int>(Draw(seed.value).bits(kNoiseSeed) >> 33);

  design::ScenarioSection& n = s.scenario;
  n.start_angle_deg = c.angle_deg;
  n.start_speed_rpm = c.speed * file.scenario.speed_rpm * (n.reverse ? -1 : 1);
  drop_events(n);
  return s;
}

}  // namespace steplock
