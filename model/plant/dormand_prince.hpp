// One step of the Dormand-Prince 5(4) pair with its dense output, over a fixed number of variables,
// and the integrals of powers along it by the same weights.
//
//     y(t + c h),  0 <= c <= 1,  from seven slopes: fifth order at c = 1, fourth in between
//
// The powers do not feed back, so they cost one weighted sum when asked for, not one per stage.
//
// Doc: docs/plant.md   Test: tests/model/plant/dormand_prince_test.cpp
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace steplock::plant {

template <std::size_t N, std::size_t M>
class DormandPrinceStep {
 public:
  using Values = std::array<double, N>;
  using Integrands = std::array<double, M>;

  // Tries a step of `h` from `start`; slope(y, slope_out, integrands_out).  Returns the error
  // estimate, largest of |error| / max(|y|, scale).
  template <typename Slope>
  double attempt(const Values& start, double h, const Values& scale, const Slope& slope) {
    begin_ = start;
    h_ = h;
    slope(begin_, k_[0], p_[0]);
    stage<1>(slope, {1.0 / 5});
    stage<2>(slope, {3.0 / 40, 9.0 / 40});
    stage<3>(slope, {44.0 / 45, -56.0 / 15, 32.0 / 9});
    stage<4>(slope, {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729});
    stage<5>(slope, {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656});
    stage<6>(slope, {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84});

    double worst = 0;
    for (std::size_t n = 0; n < N; ++n) {
      const double error =
          h_ * (71.0 / 57600 * k_[0][n] - 71.0 / 16695 * k_[2][n] + 71.0 / 1920 * k_[3][n] -
                17253.0 / 339200 * k_[4][n] + 22.0 / 525 * k_[5][n] - 1.0 / 40 * k_[6][n]);
      const double size = std::max(std::max(std::abs(begin_[n]), std::abs(end_[n])), scale[n]);
      worst = std::max(worst, std::abs(error) / size);
    }
    return worst;
  }

  double length() const { return h_; }
  const Values& begin() const { return begin_; }
  const Values& end() const { return end_; }

  // To be called once after the attempt that is kept, before at().
  void prepare_dense() {
    for (std::size_t n = 0; n < N; ++n) {
      const double rise = end_[n] - begin_[n];
      const double bulge = h_ * k_[0][n] - rise;
      dense_[0][n] = rise;
      dense_[1][n] = bulge;
      dense_[2][n] = rise - h_ * k_[6][n] - bulge;
      dense_[3][n] = h_ * quartic(k_, n);
    }
  }

  Values at(double elapsed) const {
    const double c = elapsed / h_, d = 1 - c;
    Values y;
    for (std::size_t n = 0; n < N; ++n) {
      y[n] = begin_[n] +
             c * (dense_[0][n] + d * (dense_[1][n] + c * (dense_[2][n] + d * dense_[3][n])));
    }
    return y;
  }

  // Integrals of the integrands over the first `elapsed` of the step.
  Integrands integrals(double elapsed) const {
    const double c = elapsed / h_, d = 1 - c;
    Integrands sum;
    for (std::size_t m = 0; m < M; ++m) {
      const double rise =
          h_ * (35.0 / 384 * p_[0][m] + 500.0 / 1113 * p_[2][m] + 125.0 / 192 * p_[3][m] -
                2187.0 / 6784 * p_[4][m] + 11.0 / 84 * p_[5][m]);
      const double bulge = h_ * p_[0][m] - rise;
      const double bend = rise - h_ * p_[6][m] - bulge;
      sum[m] = c * (rise + d * (bulge + c * (bend + d * h_ * quartic(p_, m))));
    }
    return sum;
  }

 private:
  template <int S, typename Slope>
  void stage(const Slope& slope, const std::array<double, S>& weight) {
    for (std::size_t n = 0; n < N; ++n) {
      double sum = 0;
      for (int s = 0; s < S; ++s) sum += weight[s] * k_[s][n];
      end_[n] = begin_[n] + h_ * sum;
    }
    slope(end_, k_[S], p_[S]);
  }

  // Weights of the dense output's fourth-order term.
  template <std::size_t Width>
  static double quartic(const std::array<std::array<double, Width>, 7>& k, std::size_t n) {
    return -12715105075.0 / 11282082432 * k[0][n] + 87487479700.0 / 32700410799 * k[2][n] -
           10690763975.0 / 1880347072 * k[3][n] + 701980252875.0 / 199316789632 * k[4][n] -
           1453857185.0 / 822651844 * k[5][n] + 69997945.0 / 29380423 * k[6][n];
  }

  double h_ = 0;
  Values begin_ = {}, end_ = {};
  std::array<Values, 7> k_ = {};
  std::array<Integrands, 7> p_ = {};
  std::array<Values, 4> dense_ = {};
};

}  // namespace steplock::plant
