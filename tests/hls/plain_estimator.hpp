// What both estimators see of the back-EMF and how they go on, in plain integers (plain_integers.hpp): applied_voltage.hpp and
// observer.hpp once more.
#pragma once

#include <array>

#include "hls/sinusoidal/observer.hpp"
#include "tests/hls/plain_integers.hpp"

namespace steplock::plain {

struct Vector {
  Integer alpha = 0, beta = 0;
};

// A leg drives for its on-time less the dead time that its current takes: all of it beyond an ADC's step, a part within.
inline Integer leg(Integer on, const AppliedPattern& p, Integer twice_current) {
  const Integer current = down(twice_current, 1);
  const Integer lost = down(std::clamp(current, Integer{-16}, Integer{16}) * of(p.dead), 4);
  return 16 * on - (on != 0 && on < of(p.period) ? lost : 0);
}
inline Vector applied(const AppliedPattern& p, Integer twice_u, Integer twice_v, Integer twice_dc) {
  const Integer u = leg(of(p.on_u), p, twice_u), v = leg(of(p.on_v), p, twice_v), w = leg(of(p.on_w), p, -(twice_u + twice_v));
  const Integer per_clock = nearest(twice_dc * of(p.inverse), 13);
  const Integer beta = nearest((v - w) * constant(std::sqrt(3.0), 14), 14), alpha = 2 * u - v - w;
  return {held(nearest(alpha * per_clock, 14), 16), held(nearest(beta * per_clock, 14), 16)};
}

// `Law` has follow(gamma, delta, config) -> {emf_step, pull}, and rest().
template <class Law>
class Estimator {
 public:
  struct Shown {
    Integer angle = 0, step = 0, emf_step = 0, error = 0;
  };

  template <class In>
  Shown sample(const In& in) {
    const Integer sum_u = of(in.i_u) + u_, sum_v = of(in.i_v) + v_;
    const Vector v = applied(in.pattern, sum_u, sum_v, of(in.v_dc) + dc_);
    const auto free = [&](Integer moved, Integer sum) { return held(2 * moved + nearest(sum * of(in.config.decay), 15), 18); };
    const auto driven = [&](Integer voltage) { return nearest(voltage * of(in.config.gain), 12); };
    const Integer free_u = free(of(in.i_u) - u_, sum_u), free_v = free(of(in.i_v) - v_, sum_v);
    const Integer twice = held(free_u + 2 * free_v, 18);
    const Integer alpha = held(free_u - driven(v.alpha), 16);
    const Integer beta = held(nearest(twice * constant(1 / std::sqrt(3.0), 15), 15) - driven(v.beta), 16);
    const auto [sine, cosine] = sine_cosine(UInt<16>(static_cast<int>(down(turned(angle_ + step_, 24), 8))));
    const Integer gamma = held(nearest(alpha * of(cosine) + beta * of(sine), 15), 16);
    const Integer delta = held(nearest(beta * of(cosine) - alpha * of(sine), 15), 16);

    const auto [emf_step, pull] = law_.follow(gamma, delta, in.config);
    const Integer edge = of(in.edge);
    const bool backward = down(mean_steps_, 9) < (reversed_ ? 0 : edge);
    reversed_ = edge != 0 && backward == (edge < 0);
    const bool mistaken = edge != 0 && !reversed_ && (emf_step < 0) != backward;
    const Integer by_emf = mistaken ? 0 : emf_step;
    const Integer step = held(backward ? by_emf - pull : by_emf + pull, 20);
    u_ = of(in.i_u), v_ = of(in.i_v), dc_ = of(in.v_dc);
    if (!in.enable) {
      angle_ = of(in.initial), step_ = mean_steps_ = 0, reversed_ = false;
      law_.rest();
      return {.angle = angle_};
    }
    angle_ = turned(angle_ + 2 * step_, 24);
    step_ = step;
    mean_steps_ += step - down(mean_steps_, 5);
    return {angle_, step, emf_step, gamma};
  }

 private:
  Law law_;
  Integer u_ = 0, v_ = 0, dc_ = 0, angle_ = 0, step_ = 0, mean_steps_ = 0;
  bool reversed_ = false;
};

// Any currents, patterns and coefficients; half of the time ones that leave the words far from their ends.
template <class In>
In drawn_sample(Drawn& any, const In& before) {
  In in = before;
  const bool small = any.one_in(2);
  const int most = small ? 3000 : 30000;
  in.i_u = any.between(-most, most), in.i_v = any.between(-most, most);
  any.into(in.v_dc);
  in.pattern.on_u = any.between(0, int(in.pattern.period.raw())), in.pattern.on_v = any.between(0, int(in.pattern.period.raw()));
  in.pattern.on_w = any.between(0, int(in.pattern.period.raw()));
  if (any.one_in(4)) in.i_u = any.between(-40, 40);
  if (any.one_in(50)) any.into(in.edge);
  if (any.one_in(20)) in.edge = 0;
  in.enable = !any.one_in(100);
  any.into(in.initial);
  return in;
}

// Runs the block beside what it is in plain integers; the number of samples of which any output differs.
template <class Block, class Law, class Configure>
int differences(std::uint32_t seed, int samples, const Configure& configure) {
  Drawn any(seed);
  Block block;
  Estimator<Law> plain;
  typename Block::In in;
  int differing = 0;
  for (int n = 0; n < samples; ++n) {
    if (n % 200 == 0) {
      in.pattern.period = any.between(400, 3000);
      any.into(in.pattern.dead);
      in.pattern.inverse = static_cast<int>((1 << 25) / std::max(1024, int(in.pattern.period.raw())));
      any.into(in.config.decay), any.into(in.config.gain);
      if (any.one_in(2)) in.config.decay = any.between(0, 600), in.config.gain = any.between(0, 3000);
      configure(any, in.config);
    }
    in = drawn_sample(any, in);
    const auto out = block.tick(in);
    const auto expected = plain.sample(in);
    const bool turns_alike = of(out.angle) == expected.angle && of(out.step) == expected.step;
    if (!turns_alike || of(out.emf_step) != expected.emf_step || of(out.error) != expected.error) ++differing;
  }
  return differing;
}

}  // namespace steplock::plain
