// See drive.hpp for the chain; here it is walked once per event.
#include "model/reference/sinusoidal/drive.hpp"

#include <utility>

namespace steplock::reference::sinusoidal {

Drive::Drive(const design::sinusoidal::Parameters& p)
    : p_(p),
      pwm_(p.pwm),
      applied_(p.applied),
      voltage_model_(p.motor, p.voltage_model, p.pwm.period),
      current_model_(p.motor, p.current_model, p.pwm.period),
      current_regulator_(p.motor, p.current, p.pwm.period),
      speed_(p.speed, p.pwm.period),
      pilot_(p.pilot),
      protection_(p.protection, p.motor.k_e, p.pwm.period),
      guard_({.dead_time = p.pwm.dead_time}),
      target_(p.speed.target) {}

Output Drive::update(double t, const Pins& pins, const Command& command) {
  sampling_ = false;
  if (pins.reading) {
    awaited_ = false;
    take(t, *pins.reading);
  }
  const Phases duty_before = pwm_.duty();
  pwm_.update(t);
  if (pwm_.started()) {
    ended_duty_ = duty_before;
    if (awaited_ && !pilot_.pulsing()) protection_.missed();
    // A pilot pulse is sampled at its end alone.
    sampling_ = !(state_ == State::kPilot && pilot_.pulsing());
  }
  if (state_ == State::kPilot && pilot_.pulsing() && t >= pilot_.pulse_end()) {
    pilot_.end_pulse(t);
    sampling_ = true;
    ++peaks_due_;
  }
  awaited_ = awaited_ || sampling_;
  if (pins.fault && state_ != State::kFault) {
    reason_ = Reason::kFaultPin;
    enter(t, State::kFault);
  }
  sequence(t, command);
  guard_.update(t, wanted(t), true);

  next_ = std::min({pwm_.next(t), guard_.next(), pilot_.pulsing() ? pilot_.pulse_end() : kNever});
  if (next_ <= t) next_ = std::nextafter(t, kNever);
  return {.gates = guard_.gates(),
          .state = state_,
          .reason = reason_,
          .sample = sampling_,
          .locked = state_ == State::kRun || state_ == State::kSlowDown,
          .estimating = estimating(),
          .angle = estimate().angle,
          .speed = estimating() ? speed_.speed() : 0,
          .reference = speed_.reference(),
          .current = in_frame_,
          .wanted = wanted_delta_,
          .emf = estimate().emf,
          .duty = pwm_.duty(),
          .pilot_angle = pilot_angle_,
          .pilot_saliency = pilot_.saliency(),
          .pilot_polarity = pilot_.polarity()};
}

Gates Drive::wanted(double t) const {
  Gates g = {};
  if (state_ == State::kBrake) return {false, true, false, true, false, true};
  if (state_ == State::kPilot && pilot_.pulsing()) return pilot_gates(pilot_.pattern());
  if (state_ != State::kPattern && !(estimating() && modulated_ > 0)) return g;
  for (std::size_t leg = 0; leg < 3; ++leg) g[2 * leg + (pwm_.high(leg, t) ? 0 : 1)] = true;
  return g;
}

void Drive::take(double t, const Reading& reading) {
  Phases i;
  for (std::size_t k = 0; k < 3; ++k) i[k] = reading.current[k] - offset_[k];
  if (state_ == State::kCalibrate) {
    for (std::size_t k = 0; k < 3; ++k) summed_[k] += reading.current[k];
    ++calibrated_;
  } else if (state_ == State::kPilot) {
    if (peaks_due_ > 0) {
      --peaks_due_;
      pilot_.peak(i);
    } else {
      pilot_.wait(t, i);
    }
  } else if (state_ == State::kPattern) {
    v_dc_ = reading.v_dc;
    hold_pattern(t);
  } else if (estimating()) {
    control(i, reading.v_dc);
  }
  current_ = i;
  v_dc_ = reading.v_dc;
  protection_.sampled({.current = state_ == State::kCalibrate ? Phases{} : i,
                       .regulating = estimating(),
                       .saturated = current_regulator_.saturated() || speed_.saturated(),
                       .locked = state_ == State::kRun,
                       .speed = way_ * speed_.speed(),
                       .emf = way_ * estimate().emf});
}

void Drive::control(const Phases& current, double v_dc) {
  const Vector i = clarke(current);
  if (modulated_ > 1) {
    Phases mean;
    for (std::size_t k = 0; k < 3; ++k) mean[k] = 0.5 * (current[k] + current_[k]);
    const Interval interval{
        .voltage = clarke(applied_(ended_duty_, mean, 0.5 * (v_dc + v_dc_))),
        .before = clarke(current_),
        .current = i};
    // A rotor at rest seems to turn backward to a model with too much resistance: until the lock, the
    // direction is the wanted one, unless the other is seen at a speed that makes a lock.
    const double edge = state_ == State::kStarting ? -way_ * p_.start.lock_speed : 0;
    if (p_.estimator == design::Estimator::kCurrent) {
      current_model_.set_edge(edge);
      current_model_.update(interval);
    } else {
      voltage_model_.set_edge(edge);
      voltage_model_.update(interval);
    }
  }
  const Estimate& e = estimate();
  const double goal = state_ == State::kSlowDown ? 0.8 * p_.start.stop_speed : target_;
  wanted_delta_ = speed_.update(way_ * goal, e.speed, state_ != State::kStarting);
  in_frame_ = seen_from(e.angle, i);
  const Vector wanted = {p_.current.i_gamma, wanted_delta_};
  const Vector v = current_regulator_.update(wanted, in_frame_, speed_.speed(),
                                             longest_vector(p_.pwm.modulation, v_dc));
  const double ahead = e.angle + 1.5 * p_.pwm.period * speed_.speed();
  const Phases duty = duties(p_.pwm.modulation, from_frame(ahead, v), v_dc);
  pwm_.set(applied_.compensated(duty, phases(from_frame(ahead, wanted)), v_dc));
  regulated_ = true;
}

void Drive::hold_pattern(double t) {
  // 240, 300 and 0 degrees, in reverse 120, 60 and 0: what a load leaves of one of them, the next one reaches.
  const double third = p_.start.pattern_s / 3, since = t - entered_;
  const bool other_alone = since < third, u_alone = since >= 2 * third;
  const double share = v_dc_ > 0 ? 1.5 * p_.motor.resistance * p_.start.pattern_current / v_dc_ : 0;
  const double whole = p_.start.pattern_current, half = whole / 2;
  Phases duty = {other_alone ? 0 : share, 0, u_alone ? 0 : share};
  Phases current = other_alone ? Phases{-half, -half, whole}
                   : u_alone   ? Phases{whole, -half, -half}
                               : Phases{half, -whole, half};
  if (way_ < 0) std::swap(duty[1], duty[2]), std::swap(current[1], current[2]);
  pwm_.set(applied_.compensated(duty, current, v_dc_));
}

void Drive::enter(double t, State state) {
  state_ = state;
  entered_ = trusted_ = t;
  protection_.reset();
  switch (state) {
    case State::kCalibrate:
      summed_ = {}, calibrated_ = 0;
      break;
    case State::kPilot:
      peaks_due_ = 0;
      pilot_.start(t);
      break;
    case State::kPattern:
      pwm_.set({});
      break;
    case State::kStarting:
      current_regulator_.reset();
      speed_.start(0, way_);
      voltage_model_.start(pilot_angle_, 0);
      current_model_.start(pilot_angle_, 0);
      regulated_ = false, modulated_ = 0;
      break;
    default:
      break;
  }
}

void Drive::begin_start(double t) {
  pilot_angle_ = 0;
  switch (p_.start.by) {
    case design::StartBy::kPilot:
      return enter(t, State::kPilot);
    case design::StartBy::kPattern:
      return enter(t, State::kPattern);
    case design::StartBy::kArbitrary:
      return enter(t, State::kStarting);
  }
}

void Drive::fail(double t, Reason reason) {
  reason_ = reason;
  enter(t, ++tries_ > p_.start.retries ? State::kFault : State::kRetryDelay);
}

void Drive::sequence(double t, const Command& command) {
  if (protection_.fatal() != Reason::kNone && state_ != State::kFault) {
    reason_ = protection_.fatal();
    return enter(t, State::kFault);
  }
  // The gates follow the regulators from the first period on that has a duty of theirs.
  if (estimating() && regulated_ && pwm_.started()) ++modulated_;
  const bool still = target_ == 0;  // as if `run` were down, by braking
  const bool run = command.run && !still;
  const bool leave = !run || (command.reverse ? -1 : 1) != way_;
  const double since = t - entered_;
  switch (state_) {
    case State::kIdle:
      if (!run) break;
      way_ = command.reverse ? -1 : 1;
      tries_ = 0;
      reason_ = Reason::kNone;
      enter(t, State::kCalibrate);
      break;
    case State::kCalibrate:
      if (!run) return enter(t, State::kIdle);
      if (calibrated_ < p_.start.offset_samples) break;
      for (std::size_t k = 0; k < 3; ++k) offset_[k] = summed_[k] / calibrated_;
      begin_start(t);
      break;
    case State::kPilot:
      if (!run) return enter(t, State::kIdle);
      switch (pilot_.result()) {
        case PilotPulses::Result::kNone: break;
        case PilotPulses::Result::kFound:
          pilot_angle_ = pilot_.angle();
          enter(t, State::kStarting);
          break;
        case PilotPulses::Result::kNoSaliency: fail(t, Reason::kNoSaliency); break;
        case PilotPulses::Result::kNoPolarity: fail(t, Reason::kNoPolarity); break;
        case PilotPulses::Result::kNoDecay: fail(t, Reason::kNoDecay); break;
      }
      break;
    case State::kPattern:
      if (!run) return enter(t, State::kIdle);
      if (since >= p_.start.pattern_s) enter(t, State::kStarting);
      break;
    case State::kStarting: {
      if (leave) return enter(t, State::kBrake);
      if (protection_.failed() != Reason::kNone) return fail(t, protection_.failed());
      const double speed = way_ * speed_.speed();
      const bool trusted = speed > p_.start.lock_speed &&
                           protection_.plausible(way_ * estimate().emf, speed);
      if (!trusted) trusted_ = t;
      if (t - trusted_ >= p_.start.lock_s) {
        enter(t, State::kRun);
      } else if (since > p_.start.give_up_s) {
        fail(t, Reason::kNoLock);
      }
      break;
    }
    case State::kRun:
      if (protection_.failed() != Reason::kNone) return fail(t, protection_.failed());
      if (leave) enter(t, run || command.brake_to_stop || still ? State::kSlowDown : State::kIdle);
      break;
    case State::kSlowDown:
      if (!leave) return enter(t, State::kRun);
      if (way_ * speed_.speed() < p_.start.stop_speed) enter(t, State::kBrake);
      break;
    case State::kBrake:
      if (since < p_.start.brake_s) break;
      enter(t, State::kIdle);
      break;
    case State::kRetryDelay:
      if (!run) return enter(t, State::kIdle);
      if (since >= p_.start.retry_delay_s) enter(t, State::kCalibrate);
      break;
    case State::kFault:
      if (command.clear_fault && !command.run) enter(t, State::kIdle);
      break;
  }
}

}  // namespace steplock::reference::sinusoidal
