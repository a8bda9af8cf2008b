// Start sequence by Amano's Eqs. (18)-(23): how long to align (the paper's reset), how long to accelerate.
//
//     J theta'' + sigma theta' + kappa theta = 0      (18)-(20), with a restoring sign
//     f_r = sqrt(kappa / J) / gamma                   (21)
//     t_r = gamma / sqrt(kappa / J)                   (22)
//     t_a = xi J K_v / K_t                            (23)
//
// The paper prints t_r = 0.622 s where Eq. (22) with its own constants gives 0.266 s; a drive file
// may name t_r and t_a itself, and the formula is what it is.
//
// Doc: docs/design.md   Test: tests/model/design/start_times_test.cpp
#pragma once

#include <cmath>
#include <numbers>

namespace steplock::design {

inline double align_resonance(double kappa, double inertia, double gamma) {  // Hz, Eq. (21)
  return std::sqrt(kappa / inertia) / gamma;
}
inline double align_time(double kappa, double inertia, double gamma) {  // s, Eq. (22)
  return gamma / std::sqrt(kappa / inertia);
}
inline double acceleration_time(double xi, double inertia, double k_v, double k_t) {  // s, Eq. (23)
  return xi * inertia * k_v / k_t;
}

// kappa of Eq. (19): stiffness at the aligned position of a rotor held by `current` from U and V to
// W, per mechanical radian.  The field of that pattern has 3/2 of one phase's amplitude.
inline double align_stiffness(double flux, int pole_pairs, double current) {  // N m/rad
  return 1.5 * flux * pole_pairs * pole_pairs * current;
}

}  // namespace steplock::design
