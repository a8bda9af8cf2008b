// Clarke's and Park's transforms, power-invariant, Eq. (3):
//
//     [gamma; delta] = sqrt(2/3) [cos c, cos(c - 120 deg), cos(c + 120 deg); -sin ...] [u; v; w]
//
// A vector stands still (alpha, beta: c = 0) or in the frame at the assumed angle c (gamma, delta).
//
// Doc: docs/sinusoidal.md   Test: tests/model/reference/sinusoidal/sinusoidal_vector_test.cpp
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace steplock::reference::sinusoidal {

using Phases = std::array<double, 3>;

inline constexpr double kPi = std::numbers::pi;

// Into [-pi, pi].
inline double wrapped(double angle) { return std::remainder(angle, 2 * kPi); }

struct Vector {
  double x = 0, y = 0;  // alpha and beta, or gamma and delta

  double length() const { return std::hypot(x, y); }
  friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector operator*(double k, Vector a) { return {k * a.x, k * a.y}; }
};

// The vector as seen from a frame that stands at `angle`.
inline Vector seen_from(double angle, Vector v) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x + s * v.y, c * v.y - s * v.x};
}
inline Vector from_frame(double angle, Vector v) { return seen_from(-angle, v); }

inline Vector clarke(const Phases& p) {
  return {std::sqrt(2.0 / 3) * (p[0] - 0.5 * (p[1] + p[2])), std::sqrt(0.5) * (p[1] - p[2])};
}
inline Phases phases(Vector v) {
  const double u = std::sqrt(2.0 / 3) * v.x, half = std::sqrt(0.5) * v.y;
  return {u, -0.5 * u + half, -0.5 * u - half};
}

}  // namespace steplock::reference::sinusoidal
