// The one table of a drive file's keys: section, name, unit, range and meaning of each member of
// Settings.  Whoever loads, checks, prints or documents settings walks it:
//
//     for_each_key(settings, [](const Key& key, auto& value) { ... });
//
// `value` is one of double, int, bool, std::string, an enum (its words: enum_words(value)),
// std::vector<double>, std::vector<std::string>, std::array<double, 2 or 3>,
// std::optional<double>.
// A range holds for numbers, and for each element of a list; a required key has no default.
//
// Doc: docs/design.md   Test: tests/model/design/settings_test.cpp
#pragma once

#include <array>
#include <limits>
#include <string_view>

#include "model/design/settings.hpp"
#include "model/design/sweep_keys.hpp"

namespace steplock::design {

struct Key {
  std::string_view section, name, unit, about;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool required = false;
};

// The words of an enum in a file, in the order of its enumerators.
constexpr auto enum_words(Shape) { return std::to_array({"trapezoidal", "sinusoidal", "table"}); }
constexpr auto enum_words(Reference) {
  return std::to_array({"virtual_neutral", "half_bus", "star_point"});
}
constexpr auto enum_words(Chopping) { return std::to_array({"high_side", "complementary"}); }
constexpr auto enum_words(Source) { return std::to_array({"bemf", "hall"}); }
constexpr auto enum_words(Method) { return std::to_array({"ramp", "follow"}); }
constexpr auto enum_words(Sampling) { return std::to_array({"on_time", "off_time", "both"}); }
constexpr auto enum_words(Detector) { return std::to_array({"once_per_turn", "every_step"}); }
constexpr auto enum_words(DriveKind) { return std::to_array({"six_step", "sinusoidal"}); }
constexpr auto enum_words(Estimator) { return std::to_array({"voltage", "current"}); }
constexpr auto enum_words(Modulation) { return std::to_array({"space_vector", "sine"}); }
constexpr auto enum_words(StartBy) { return std::to_array({"pattern", "arbitrary", "pilot"}); }
constexpr auto enum_words(LoopForm) { return std::to_array({"per_second", "per_step"}); }

// Sections that belong to one kind of drive alone; the others serve both.
constexpr bool belongs(std::string_view section, DriveKind kind) {
  for (const std::string_view s : {"loop", "start", "speed", "protection", "hardship"}) {
    if (section == s) return kind == DriveKind::kSixStep;
  }
  for (const std::string_view s :
       {"adc", "sinusoidal", "sinusoidal_start", "sinusoidal_protection"}) {
    if (section == s) return kind == DriveKind::kSinusoidal;
  }
  return true;
}
// And keys of a section that serves both.
constexpr bool belongs(std::string_view section, std::string_view key, DriveKind kind) {
  return section != "envelope" || key != "delay" || kind == DriveKind::kSixStep;
}

// S is Settings or const Settings.
template <class S, class Visitor>
void for_each_key(S& s, Visitor&& visit) {
  constexpr bool required = true;
  const char* section = "drive";
  const auto k = [&](const char* name, auto& value, const char* unit, const char* about,
                     double low = 0, double high = 1e12, bool needed = false) {
    visit(Key{section, name, unit, about, low, high, needed}, value);
  };

  auto& d = s.drive;
  k("name", d.name, "", "what the drive is called in reports", 0, 0, required);
  k("source", d.source, "", "who publishes the numbers", 0, 0, required);
  k("notes", d.notes, "", "what a reader should know");
  k("kind", d.kind, "", "which drive turns the motor");
  k("assumed", d.assumed, "", "\"section.key: reason\" for each value that nobody publishes");

  section = "motor";
  auto& m = s.motor;
  k("resistance_ohm", m.resistance_ohm, "ohm", "phase to neutral", 1e-4, 1e3, required);
  k("inductance_h", m.inductance_h, "H", "self-inductance of a phase", 1e-7, 1, required);
  k("mutual_h", m.mutual_h, "H", "between two phases, usually negative", -1, 1);
  k("inductance_d_h", m.inductance_d_h, "H", "salient rotor: along the magnet; default: L - M", 1e-7, 1);
  k("inductance_q_h", m.inductance_q_h, "H", "salient rotor: across the magnet; default: L - M", 1e-7, 1);
  k("saturation", m.saturation, "", "part of L_d that iron loses at large positive i_d", 0, 0.9);
  k("saturation_a", m.saturation_a, "A", "i_d at which 71 % of that is lost", 1e-3, 1e4);
  k("flux_vs", m.flux_vs, "V s", "peak phase back-EMF per electrical rad/s", 1e-6, 10, required);
  k("pole_pairs", m.pole_pairs, "", "electrical per mechanical turns", 1, 100, required);
  k("shape", m.shape, "", "of the back-EMF");
  k("flat_top_deg", m.flat_top_deg, "deg", "trapezoid: width of the flat tops, electrical", 0, 175);
  k("rounded_flanks", m.rounded_flanks, "", "trapezoid: flanks meet the tops without a corner");
  k("table", m.table, "", "table: one electrical turn in equal steps, peak 1", -2, 2);
  k("inertia_kgm2", m.inertia_kgm2, "kg m^2", "of the rotor", 1e-10, 100, required);
  k("coulomb_nm", m.coulomb_nm, "N m", "dry friction while turning", 0, 100);
  k("viscous_nms", m.viscous_nms, "N m s/rad", "friction per speed", 0, 100);
  k("static_nm", m.static_nm, "N m", "breakaway friction; default: coulomb_nm", 0, 100);
  k("cogging_nm", m.cogging_nm, "N m", "amplitude of the cogging torque", 0, 100);
  k("cogging_periods", m.cogging_periods, "", "of cogging per mechanical turn", 1, 1000);
  k("rated_current_a", m.rated_current_a, "A",
    "continuous: six-step, in the two conducting phases; sinusoidal, peak of a phase", 1e-3, 1e4, required);

  section = "believed";
  auto& b = s.believed;
  k("resistance_ohm", b.resistance_ohm, "ohm", "the design is made from it; default: motor.resistance_ohm, likewise for each", 1e-4, 1e3);
  k("inductance_h", b.inductance_h, "H", "likewise", 1e-7, 1);
  k("inductance_d_h", b.inductance_d_h, "H", "likewise", 1e-7, 1);
  k("inductance_q_h", b.inductance_q_h, "H", "likewise", 1e-7, 1);
  k("flux_vs", b.flux_vs, "V s", "likewise", 1e-6, 10);
  k("inertia_kgm2", b.inertia_kgm2, "kg m^2", "likewise, of the rotor", 1e-10, 100);

  section = "load";
  auto& l = s.load;
  k("inertia_kgm2", l.inertia_kgm2, "kg m^2", "rigidly coupled, unless behind a spring", 0, 100);
  k("opposing_nm", l.opposing_nm, "N m", "always against the motion, holds at rest", 0, 1e3);
  k("fan_nms2", l.fan_nms2, "N m s^2/rad^2", "torque per squared speed", 0, 100);
  k("breakaway_nm", l.breakaway_nm, "N m", "holds at rest, beyond friction, until the rotor has turned once", 0, 1e3);
  k("unbalance_nm", l.unbalance_nm, "N m", "amplitude of the torque of a weight on one side", 0, 1e3);
  k("unbalance_deg", l.unbalance_deg, "deg", "mechanical angle at which that weight hangs", -360, 360);
  k("wind_rpm", l.wind_rpm, "rpm", "speed at which moving air lets the fan be; negative is reverse", -1e6, 1e6);
  k("spring_nm_rad", l.spring_nm_rad, "N m/rad", "a belt between rotor and load (its inertia and fan); 0: rigid", 0, 1e6);
  k("spring_nms_rad", l.spring_nms_rad, "N m s/rad", "damping of that spring", 0, 1e4);

  section = "inverter";
  auto& i = s.inverter;
  k("bus_v", i.bus_v, "V", "of the source", 1, 1e3, required);
  k("bus_resistance_ohm", i.bus_resistance_ohm, "ohm", "of source and cables; 0 is stiff", 0, 100);
  k("bus_capacitance_f", i.bus_capacitance_f, "F", "at the bridge", 1e-7, 10);
  k("bus_sinks", i.bus_sinks, "", "the source takes current back");
  k("on_resistance_ohm", i.on_resistance_ohm, "ohm", "of a switch", 0, 10);
  k("diode_drop_v", i.diode_drop_v, "V", "of a body diode", 0.01, 5);
  k("diode_resistance_ohm", i.diode_resistance_ohm, "ohm", "slope of a body diode", 0, 10);
  k("dead_time_s", i.dead_time_s, "s", "between the switches of a leg", 0, 1e-4);

  section = "sensors";
  auto& e = s.sensors;
  k("reference", e.reference, "", "what the comparators compare the terminals with");
  k("comparator_offset_v", e.comparator_offset_v, "V", "of u, v, w", -10, 10);
  k("comparator_hysteresis_v", e.comparator_hysteresis_v, "V", "full width", 0, 10);
  k("comparator_delay_s", e.comparator_delay_s, "s", "to the pin", 0, 1e-3);
  k("comparator_noise_v", e.comparator_noise_v, "V", "standard deviation", 0, 10);
  k("comparator_noise_interval_s", e.comparator_noise_interval_s, "s", "noise holds this long",
    1e-9, 1);
  k("limit_a", e.limit_a, "A", "threshold of the current comparator", 1e-3, 1e4, required);
  k("limit_hysteresis_a", e.limit_hysteresis_a, "A", "full width", 0, 1e3);
  k("limit_delay_s", e.limit_delay_s, "s", "to the pin", 0, 1e-3);
  k("hall_error_deg", e.hall_error_deg, "deg", "electrical, late if positive", -29, 29);
  k("hall_delay_s", e.hall_delay_s, "s", "to the pin", 0, 1e-2);
  k("seed", e.seed, "", "of all noise", 0, 2147483647);

  section = "accuracy";
  auto& a = s.accuracy;
  k("tolerance", a.tolerance, "", "relative, per integration step of the plant", 1e-12, 1e-3);
  k("max_step_s", a.max_step_s, "s", "longest integration step of the plant", 1e-7, 1);

  section = "control";
  auto& c = s.control;
  k("clock_hz", c.clock_hz, "Hz", "of the FPGA drive", 1e6, 500e6);
  k("pwm_hz", c.pwm_hz, "Hz", "PWM frequency", 100, 1e6);
  k("tick_s", c.tick_s, "s", "time base of everything slow; default: about 1 ms", 1e-5, 0.1);
  k("source", c.source, "", "of the commutation steps");
  k("chopping", c.chopping, "", "which switches follow the PWM");
  k("centred", c.centred, "", "pulses centred in the PWM period");
  k("minimum_pulse_s", c.minimum_pulse_s, "s", "shorter on or off times become 0 % or 100 %", 0,
    1e-3);
  k("limit_blanking_s", c.limit_blanking_s, "s", "current comparator ignored after switch-on", 0,
    1e-4);
  k("limit_off_time_s", c.limit_off_time_s, "s", "fixed off-time of the limit; 0 disables it; default: 20 us, or what lets the current fall further than it rises while the comparator is not believed; a quarter of it while a cut turns all gates off", 0,
    1e-2);
  k("sampling", c.sampling, "", "chop states in which the comparators are read");
  k("blanking_s", c.blanking_s, "s", "comparators not believed after each chop edge", 0, 1e-3);
  k("sample_every_s", c.sample_every_s, "s", "between two samples of a comparator", 0, 1e-3);
  k("samples", c.samples, "", "length of the up/down filter", 1, 15);

  section = "loop";
  auto& o = s.loop;
  k("form", o.form, "", "coefficients per second (the paper) or per step");
  k("detector", o.detector, "", "phase U once per turn (the paper), or all phases");
  k("divide", o.divide, "", "N = 6 * 2^divide VCO turns per electrical turn", 0, 3);
  k("advance_deg", o.advance_deg, "deg", "commutate this early", 0, 29);
  k("lead_error_deg", o.lead_error_deg, "deg",
    "error taken when the crossing was over too soon; default: 15, 29 once per turn", 0, 29);
  k("delay_s", o.delay_s, "s", "crossing to sample, taken back; default: from the sensors", 0,
    1e-3);
  k("bandwidth", o.bandwidth, "rad/step",
    "per step: natural frequency; default: 0.4, 0.1 once per turn", 0.005, 0.8);
  k("damping", o.damping, "", "per step: of the two integrators and the zero", 0.3, 3);
  k("pole_ratio", o.pole_ratio, "", "omega_p / omega_z, per step; default: no pole", 2, 1e3);
  k("rho", o.rho, "%", "Eq. (9), residue at t_s", 0.01, 50);
  k("zeta", o.zeta, "", "Eq. (9), attenuation", 0.1, 5);
  k("lambda", o.lambda, "", "Eq. (7), omega_p / omega_z", 1.5, 1e3);
  k("n_c", o.n_c, "", "Eq. (10), cycles to settle", 1, 1e4);
  k("f_m_hz", o.f_m_hz, "Hz", "Eq. (10), mean frequency; default: at the set speed", 0.1, 1e6);
  k("k_l", o.k_l, "", "Eq. (15), loop gain K_p K_v / N; default 0.0189", 1e-9, 1e9);
  k("r_ohm", o.r_ohm, "ohm", "wins over Eq. (17)", 1e-3, 1e9);
  k("c1_f", o.c1_f, "F", "wins over Eq. (15)", 1e-15, 1e3);
  k("c2_f", o.c2_f, "F", "wins over Eq. (16)", 1e-15, 1e3);
  k("minimum_rpm", o.minimum_rpm, "rpm", "lowest PLL speed; default: a quarter of hand-over", 0,
    1e6);
  k("maximum_rpm", o.maximum_rpm, "rpm", "highest PLL speed; default: 1.3 x no-load speed", 1, 1e6);

  section = "start";
  auto& t = s.start;
  k("method", t.method, "", "follow: the steps follow the rotor; ramp: alignment and forced ramp, as in the paper");
  k("look_s", t.look_s, "s", "follow: gates off before a look; default: until the limit's current is gone", 1e-6, 0.1);
  k("probe_s", t.probe_s, "s", "follow: a drive between two looks; default: from the lightest rotor", 1e-6, 0.1);
  k("still", t.still, "", "follow: looks without news before the field moves on; default: from the heaviest rotor", 1, 255);
  k("find_duty", t.find_duty, "", "follow: until the rotor is followed; default: 0.95, so that the limit rules", 0.01, 1);
  k("kappa_nm", t.kappa_nm, "N m/rad", "Eq. (19); 0: from alignment current and flux", 0, 1e3);
  k("gamma", t.gamma, "", "Eq. (22), aggregate loss constant", 0.1, 100);
  k("xi", t.xi, "", "Eq. (23), acceleration constant", 1e-3, 1e6);
  k("k_v", t.k_v, "", "Eq. (23), gain of the VCO", 1e-9, 1e9);
  k("t_a_s", t.t_a_s, "s", "acceleration time; default: Eq. (23) or from torque", 1e-4, 10);
  k("pre_align_s", t.pre_align_s, "s", "pattern before the alignment, so that an opposite rotor moves", 0, 4);
  k("align_s", t.align_s, "s", "alignment, the paper's t_r; default: Eq. (22)", 0, 4);
  k("align_current_a", t.align_current_a, "A", "of both alignment patterns; default: rated", 1e-3, 1e4);
  k("start_current_a", t.start_current_a, "A", "stalled current in acceleration; default: rated",
    1e-3, 1e4);
  k("ramp_rpm_s", t.ramp_rpm_s, "rpm/s", "acceleration of the ramp; default: from torque", 1, 1e7);
  k("hand_over_rpm", t.hand_over_rpm, "rpm", "f_a; default: from the back-EMF", 1, 1e6);
  k("window_deg", t.window_deg, "deg", "a crossing closer to its place is good", 1, 29);
  k("good_crossings", t.good_crossings, "", "in a row, for lock", 1, 63);
  k("pull_in_s", t.pull_in_s, "s", "time limit from hand-over to lock; default 1 s", 1e-3, 4);
  k("detect_spin_s", t.detect_spin_s, "s", "look for a rotor that spins (flying start); 0 skips it, and a board is made without Hall decoder; default: enough", 0,
    4);
  k("slow_down_s", t.slow_down_s, "s", "time limit before a reversal; default 2 s", 1e-3, 4);
  k("brake_s", t.brake_s, "s", "one braking interval", 1e-3, 4);
  k("brake_current_a", t.brake_current_a, "A", "of a brake, at any speed; default: 0.7 of the limit",
    1e-3, 1e4);
  k("retry_delay_s", t.retry_delay_s, "s", "gates off before the next attempt", 0, 4);
  k("retries", t.retries, "", "failed attempts before the fault latches", 0, 15);

  section = "speed";
  auto& p = s.speed;
  k("bandwidth_rad_s", p.bandwidth_rad_s, "rad/s", "default: from the PLL's", 0.01, 1e5);
  k("kp_duty_per_rpm", p.kp_duty_per_rpm, "1/rpm", "wins over the bandwidth", 0, 1);
  k("ki_duty_per_rpm_s", p.ki_duty_per_rpm_s, "1/(rpm s)", "wins over the bandwidth", 0, 1e3);
  k("slew_rpm_s", p.slew_rpm_s, "rpm/s", "of the set speed; default: from the PLL", 0.1, 1e8);
  k("duty_slew_per_s", p.duty_slew_per_s, "1/s", "default: from the PLL", 1e-3, 1e4);
  k("minimum_duty", p.minimum_duty, "", "lowest duty in speed control", 0, 1);
  k("maximum_duty", p.maximum_duty, "", "highest duty", 0.01, 1);

  section = "protection";
  auto& q = s.protection;
  k("misses", q.misses, "", "score at which a lock counts as lost", 1, 63);
  k("stall_rpm", q.stall_rpm, "rpm", "slower is a stall; default: 0.4 x hand-over; with Hall sensors what a start can pass", 0, 1e6);
  k("slip_duty", q.slip_duty, "", "duty above what speed and commutation take that no right lock shows", 0, 2);
  k("freewheel_deg", q.freewheel_deg, "deg", "longer freewheeling is wrong", 1, 60);
  k("wrong_lock_s", q.wrong_lock_s, "s",
    "a wrong tick takes two from it, a right one gives one back; 0 disables the test", 0, 4);
  k("over_current", q.over_current, "", "limit hits in a row that never release; 0 disables", 0,
    15);

  section = "adc";
  auto& x = s.adc;
  k("bits", x.bits, "", "of every ADC", 4, 24);
  k("current_a", x.current_a, "A", "range, either sign; default: 4 x rated", 1e-3, 1e4);
  k("voltage_v", x.voltage_v, "V", "range of the bus voltage's; default: 1.5 x bus_v", 1, 1e4);
  k("current_offset_a", x.current_offset_a, "A", "of u, v, w", -1e3, 1e3);
  k("current_noise_a", x.current_noise_a, "A", "standard deviation", 0, 1e3);
  k("voltage_noise_v", x.voltage_noise_v, "V", "standard deviation", 0, 1e3);

  section = "sinusoidal";
  auto& y = s.sinusoidal;
  k("estimator", y.estimator, "", "Eqs. (6)-(11) or (12)-(20)");
  k("modulation", y.modulation, "", "of the three duties");
  k("moving_average", y.moving_average, "", "voltage model: samples of Eq. (7)'s speed; 1 is none", 1, 64);
  k("k_em", y.k_em, "", "the drive's K_E over the motor's", 0.1, 10);
  k("angle_gain", y.angle_gain, "1/rad", "angle correction: part of the error per electrical radian turned", 0.05, 20);
  k("emf_bandwidth_rad_s", y.emf_bandwidth_rad_s, "rad/s", "current model: of e_c; default: 4 x speed", 1, 1e5);
  k("current_bandwidth_rad_s", y.current_bandwidth_rad_s, "rad/s", "default: 0.12 per sample", 1, 1e5);
  k("speed_bandwidth_rad_s", y.speed_bandwidth_rad_s, "rad/s", "default: a quarter of the current's, at most 150, less where inertia and inductance ask for it", 0.1, 1e4);
  k("slew_rpm_s", y.slew_rpm_s, "rpm/s", "of the set speed; default: what takes no rotor past it, a quarter of the rated torque at most", 1, 1e8);
  k("current_limit_a", y.current_limit_a, "A", "phase peak that the speed regulator may ask for; default: 1.5 x rated", 1e-3, 1e4);
  k("i_gamma_a", y.i_gamma_a, "A", "set-point of the gamma current, phase peak", -1e4, 1e4);
  k("compensate", y.compensate, "", "the duty makes up for dead time");
  k("knows_drop", y.knows_drop, "", "the drive takes the diodes' drop into account");

  section = "sinusoidal_start";
  auto& z = s.sinusoidal_start;
  k("by", z.by, "", "where the rotor stands: turned by a held pattern, not known, or found by pilot pulses");
  k("pattern_s", z.pattern_s, "s", "V+ U- W-, U+ V+ W-, U+ V- W-, a third of it each; default: from the inertia", 1e-3, 100);
  k("pattern_current_a", z.pattern_current_a, "A", "phase peak; default: rated", 1e-3, 1e4);
  k("start_current_a", z.start_current_a, "A", "phase peak, when the loop is closed; default: what inertia, friction and the envelope's greatest load take, as far as a tenth of the set speed allows", 0, 1e4);
  k("lock_rpm", z.lock_rpm, "rpm", "the estimate is trusted above; default: 2 % of no-load speed, or what a fifth of the resistance may look like", 0.1, 1e6);
  k("lock_s", z.lock_s, "s", "for so long; default: half an electrical turn from that speed on by a quarter of the rated torque, 0.02 at least", 0, 10);
  k("give_up_s", z.give_up_s, "s", "no lock in this time is a failed attempt", 1e-3, 100);
  k("stop_rpm", z.stop_rpm, "rpm", "the drive lets go below; default: lock_rpm", 0.1, 1e6);
  k("brake_s", z.brake_s, "s", "three low sides on, at the end of a stop", 0, 100);
  k("retry_delay_s", z.retry_delay_s, "s", "gates off before the next attempt", 0, 100);
  k("retries", z.retries, "", "failed attempts before the fault latches", 0, 100);
  k("pilot_short_s", z.pilot_short_s, "s", "pulse; default: to 0.3 x rated current", 1e-6, 0.1);
  k("pilot_long_s", z.pilot_long_s, "s", "pulse for the polarity; default: to 1.2 x rated current", 1e-6, 0.1);
  k("pilot_repeats", z.pilot_repeats, "", "rounds of six short pulses, averaged", 1, 64);
  k("least_saliency", z.least_saliency, "", "less variation of the peaks is no position", 0, 1);
  k("least_polarity", z.least_polarity, "", "less difference of the long peaks is no polarity", 0, 1);

  section = "sinusoidal_protection";
  auto& g = s.sinusoidal_protection;
  k("saturated_s", g.saturated_s, "s", "a regulator at its limit for so long; 0 disables", 0, 100);
  k("slow_rpm", g.slow_rpm, "rpm", "too slow for the estimator; default: from the ADC's step", 0, 1e6);
  k("slow_s", g.slow_s, "s", "for so long; 0 disables", 0, 100);
  k("emf_low", g.emf_low, "", "least EMF over K_E speed", 0, 1);
  k("emf_high", g.emf_high, "", "greatest", 1, 100);
  k("emf_s", g.emf_s, "s", "outside of these for so long; 0 disables", 0, 100);
  k("lost_samples", g.lost_samples, "", "in a row", 1, 1000);

  section = "scenario";
  auto& n = s.scenario;
  k("speed_rpm", n.speed_rpm, "rpm", "set speed", 1, 1e6, required);
  k("duration_s", n.duration_s, "s", "simulated time", 1e-3, 100, required);
  k("start_angle_deg", n.start_angle_deg, "deg", "rotor at t = 0, electrical", -360, 360);
  k("start_speed_rpm", n.start_speed_rpm, "rpm", "rotor at t = 0, negative is reverse", -1e6, 1e6);
  k("run_s", n.run_s, "s", "when `run` rises", 0, 100);
  k("load_step_s", n.load_step_s, "s", "when the load torque rises by load_step_nm", 0, 100);
  k("load_off_s", n.load_off_s, "s", "when it falls again", 0, 100);
  k("load_step_nm", n.load_step_nm, "N m", "default: half the torque of the rated current", 0, 1e3);
  k("inertia_step_s", n.inertia_step_s, "s", "when a mass that turns along is coupled to the rotor", 0, 100);
  k("inertia_step_kgm2", n.inertia_step_kgm2, "kg m^2", "of that mass; default: three times the inertia before", 0, 100);
  k("reverse_s", n.reverse_s, "s", "when the direction is changed", 0, 100);
  k("stop_s", n.stop_s, "s", "when `run` falls", 0, 100);
  k("set_speed_s", n.set_speed_s, "s", "when the set speed changes, in order", 0, 100);
  k("set_speed_rpm", n.set_speed_rpm, "rpm", "to what, one for each of these times", 0, 1e6);
  k("load_s", n.load_s, "s", "when the load torque changes, in order", 0, 100);
  k("load_nm", n.load_nm, "N m", "to what beside load.opposing_nm, one for each of these times", 0, 1e3);
  k("reverse", n.reverse, "", "starts in reverse direction");
  k("brake_to_stop", n.brake_to_stop, "", "stop by braking, else coast");

  for_each_sweep_key(s, section, k);
}

}  // namespace steplock::design
