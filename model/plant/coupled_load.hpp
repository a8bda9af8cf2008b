// What the load does to the shaft besides friction and inertia; each is 0 unless asked for.
//
//     unbalance    -U sin(angle - hang)              a weight on one side: the rotor swings until it hangs
//     wind         F (w |w| - v |v|),  v = w - wind  the fan's air moves: this comes on top of the fan's own F w |w|
//     spring       -(k twist + c (w - w_load))       a belt: the load's inertia and fan turn behind it
//                  twist' = w - w_load      J_load w_load' = k twist + c (w - w_load) - F v |v|,  v = w_load - wind
//
// Angles and speeds are mechanical.
//
// Doc: docs/plant.md   Test: tests/model/plant/coupled_load_test.cpp
#pragma once

#include <cmath>

#include "model/plant/parameters.hpp"

namespace steplock::plant {

class CoupledLoad {
 public:
  explicit CoupledLoad(const Parameters& p)
      : unbalance_(p.load.unbalance_torque),
        hang_(p.load.unbalance_angle),
        wind_(p.load.wind_speed),
        fan_(p.motor.fan_friction),
        stiffness_(p.load.spring_stiffness),
        damping_(p.load.spring_damping),
        inertia_(p.load.inertia),
        acts_(unbalance_ != 0 || wind_ != 0 || stiffness_ != 0) {}

  bool acts() const { return acts_; }
  bool springs() const { return stiffness_ != 0; }

  struct Motion {
    double angle;       // rad, of the rotor
    double speed;       // rad/s, of the rotor
    double load_speed;  // rad/s, behind the spring
    double twist;       // rad, rotor before load
  };

  // N m on the rotor, positive towards positive speed.
  double pull(const Motion& m) const {
    return -unbalance_ * std::sin(m.angle - hang_) - (springs() ? spring(m) : air(m.speed) - still_air(m.speed));
  }
  // rad/s^2, behind the spring.
  double acceleration(const Motion& m) const { return springs() ? (spring(m) - air(m.load_speed)) / inertia_ : 0; }
  double slip(const Motion& m) const { return springs() ? m.speed - m.load_speed : 0; }

  // W.  Heat in the spring and of a fan behind it, as if its air stood still; and what wind takes beyond that.
  double heat(const Motion& m) const {
    if (!springs()) return 0;
    return damping_ * slip(m) * slip(m) + still_air(m.load_speed) * m.load_speed;
  }
  double work(const Motion& m) const {
    const double w = springs() ? m.load_speed : m.speed;
    return (air(w) - still_air(w)) * w;
  }

  // J, stored.
  double kinetic(const Motion& m) const { return springs() ? 0.5 * inertia_ * m.load_speed * m.load_speed : 0; }
  double lifted(const Motion& m) const { return -unbalance_ * std::cos(m.angle - hang_); }
  double wound(const Motion& m) const { return 0.5 * stiffness_ * m.twist * m.twist; }

 private:
  double spring(const Motion& m) const { return stiffness_ * m.twist + damping_ * (m.speed - m.load_speed); }
  double air(double w) const { return fan_ * (w - wind_) * std::abs(w - wind_); }
  double still_air(double w) const { return fan_ * w * std::abs(w); }

  double unbalance_, hang_, wind_, fan_, stiffness_, damping_, inertia_;
  bool acts_;
};

}  // namespace steplock::plant
