// Settings of a drive, in SI units (speeds in rpm): what a drives/*.toml file says, key by key.
//
// A member's name is its key in the file, a struct is a section, the default value is taken when
// the key is absent.  std::optional marks a value that the design library works out if the file
// does not name it.  What each key means, its unit and its range stand in ONE table,
// settings_keys.hpp: the loader, the checks and the documentation all read that table.
//
// Doc: docs/design.md   Test: tests/model/design/settings_test.cpp
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace steplock::design {

enum class Shape { kTrapezoidal, kSinusoidal, kTable };
enum class Reference { kVirtualNeutral, kHalfBus, kStarPoint };
enum class Chopping { kHighSide, kComplementary };
enum class Source { kBemf, kHall };
enum class Method { kRamp, kFollow };
enum class Sampling { kOnTime, kOffTime, kBoth };
enum class Detector { kOncePerTurn, kEveryStep };
enum class LoopForm { kPerSecond, kPerStep };
enum class DriveKind { kSixStep, kSinusoidal };
enum class Estimator { kVoltage, kCurrent };
enum class Modulation { kSpaceVector, kSine };
enum class StartBy { kPattern, kArbitrary, kPilot };

struct DriveSection {
  std::string name, source, notes;
  DriveKind kind = DriveKind::kSixStep;
  std::vector<std::string> assumed;  // "section.key: reason", for what the source does not publish
};

struct MotorSection {
  double resistance_ohm = 0, inductance_h = 0, mutual_h = 0, flux_vs = 0;
  std::optional<double> inductance_d_h, inductance_q_h;
  double saturation = 0, saturation_a = 1;
  int pole_pairs = 0;
  Shape shape = Shape::kTrapezoidal;
  double flat_top_deg = 120;
  bool rounded_flanks = true;
  std::vector<double> table;
  double inertia_kgm2 = 0;
  double coulomb_nm = 0, viscous_nms = 0;
  std::optional<double> static_nm;
  double cogging_nm = 0;
  int cogging_periods = 24;
  double rated_current_a = 0;
};

// What the design takes for the motor's, where that is not known better; the plant has the motor's own.
struct BelievedSection {
  std::optional<double> resistance_ohm, inductance_h, inductance_d_h, inductance_q_h, flux_vs, inertia_kgm2;
};

struct LoadSection {
  double inertia_kgm2 = 0, opposing_nm = 0, fan_nms2 = 0, breakaway_nm = 0;
  double unbalance_nm = 0, unbalance_deg = 0, wind_rpm = 0;
  double spring_nm_rad = 0, spring_nms_rad = 0;
};

struct InverterSection {
  double bus_v = 0, bus_resistance_ohm = 0.05, bus_capacitance_f = 470e-6;
  bool bus_sinks = true;
  double on_resistance_ohm = 0.01, diode_drop_v = 0.55, diode_resistance_ohm = 0.005;
  double dead_time_s = 1e-6;
};

struct SensorsSection {
  Reference reference = Reference::kVirtualNeutral;
  std::array<double, 3> comparator_offset_v = {};
  double comparator_hysteresis_v = 0.01, comparator_delay_s = 100e-9;
  double comparator_noise_v = 0, comparator_noise_interval_s = 1e-6;
  double limit_a = 0, limit_hysteresis_a = 0.1, limit_delay_s = 200e-9;
  std::array<double, 3> hall_error_deg = {};
  double hall_delay_s = 0;
  int seed = 1;
};

struct AccuracySection {
  double tolerance = 1e-7, max_step_s = 100e-6;
};

struct ControlSection {
  double clock_hz = 12e6, pwm_hz = 30e3;
  std::optional<double> tick_s;
  Source source = Source::kBemf;
  Chopping chopping = Chopping::kHighSide;
  bool centred = false;
  double minimum_pulse_s = 1e-6;
  double limit_blanking_s = 2e-6;
  std::optional<double> limit_off_time_s;
  Sampling sampling = Sampling::kBoth;
  double blanking_s = 4e-6, sample_every_s = 2e-6;
  int samples = 4;
};

struct LoopSection {
  LoopForm form = LoopForm::kPerStep;
  Detector detector = Detector::kEveryStep;
  int divide = 0;
  double advance_deg = 0;
  std::optional<double> lead_error_deg;
  std::optional<double> delay_s;
  std::optional<double> bandwidth;  // per step
  double damping = 1.0;
  std::optional<double> pole_ratio;                   // both forms
  double rho = 3, zeta = 0.7, lambda = 10, n_c = 20;  // per second, Eqs. (9)-(17)
  std::optional<double> f_m_hz, k_l;
  std::optional<double> r_ohm, c1_f, c2_f;  // named ones win over Eqs. (15)-(17)
  std::optional<double> minimum_rpm, maximum_rpm;
};

struct StartSection {
  Method method = Method::kFollow;
  double kappa_nm = 0, gamma = 4.28;     // Eqs. (19)-(22)
  std::optional<double> xi, k_v, t_a_s;  // Eq. (23)
  std::optional<double> pre_align_s, align_s, align_current_a, start_current_a;
  std::optional<double> ramp_rpm_s, hand_over_rpm;
  double window_deg = 12;
  int good_crossings = 12;
  std::optional<double> pull_in_s;
  std::optional<double> detect_spin_s;
  std::optional<double> slow_down_s, brake_s;
  std::optional<double> brake_current_a;
  double retry_delay_s = 0.05;
  int retries = 3;
  std::optional<double> look_s, probe_s, find_duty;
  std::optional<double> still;  // looks
};

struct SpeedSection {
  std::optional<double> bandwidth_rad_s, kp_duty_per_rpm, ki_duty_per_rpm_s;
  std::optional<double> slew_rpm_s, duty_slew_per_s;
  double minimum_duty = 0.02, maximum_duty = 1.0;
};

struct ProtectionSection {
  int misses = 18;
  std::optional<double> stall_rpm, slip_duty;
  double freewheel_deg = 29;  // of the 30 that hide a crossing; the duty yields from 28.1 on, and a right lock may take 28 while it does
  double wrong_lock_s = 0.1;
  int over_current = 8;
};

struct AdcSection {
  int bits = 12;
  std::optional<double> current_a, voltage_v;
  std::array<double, 3> current_offset_a = {};
  double current_noise_a = 0, voltage_noise_v = 0;
};

struct SinusoidalSection {
  Estimator estimator = Estimator::kCurrent;
  Modulation modulation = Modulation::kSpaceVector;
  int moving_average = 8;
  double k_em = 1, angle_gain = 2;
  std::optional<double> emf_bandwidth_rad_s, current_bandwidth_rad_s, speed_bandwidth_rad_s;
  std::optional<double> slew_rpm_s, current_limit_a;
  double i_gamma_a = 0;
  bool compensate = true, knows_drop = true;
};

struct SinusoidalStartSection {
  StartBy by = StartBy::kPattern;
  std::optional<double> pattern_s, pattern_current_a, start_current_a, lock_rpm, lock_s, stop_rpm;
  double give_up_s = 2, brake_s = 0.2, retry_delay_s = 0.3;
  int retries = 3;
  std::optional<double> pilot_short_s, pilot_long_s;
  int pilot_repeats = 4;
  double least_saliency = 0.03, least_polarity = 0.02;
};

struct SinusoidalProtectionSection {
  double saturated_s = 0.3, slow_s = 0.5, emf_low = 0.4, emf_high = 2.5, emf_s = 0.1;
  std::optional<double> slow_rpm;
  int lost_samples = 3;
};

struct ScenarioSection {
  double speed_rpm = 0, duration_s = 2, start_angle_deg = 0, start_speed_rpm = 0;
  double run_s = 1e-3;
  std::optional<double> load_step_s, load_off_s, load_step_nm;
  std::optional<double> inertia_step_s, inertia_step_kgm2;
  std::optional<double> reverse_s, stop_s;
  std::vector<double> set_speed_s, set_speed_rpm, load_s, load_nm;  // profiles: from each time on
  bool reverse = false, brake_to_stop = true;
};

// Where the drive must start and hold: what a sweep draws its runs from.  Ranges are factors of the
// file's own values, but for speed and load, which are fractions.
struct EnvelopeSection {
  std::vector<double> load = {0, 0.25, 0.5};
  double fan = 0.5;
  std::array<double, 2> inertia = {0.5, 20}, bus = {0.8, 1.2};
  std::array<double, 2> resistance = {0.8, 1.2}, inductance = {0.8, 1.2}, flux = {0.8, 1.2};
  std::array<double, 2> offset = {0, 1.5}, noise = {0, 2}, delay = {0.5, 2};
  double spinning = 0.25;
  std::array<double, 2> speed = {-1, 1};
  double weight = 1;
};

// What a start may put the motor through; what is not named follows from the motor (bounds.hpp).
struct BoundsSection {
  std::optional<double> current_a, kick_deg, speed, lock_s;
};

// What a start must bear beyond its envelope, one at a time, in the hard matrix of a sweep.  Torques are parts of the
// one of the rated current.
struct HardshipSection {
  double unbalance = 0.3, wind = 0.5, cogging = 0.3, stiction = 0.3, breakaway = 0.6, comparators = 2;
  std::array<double, 2> spring_hz = {10, 100};
};

// What a running drive must bear, in the disturbance matrix of a sweep.
struct DisturbanceSection {
  double load_step = 1, load_rate = 0.1;
  std::array<double, 2> set_speed = {0.6, 1};
  double bus_dip = 0.4;
  int stuck_steps = 48;
  double demagnetisation_deg = 30;
  double inertia_step = 4;
};

struct Settings {
  DriveSection drive;
  MotorSection motor;
  BelievedSection believed;
  LoadSection load;
  InverterSection inverter;
  SensorsSection sensors;
  AccuracySection accuracy;
  ControlSection control;
  LoopSection loop;
  StartSection start;
  SpeedSection speed;
  ProtectionSection protection;
  AdcSection adc;
  SinusoidalSection sinusoidal;
  SinusoidalStartSection sinusoidal_start;
  SinusoidalProtectionSection sinusoidal_protection;
  ScenarioSection scenario;
  EnvelopeSection envelope;
  BoundsSection bounds;
  HardshipSection hardship;
  DisturbanceSection disturbance;
};

}  // namespace steplock::design
