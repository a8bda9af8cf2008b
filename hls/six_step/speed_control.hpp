// Speed control: from the VCO's frequency to the on-time of the PWM, once per tick.
//
//     reference  moves towards target by at most slew
//     e          = (reference - frequency) >> shift          normalised error, s0.15 of full scale
//     integral  += ki e                                      frozen in the direction that winds up
//     duty       = integral + kp e                           within [minimum, maximum] and duty_slew
//     on_clocks  = duty * period
//
// Outside speed control the duty is the start sequence's (kFixed), or that much above the one whose
// mean voltage equals the back-EMF (kAboveBemf: the current stays the same while the rotor speeds up).
// Integral and reference follow, so that control begins without a jump, after a start as after
// catching a rotor.
//
//     latency      4 products of 16 clocks, 2 shifts of up to 15: at most 110 clocks after the tick;
//                  a tick that comes earlier is passed over
//     registers    about 220 bits     multipliers  none (one serial)
//
// Doc: docs/blocks/speed_control.md   Test: tests/hls/speed_control_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/numeric/serial_multiplier.hpp"
#include "hls/six_step/words.hpp"

namespace steplock {

enum class SpeedMode : std::uint8_t { kFixed, kAboveBemf, kControl };

class SpeedControl {
 public:
  struct In {
    bool tick = false;                   // starts one update
    SpeedMode mode = SpeedMode::kFixed;  // where the duty comes from
    Duty fixed_duty = 0;                 // u1.15, for kFixed and kAboveBemf
    Frequency frequency = 0;             // u0.32, VCO turns per clock
    Frequency target = 0;                // u0.32, VCO turns per clock
    bool limited = false;                // strobe: the current limit cut the pulse
    Clocks period = 0;                   // clocks per PWM period
    SpeedWords words;
  };

  struct Out {
    Duty duty = 0;        // u1.15
    Duty bemf_duty = 0;   // u1.15, mean voltage equal to the back-EMF
    Clocks on_clocks = 0; // clocks of on-time per period
  };

  Out tick(const In& in) {
    const Out out{.duty = duty_, .bemf_duty = bemf_duty_, .on_clocks = on_clocks_};

    const bool shifted = shifts_ == 0;
    const auto product = multiplier_.tick({.start = stage_ != Stage::kIdle && shifted && !started_,
                                           .a = saturate<Int<17>>(operand_),
                                           .b = factor(in)});
    limited_ = in.limited || limited_;
    if (stage_ == Stage::kIdle) {
      if (in.tick) {
        begin(in);
      }
    } else if (!shifted) {
      operand_ = operand_ >> 1;
      shifts_ = wrap<UInt<4>>(shifts_ - 1);
    } else if (!started_) {
      started_ = true;
    } else if (product.done) {
      started_ = false;
      finish(in, product.product);
    }
    return out;
  }

  // Nothing to work on: a tick without a strobe changes nothing (docs/theory.md, quiet clocks).
  bool idle() const { return stage_ == Stage::kIdle; }
  bool operator==(const SpeedControl&) const = default;

 private:
  enum class Stage : std::uint8_t { kIdle, kBemf, kIntegral, kProportional, kOnClocks };

  UInt<16> factor(const In& in) const {
    switch (stage_) {
      case Stage::kBemf: return in.words.bemf;
      case Stage::kIntegral: return in.words.ki;
      case Stage::kProportional: return in.words.kp;
      default: return in.period;
    }
  }

  void begin(const In& in) {
    if (in.mode != SpeedMode::kControl) {
      reference_ = in.frequency;
    } else {
      const auto distance = in.target - reference_;
      if (distance > in.words.slew) {
        reference_ = wrap<Frequency>(reference_ + in.words.slew);
      } else if (distance + in.words.slew < 0) {
        reference_ = wrap<Frequency>(reference_ - in.words.slew);
      } else {
        reference_ = in.target;
      }
    }
    operand_ = in.frequency;
    shifts_ = in.words.shift;
    stage_ = Stage::kBemf;
  }

  void finish(const In& in, Int<33> product) {
    switch (stage_) {
      case Stage::kBemf:
        bemf_duty_ = saturate<Duty>(product >> 12);
        if (in.mode == SpeedMode::kControl) {
          operand_ = reference_ - in.frequency;
          shifts_ = in.words.shift;
          stage_ = Stage::kIntegral;
        } else {
          take(in.mode == SpeedMode::kAboveBemf ? above(in, product) : in.fixed_duty);
        }
        break;
      case Stage::kIntegral:
        integrate(in, product);
        stage_ = Stage::kProportional;
        break;
      case Stage::kProportional:
        move_duty(in, product);
        break;
      default:
        on_clocks_ = saturate<Clocks>(product >> 15);
        stage_ = Stage::kIdle;
        break;
    }
  }

  static Duty above(const In& in, Int<33> product) {
    const auto sum = in.fixed_duty + (product >> 12);
    return sum > in.words.maximum ? in.words.maximum : wrap<Duty>(sum);
  }

  // The duty comes from elsewhere; control will begin from it.
  void take(Duty duty) {
    duty_ = duty;
    integral_ = UInt<32>(duty) << 16;
    limited_ = at_high_ = at_low_ = false;
    to_on_clocks(duty);
  }

  void to_on_clocks(Duty duty) {
    operand_ = duty;
    stage_ = Stage::kOnClocks;
  }

  void integrate(const In& in, Int<33> product) {
    const bool winds_up = operand_.negative() ? at_low_ : at_high_ || limited_;
    limited_ = false;
    if (winds_up) return;
    const auto sum = integral_ + product;
    const auto highest = UInt<32>(in.words.maximum) << 16;
    integral_ = sum < 0 ? UInt<32>(0) : sum > highest ? highest : wrap<UInt<32>>(sum);
  }

  void move_duty(const In& in, Int<33> product) {
    const auto wanted = integral_.slice<31, 16>() + (product >> 12);
    const auto bounded = wanted < in.words.minimum   ? in.words.minimum
                         : wanted > in.words.maximum ? in.words.maximum
                                                     : wrap<Duty>(wanted);
    const auto move = bounded - duty_;
    const bool up = move > in.words.duty_slew;
    const bool down = move + in.words.duty_slew < 0;
    at_high_ = up || wanted > in.words.maximum;
    at_low_ = down || wanted < in.words.minimum;
    const Duty moved = up     ? wrap<Duty>(duty_ + in.words.duty_slew)
                       : down ? wrap<Duty>(duty_ - in.words.duty_slew)
                              : bounded;
    duty_ = moved;
    to_on_clocks(moved);
  }

  SerialMultiplier<17, 16> multiplier_;
  Stage stage_ = Stage::kIdle;
  bool started_ = false;    // the stage's product is under way
  UInt<4> shifts_ = 0;      // still to do, one a clock: cheaper than a barrel shifter
  Int<27> operand_ = 0;     // speed, speed error or duty
  Frequency reference_ = 0; // u0.32, the slewed target
  UInt<32> integral_ = 0;   // u1.31: the duty and 16 bits more
  Duty duty_ = 0;
  Duty bemf_duty_ = 0;
  Clocks on_clocks_ = 0;
  bool limited_ = false;    // the current limit cut a pulse since the last tick
  bool at_high_ = false;    // the duty wanted to be higher than it may
  bool at_low_ = false;
};

}  // namespace steplock
