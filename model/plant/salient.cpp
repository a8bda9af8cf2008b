#include "model/plant/salient.hpp"

#include <cmath>

namespace steplock::plant {
namespace {

constexpr double kHalfRoot = 0.5 * std::numbers::sqrt3;

struct Vector {
  double alpha, beta;
};

// The axes of the phases; phase quantities without common part are x_k = axis_k . vector.
constexpr Vector kAxis[3] = {{1, 0}, {-0.5, kHalfRoot}, {-0.5, -kHalfRoot}};

double dot(Vector a, Vector b) { return a.alpha * b.alpha + a.beta * b.beta; }

Vector vector_of(const Phases& x) {
  return {(2 * x[0] - x[1] - x[2]) / 3, (x[1] - x[2]) / std::numbers::sqrt3};
}

}  // namespace

SalientWinding::SalientWinding(const Motor& m)
    : pole_pairs_(m.pole_pairs),
      resistance_(m.resistance),
      flux_(m.flux),
      l_d_(m.inductance_d > 0 ? m.inductance_d : m.inductance - m.mutual),
      l_q_(m.inductance_q > 0 ? m.inductance_q : m.inductance - m.mutual),
      saturation_(m.saturation),
      saturation_current_(m.saturation_current) {}

SalientWinding::Field SalientWinding::field(double angle, const Phases& current) const {
  Field f;
  f.cosine = -std::cos(angle);
  f.sine = -std::sin(angle);
  const Vector i = vector_of(current);
  f.i_d = f.cosine * i.alpha + f.sine * i.beta;
  f.i_q = f.cosine * i.beta - f.sine * i.alpha;
  const double knee = std::hypot(f.i_d, saturation_current_);
  f.l_d = l_d_ * (1 - saturation_ * f.i_d / knee);
  f.lambda_d = flux_ + l_d_ * (f.i_d - saturation_ * (knee - saturation_current_));
  f.lambda_q = l_q_ * f.i_q;
  return f;
}

double SalientWinding::stored(const Field& f) const {
  const double i = f.i_d, knee = std::hypot(i, saturation_current_);
  // Integral of x^2 / sqrt(x^2 + I^2) from 0 to i, twice.
  const double bent = i * knee - saturation_current_ * saturation_current_ *
                                     std::asinh(i / saturation_current_);
  return 0.75 * (l_d_ * (i * i - saturation_ * bent) + l_q_ * f.i_q * f.i_q);
}

SalientWinding::Motion SalientWinding::motion(const Circuit& circuit, const Field& f,
                                              const Phases& current, double w,
                                              double bus_voltage) const {
  const double w_e = pole_pairs_ * w;
  const double motion_d = w_e * (f.l_d * f.i_q - f.lambda_q);
  const double motion_q = w_e * (f.lambda_d - l_q_ * f.i_d);
  const Vector moved = {f.cosine * motion_d - f.sine * motion_q,
                        f.sine * motion_d + f.cosine * motion_q};
  // L - L_q is a matrix of rank one along d.
  const Vector d = {f.cosine, f.sine};
  const double salience = f.l_d - l_q_;

  Phases drive = {};
  int conducting = 0, a = -1, b = -1;
  for (int k = 0; k < 3; ++k) {
    if (circuit.on[k] == 0) continue;
    ++conducting;
    (a < 0 ? a : b) = k;
    drive[k] = circuit.share[k] * bus_voltage + circuit.lift[k] -
               (circuit.resistance[k] + resistance_) * current[k] - dot(kAxis[k], moved);
  }

  Motion out = {};
  Vector slope = {0, 0};
  if (conducting == 3) {
    const Vector u = vector_of(drive);
    const double along_d = dot(d, u) / f.l_d;
    const double along_q = (d.alpha * u.beta - d.beta * u.alpha) / l_q_;
    slope = {d.alpha * along_d - d.beta * along_q, d.beta * along_d + d.alpha * along_q};
    for (int k = 0; k < 3; ++k) out.slope[k] = dot(kAxis[k], slope);
  } else if (conducting == 2) {
    // One current, in at a and out at b; its vector is 2/3 of the difference of their axes.
    const Vector between = {kAxis[a].alpha - kAxis[b].alpha, kAxis[a].beta - kAxis[b].beta};
    const double along = dot(d, between);
    const double loop = 2.0 / 3 * (l_q_ * dot(between, between) + salience * along * along);
    out.slope[a] = (drive[a] - drive[b]) / loop;
    out.slope[b] = -out.slope[a];
    slope = {2.0 / 3 * between.alpha * out.slope[a], 2.0 / 3 * between.beta * out.slope[a]};
  }
  const double coupled = salience * dot(d, slope);
  for (int k = 0; k < 3; ++k) out.emf[k] = dot(kAxis[k], moved) + coupled * dot(kAxis[k], d);
  return out;
}

}  // namespace steplock::plant
