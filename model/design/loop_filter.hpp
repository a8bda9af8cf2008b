// Loop filter of the digital PLL by Amano's Eqs. (1)-(17), its open loop and its margins.
//
//     F(s) = (s R C2 + 1) / (s^2 R C1 C2 + s (C1 + C2))                              (1)
//     H(s) = K_L F(s) / s = K_L (s + omega_z) / (s^2 C1 (s + omega_p))               (2)-(4)
//     omega_p = (C1 + C2) / (R C1 C2)   omega_z = 1 / (R C2)   omega_p = Lambda omega_z  (5)-(7)
//     omega_g = sqrt(omega_z omega_p) = -2 ln(rho/100) f_m / N_c                     (8)-(12)
//     |H(j omega_g)| = 1  gives C1, C2, R                                           (13)-(17)
//
// With the phase error in turns of a step and the VCO in steps/s, K_L F(s) is the drive's filter:
//     (integral / s + proportional) / (1 + s / omega_p)
//     integral = K_L / (C1 + C2)        proportional = integral / omega_z
//
// Doc: docs/design.md   Test: tests/model/design/loop_design_test.cpp
#pragma once

#include <complex>
#include <functional>
#include <vector>

namespace steplock::design {

struct LoopSpecification {
  double rho = 3, zeta = 0.7, lambda = 10, n_c = 20;
  double f_m = 195;     // Hz
  double k_l = 0.0189;  // K_p K_v / N
};

double settling_time(const LoopSpecification&);  // s, Eq. (10)
double omega_n(const LoopSpecification&);        // rad/s, Eq. (9)
double omega_g(const LoopSpecification&);        // rad/s, Eq. (12)
double omega_z(const LoopSpecification&);        // rad/s, Eq. (13)

struct Components {
  double c1 = 0, c2 = 0, r = 0;  // F, F, ohm

  double omega_p() const { return (c1 + c2) / (r * c1 * c2); }   // Eq. (5)
  double omega_z() const { return 1 / (r * c2); }                // Eq. (6)
  double omega_g() const;                                        // Eq. (8)
  std::complex<double> impedance(std::complex<double> s) const;  // Eq. (1)
};

Components components(const LoopSpecification&);  // Eqs. (15)-(17)
double loop_gain_for(const Components&);          // K_L with crossover at omega_g, Eq. (14)

// The filter of the drive, per second.
struct PerSecond {
  double integral = 0, proportional = 0, omega_p = 0;  // 1/s^2, 1/s, rad/s
};
PerSecond per_second(const Components&, double k_l);

// The filter of the drive, per step, from a natural frequency in rad per step.  `steps` lie between
// two updates: 1, or 6 if the detector looks once per turn.
struct PerStep {
  double integral = 0, proportional = 0, pole = 1;  // per update
  int steps = 1;
};
PerStep per_step(double bandwidth, double damping, double pole_ratio, int steps = 1);  // 0: no pole

using Response = std::function<std::complex<double>(double omega)>;

Response open_loop(const PerSecond&);
// As the drive computes it: the error of the last crossing (one per `crossing_interval`) is held,
// the filter runs once per tick, and its frequency holds until the next tick.
Response open_loop_sampled(const PerSecond&, double tick, double crossing_interval);
// omega in rad per update, below pi.
Response open_loop(const PerStep&);

struct Margins {
  double crossover = 0;  // rad/s, or rad per step; 0 if the gain never falls through 1
  double phase_deg = 0;
  double gain_db = 0;  // infinity if the phase never reaches -180 degrees above the crossover
};
Margins margins(const Response&, double lowest, double highest);

struct BodePoint {
  double omega, gain_db, phase_deg;  // phase unwrapped from -180 degrees at the low end
};
std::vector<BodePoint> bode(const Response&, double lowest, double highest, int points);

}  // namespace steplock::design
