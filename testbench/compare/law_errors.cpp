#include "testbench/compare/law_errors.hpp"

#include <algorithm>
#include <cmath>

#include "model/reference/phase_locked_loop.hpp"
#include "model/reference/speed_control.hpp"

namespace steplock {
namespace {

constexpr int kWindow = 64;

LawError named(const char* signal, const char* unit) {
  LawError e;
  e.signal = signal, e.unit = unit;
  return e;
}

void take(LawError& to, double error, double bound, double time) {
  ++to.updates;
  LawError now = to;
  now.worst = std::abs(error), now.bound = bound * (1 + 1e-9), now.at_s = time;  // and what doubles round
  if (now.of_bound() > to.of_bound()) to = now;
}

LawError detector_error(const std::vector<DetectorInput>& told, const design::LoopParameters& p) {
  LawError found = named("phase error", "step");
  reference::PhaseDetector detector(p);
  for (const DetectorInput& u : told) {
    if (u.begins) {
      detector.restart();
      detector.update({.step_ended = true});
    }
    if (u.crossing) {
      detector.update({.crossing = true, .crossing_phase = std::ldexp(double(u.crossing_phase.raw()), -16)});
    }
    const double answer = detector.error();
    detector.update({.before_seen = u.before_seen, .step_ended = true});
    const double error = std::ldexp(double(u.error.raw()), -16);
    // The block's greatest error is a last place below a half.
    const double mine = std::min(u.crossing ? answer : detector.error(), 0.5 - std::ldexp(1, -16));
    // Of a step that ends on the level before, the block takes the last place before its end.
    take(found, mine - error, std::ldexp(!u.crossing && u.before_seen ? 1 : 0.5, -16), u.time);
  }
  return found;
}

// Turns of a step per clock, and steps per second.
class LoopBeside {
 public:
  LoopBeside(const design::LoopParameters& p, double tick, double clock_hz)
      : reference_(p), per_step_(p.form == design::LoopForm::kPerStep), tick_(tick),
        hertz_(std::ldexp(clock_hz, -p.divide)) {}

  void update(const LoopInput& u, LawError& found) {
    if (u.begins) {
      law_ = LoopFilterLaw{};
      law_.x = law_.y = wrap<UInt<30>>(u.before << 4);
      law_.fresh = false;
      apart_ = 0;
    }
    if (u.begins || ++since_ == kWindow) join();
    const auto& w = u.in;
    const double e = std::ldexp(double(w.error.raw()), -16) + std::ldexp(value(law_.y), -36) * double(w.delay.raw());
    grow(w, std::abs(e), std::ldexp(value(law_.y), -36));
    const double was = value(law_.x);
    law_.update(u.in);
    const double moved = (value(law_.x) - was) * kPlace;
    // The law begins without the four places that no output shows, and stays less than a place away: two outputs, cut to whole
    // places, then differ by one at most, and a difference changes by two.
    const double apart = value(law_.frequency()) - value(u.after);
    found.unlike += std::abs(apart - apart_) > 2;
    apart_ = apart;
    const double error = std::ldexp(double(w.error.raw()), -16);
    if (per_step_) {
      reference_.step(error);
    } else {
      reference_.run(error, tick_);
      const double stays = 1 - pole(w);
      held_ = stays * held_ + moved * (stays + pole(w) / std::log(stays));
      // One may be at the limit a tick sooner, and its integral stays.
      if (law_.at_top || law_.at_bottom) ex_ += std::abs(moved), ey_ += std::abs(held_) + std::abs(moved), held_ = 0;
    }
    take(found, reference_.frequency() - (std::ldexp(value(law_.y), -36) + held_) * hertz_, ey_ * hertz_, u.time);
  }

 private:
  static constexpr double kPlace = 0x1p-36;
  template <class Bits>
  static double value(const Bits& b) { return static_cast<double>(b.raw()); }
  static double pole(const LoopFilterLaw::In& w) { return std::ldexp(value(w.alpha), -15); }

  void join() {
    reference_.load(std::ldexp(value(law_.x), -36) * hertz_, std::ldexp(value(law_.y), -36) * hertz_);
    since_ = 0;
    ex_ = ey_ = held_ = 0;
  }
  void grow(const LoopFilterLaw::In& w, double e, double f) {
    const double ki = std::ldexp(value(w.ki), -14), kp = std::ldexp(value(w.kp), -14), delay = value(w.delay);
    const double s = per_step_ ? f : std::ldexp(value(w.scale), -32);
    const double ep = kPlace + e * 0x1p-28 + s * (0x1p-22 + delay * ey_) + (per_step_ ? e * ey_ : 0);
    ex_ += kPlace + ki * ep;
    const double ev = ex_ + kPlace + kp * ep;
    ey_ = (1 - pole(w)) * ey_ + pole(w) * ev + 2 * kPlace;
  }

