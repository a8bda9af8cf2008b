// What the sinusoidal drive computes in one sample, as one program: currents in, on-clocks out, and
// then what the next sample needs to know of the speed.
//
//     first   angle of this sample (its step came with the one before) -> CurrentControl
//                                                                      -> SpaceVector -> `early`
//     then    Estimator -> step to the next sample -> SpeedRegulator -> speed, wanted current
//
// So nobody waits for the estimator: the duty takes the speed and the wanted current of the sample
// before, a sample late in a loop whose filter takes tens of samples.  The angle is not late: theta_c
// of a sample follows from the sample before, in Matsui 1996 as here, (11) and (20).
//
// In a search by pilot pulses the currents that CurrentControl turns are `a` and `b` instead.
//
//     formats        those of the four blocks
//     latency        `early` 10 us at most at 24 MHz; all by `clocks`, less than the shortest period
//     multipliers    one of 31 x 16 bits, for products in turn
//
// Doc: docs/blocks/sinusoidal_control.md   Test: tests/hls/sinusoidal_control_test.cpp

#pragma once

#include "hls/numeric/scheduled.hpp"
#include "hls/sinusoidal/current_control.hpp"
#include "hls/sinusoidal/space_vector.hpp"
#include "hls/sinusoidal/config.hpp"

namespace steplock {

class SinusoidalControl {
 public:
  struct In {
    bool estimate = false;   // false: the angle is `initial`, the speed 0
    bool regulate = false;   // the loop is closed
    bool locked = false;     // a slow estimate is to be believed
    bool reverse = false;    // the wanted direction
    bool slow_down = false;  // towards a stop
    bool hold = false;       // legs of a pattern, or of a pilot pulse, not a vector
    bool hold_u = false;     // u is one of them
    bool hold_v = false;     // v is
    bool hold_w = false;     // w is
    bool pilot = false;      // pulses: a leg's on-time without regard to what its current may be
    bool search = false;     // `a` and `b` are the currents that are turned
    Int<16> a = 0;           // s0.15
    Int<16> b = 0;           // s0.15
    Angle initial = 0;       // u0.24
    Int<16> i_u = 0;         // s0.15
    Int<16> i_v = 0;         // s0.15
    UInt<12> v_dc = 0;       // u0.12
    SpaceVector::Out ended;  // clocks, of the period that this sample ends
    BridgeConfig bridge;
    EstimatorConfig estimator;
    RegulatorConfig speed;
    ControlConfig control;
    UInt<15> hold_voltage = 0;  // u0.15
  };

  struct Out {
    SpaceVector::Out early;     // clocks, of the next period
    Angle angle = 0;            // u0.24, at this sample
    Int<16> i_gamma = 0;        // s0.15
    Int<16> i_delta = 0;        // s0.15
    bool limited = false;       // the voltage would have been longer
    SpeedRegulator::Out speed;  // for the next sample
  };

  Out tick(const In& in) {
    // A rotor at rest seems to turn backward to a model with too much resistance: until the lock,
    // the direction is the wanted one, unless the other is seen at a speed that makes a lock.
    const Int<16> lock = wrap<Int<16>>(in.speed.lock);
    const Int<16> edge = in.reverse ? lock : wrap<Int<16>>(-lock);
    const auto model = model_.tick({.enable = in.estimate,
                                    .edge = in.locked ? Int<16>(0) : edge,
                                    .initial = in.initial,
                                    .i_u = in.i_u,
                                    .i_v = in.i_v,
                                    .v_dc = in.v_dc,
                                    .pattern = {.on_u = in.ended.on_u,
                                                .on_v = in.ended.on_v,
                                                .on_w = in.ended.on_w,
                                                .period = in.bridge.period,
                                                .dead = in.bridge.dead_time_loss,
                                                .inverse = in.bridge.reciprocal},
                                    .config = in.estimator});
    // A sample and a half on; the speed's last place is an eighth of the angle's.
    const auto further = (speed_ + (speed_ >> 1)) >> 3;
    const UInt<16> angle = model.angle.slice<23, 8>();
    const auto control = control_.tick({.enable = in.regulate,
                                        .i_u = in.search ? in.a : in.i_u,
                                        .i_v = in.search ? in.b : in.i_v,
                                        .angle = angle,
                                        .ahead = wrap<UInt<16>>(angle + further),
                                        .speed = speed_,
                                        .set_gamma = in.control.set_gamma,
                                        .set_delta = wanted_,
                                        .k_p = in.control.k_p,
                                        .k_i = in.control.k_i,
                                        .inductance = in.control.inductance,
                                        .emf = in.control.emf,
                                        .v_dc = in.v_dc,
                                        .limit = in.control.limit});
    const bool compensate = in.bridge.compensate && !in.pilot;
    const auto legs = modulator_.tick({.v_alpha = control.v_alpha,
                                       .v_beta = control.v_beta,
                                       .i_u = in.hold ? in.i_u : control.wanted_u,
                                       .i_v = in.hold ? in.i_v : control.wanted_v,
                                       .v_dc = in.v_dc,
                                       .period = in.bridge.period,
                                       .minimum = in.bridge.minimum,
                                       .dead = compensate ? in.bridge.dead_time_loss : DeadClocks(0),
                                       .sine = in.bridge.sine_pwm,
                                       .hold = in.hold,
                                       .hold_u = in.hold_u,
                                       .hold_v = in.hold_v,
                                       .hold_w = in.hold_w,
                                       .hold_voltage = in.hold_voltage});
    const auto speed = regulator_.tick({.enable = in.regulate,
                                        .reverse = in.reverse,
                                        .slow_down = in.slow_down,
                                        .locked = in.locked,
                                        .step = model.step,
                                        .emf_step = model.emf_step,
                                        .config = in.speed});
    speed_ = speed.speed;
    wanted_ = speed.current;
    return {.early = legs,
            .angle = model.angle,
            .i_gamma = control.i_gamma,
            .i_delta = control.i_delta,
            .limited = control.limited,
            .speed = speed};
  }

 private:
  Estimator model_;
  SpeedRegulator regulator_;
  CurrentControl control_;
  SpaceVector modulator_;
  Int<16> speed_ = 0;   // s0.15, of the sample before
  Int<16> wanted_ = 0;  // s0.15, i_delta* of the sample before
};

// Whoever gives the inputs holds them.
using SinusoidalLoop =
    Scheduled<SinusoidalControl, Budget{.width = 31, .second_width = 16, .clocks = 475, .early = 228}>;

}  // namespace steplock
