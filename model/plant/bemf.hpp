// Shape of the back-EMF of the three phases over the electrical angle: trapezoid, sine or table.
//
//     shape_k(theta) = shape(theta - 120 deg * k),   crosses zero rising at theta = 0, peak 1
//
// A trapezoid has corners.  Between two of them a Piece holds one cubic per phase, smooth beyond
// its own ends, so that an integration step never sees a corner: the caller ends the step at `low`
// or `high` and takes the next piece.  Sine and table (a periodic cubic spline, continuous to the
// second derivative) are one piece of unlimited length.
//
// Angles in electrical radians.  Doc: docs/plant.md   Test: tests/model/plant/bemf_test.cpp
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "model/plant/parameters.hpp"

namespace steplock::plant {

using Phases = std::array<double, 3>;

inline constexpr double kTurn = 2 * std::numbers::pi;
inline constexpr double kThirdTurn = kTurn / 3;

// Largest integer not above x; |x| < 2^62.  std::floor is a library call on the oldest x86-64.
inline std::int64_t whole_below(double x) {
  const auto n = static_cast<std::int64_t>(x);
  return n - (static_cast<double>(n) > x);
}

class BackEmf {
 public:
  struct Piece {
    Phases center = {}, constant = {}, linear = {}, cubic = {};
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
  };

  explicit BackEmf(const BackEmfShape& shape);

  // The piece around `angle`; on a corner, the one that `direction` (+1, -1) leads into.
  Piece piece(double angle, double direction) const;

  Phases operator()(const Piece& piece, double angle) const {
    if (kind_ == BackEmfShape::Kind::kTrapezoidal) return trapezoid(piece, angle);
    if (kind_ == BackEmfShape::Kind::kSinusoidal) return sine(angle);
    return {spline(angle), spline(angle - kThirdTurn), spline(angle - 2 * kThirdTurn)};
  }

  // For tables and plots: the shape of phase u at any angle.
  double at(double angle) const { return (*this)(piece(angle, 1), angle)[0]; }

 private:
  Phases trapezoid(const Piece& piece, double angle) const {
    Phases shape;
    for (int k = 0; k < 3; ++k) {
      const double x = (angle - piece.center[k]) * inverse_flank_;
      shape[k] = piece.constant[k] + x * (piece.linear[k] + x * x * piece.cubic[k]);
    }
    return shape;
  }

  static Phases sine(double angle) {
    const double s = std::sin(angle), c = std::cos(angle);
    const double half_root = 0.5 * std::numbers::sqrt3;
    return {s, -0.5 * s - half_root * c, -0.5 * s + half_root * c};
  }

  double spline(double angle) const;

  BackEmfShape::Kind kind_;
  double flank_ = 0;  // half the width of a flank
  double inverse_flank_ = 0;
  bool rounded_ = false;
  std::vector<double> value_, curvature_;  // spline: values and second derivatives per interval^2
};

}  // namespace steplock::plant