  LoopFilterLaw law_;
  reference::LoopFilter reference_;
  bool per_step_;
  double tick_, hertz_;  // s; steps/s of a turn of the VCO per clock
  int since_ = 0;
  double apart_ = 0;        // of the law and the block, last places
  double ex_ = 0, ey_ = 0;  // turns per clock
  double held_ = 0;         // per second: what a tick's sample and hold is behind the circuit
};

class SpeedBeside {
 public:
  SpeedBeside(const design::SpeedParameters& p, double tick, double hertz) : p_(p), reference_(p, tick), tick_(tick), hertz_(hertz) {}

  void tick(const SpeedInput& u, LawError& found) {
    const double f = double(u.in.frequency.raw()) * hertz_;
    const Duty was = law_.duty;
    const bool begins = u.in.mode == SpeedMode::kControl && law_.resumes;
    const auto set_before = law_.reference;
    law_.tick(u.in);
    if (u.in.mode != SpeedMode::kControl) {
      reference_.follow(duty(u.after), duty(u.after), f);
      ei_ = er_ = ed_ = 0;
      since_ = 0;
      parted_ = undisturbed_ = true;
      return;
    }
    found.disturbed += u.disturbed;
    undisturbed_ = undisturbed_ && !u.disturbed;
    found.unlike += undisturbed_ && law_.duty != u.after;
    reference_.tick(double(u.in.target.raw()) * hertz_, f, u.in.limited, u.in.masked_lead, u.in.freewheels);
    if (law_.reference < set_before) er_ += hertz_;  // upwards the slew is exact
    const double e = er_ + hertz_;
    ei_ += 0x1p-31 + p_.ki * tick_ * (parted_ ? std::abs(reference_.reference() - f) + e : e);
    const int move = std::abs(int(law_.duty.raw()) - int(was.raw()));
    const bool slews = move >= int(u.in.config.duty_slew.raw()) || reference_.at_high() || reference_.at_low();
    const double fresh = 2 * kPlace + ei_ + p_.kp * e;
    const bool rests = move == 0 && (law_.duty == u.in.config.minimum || law_.duty == u.in.config.maximum);
    ed_ = rests                                 ? std::max(ed_ - p_.duty_slew * tick_, fresh)
          : slews || begins || u.in.limited ? std::max(ed_ + kPlace, fresh)
                                            : fresh;
    take(found, reference_.duty() - duty(law_.duty), ed_, u.time);
    const bool unlike = law_.at_high != reference_.at_high() || law_.at_low != reference_.at_low();
    parted_ = unlike && reference_.margin() <= ed_;
    // A new beginning takes the integral from the duty; and its bounds do not hold the next one's integral.
    if (begins) ei_ = ed_, er_ = hertz_, parted_ = true;
    // Whether the rotor has come down to the set speed, a last place may decide.
    const bool arrived = law_.resumes != reference_.resumes() && std::abs(reference_.reference() - f) <= e;
    if (++since_ == kWindow || arrived) join();
  }

 private:
  static constexpr double kPlace = 0x1p-15;  // of a duty
  static double duty(Duty d) { return double(d.raw()) * kPlace; }

  void join() {
    reference_.join_at(duty(law_.duty), std::ldexp(double(law_.integral.raw()), -31), double(law_.reference.raw()) * hertz_,
                       law_.descends, law_.resumes);
    ei_ = er_ = ed_ = 0;
    since_ = 0;
  }

  design::SpeedParameters p_;
  SpeedControlLaw law_;
  reference::SpeedControl reference_;
  double tick_, hertz_;  // s; steps/s of a last place of a frequency
  int since_ = 0;
  bool undisturbed_ = true;  // no input changed in mid-update since control began
  bool parted_ = true;  // one of the two may hold its integral, for a bound that the other has not met
  double ei_ = 0, er_ = 0, ed_ = 0;  // duty; steps/s; duty
};

}  // namespace

std::vector<LawError> law_errors(const LawInputs& told, const design::Parameters& p, double clock_hz) {
  const double tick = p.pwm.tick();
  std::vector<LawError> all = {detector_error(told.detector, p.loop)};
  LawError loop = named("frequency", "step/s"), speed = named("duty", "1");
  LoopBeside filter(p.loop, tick, clock_hz);
  for (const LoopInput& u : told.loop) filter.update(u, loop);
  SpeedBeside control(p.speed, tick, std::ldexp(clock_hz, -32 - p.loop.divide));
  for (const SpeedInput& u : told.speed) control.tick(u, speed);
  all.push_back(loop);
  all.push_back(speed);
  return all;
}

}  // namespace steplock
