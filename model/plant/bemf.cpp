#include "model/plant/bemf.hpp"

#include <algorithm>
#include <cstddef>

namespace steplock::plant {
namespace {

// Second derivatives of the periodic cubic spline through equidistant values:
//     m[i-1] + 4 m[i] + m[i+1] = 6 (y[i-1] - 2 y[i] + y[i+1])
// Diagonally dominant by 2, so that each Gauss-Seidel sweep gains more than a factor 3.
std::vector<double> periodic_curvature(const std::vector<double>& y) {
  const std::size_t n = y.size();
  std::vector<double> m(n, 0.0);
  constexpr int kSweeps = 60;
  for (int sweep = 0; sweep != kSweeps; ++sweep) {
    for (std::size_t i = 0; i != n; ++i) {
      const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
      m[i] = (6 * (y[before] - 2 * y[i] + y[after]) - m[before] - m[after]) / 4;
    }
  }
  return m;
}

}  // namespace

BackEmf::BackEmf(const BackEmfShape& shape)
    : kind_(shape.kind), rounded_(shape.rounded_flanks), value_(shape.table) {
  flank_ = (std::numbers::pi - shape.flat_top_deg * kTurn / 360) / 2;
  inverse_flank_ = 1 / flank_;
  if (kind_ == BackEmfShape::Kind::kTable) curvature_ = periodic_curvature(value_);
}

BackEmf::Piece BackEmf::piece(double angle, double direction) const {
  Piece piece;
  if (kind_ != BackEmfShape::Kind::kTrapezoidal) return piece;
  // A step that ended on a corner may stop a rounding error short of it.
  const double inside = angle + 1e-9 * direction;
  for (int k = 0; k < 3; ++k) {
    const double shift = kThirdTurn * k;
    const std::int64_t half_turn = whole_below((inside - shift + flank_) / std::numbers::pi);
    const double sign = half_turn % 2 == 0 ? 1 : -1;
    const double zero = static_cast<double>(half_turn) * std::numbers::pi + shift;
    piece.center[k] = zero;
    double low = zero - flank_, high = zero + flank_;
    if (inside < high) {
      piece.linear[k] = rounded_ ? 1.5 * sign : sign;
      piece.cubic[k] = rounded_ ? -0.5 * sign : 0;
    } else {
      piece.constant[k] = sign;
      low = high;
      high = zero + std::numbers::pi - flank_;
    }
    piece.low = std::max(piece.low, low);
    piece.high = std::min(piece.high, high);
  }
  return piece;
}

double BackEmf::spline(double angle) const {
  const auto n = static_cast<std::int64_t>(value_.size());
  const double position = angle * (static_cast<double>(n) / kTurn);
  const std::int64_t whole = whole_below(position);
  const double after = position - static_cast<double>(whole), before = 1 - after;
  std::int64_t i = whole % n;
  if (i < 0) i += n;
  const std::int64_t j = i + 1 == n ? 0 : i + 1;
  return before * value_[i] + after * value_[j] +
         (before * (before * before - 1) * curvature_[i] +
          after * (after * after - 1) * curvature_[j]) /
             6;
}

}  // namespace steplock::plant
