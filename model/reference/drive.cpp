// See drive.hpp for the chain; here it is walked once per event.
#include "model/reference/drive.hpp"

#include <cassert>

namespace steplock::reference {

Drive::Drive(const design::Parameters& p)
    : p_(p),
      pwm_(p.pwm),
      limit_(p.limit),
      bemf_(p.bemf),
      detector_(p.loop),
      filter_(p.loop),
      speed_(p.speed, p.pwm.tick()),
      sequence_(p.start, p.source, p.pwm.tick()),
      protection_(p.protection, p.pwm.tick()),
      decoder_(p.bemf.samples * p.bemf.sample_every),
      follower_(p.start, p.bemf.sample_every),
      guard_(p.pwm),
      target_(p.speed.target) {}

bool Drive::loop_closed() const {
  return p_.source == design::Source::kBemf &&
         (sequence_.state() == State::kPullIn || sequence_.locked());
}

bool Drive::commutating() const {
  return sequence_.state() == State::kAccelerate || sequence_.state() == State::kPullIn ||
         sequence_.locked();
}

Mode Drive::mode() const {
  switch (sequence_.state()) {
    case State::kPreAlign:
      return Mode::kPreAlign;
    case State::kAlign:
      return Mode::kAlign;
    case State::kBrake:
      return Mode::kBrake;
    case State::kAccelerate:
      // The current of a rotor that may turn the other way circulates and grows: gates off instead.
      return following() && !(follower_.drives() && (follower_.sure() || limit_.on())) ? Mode::kOff : Mode::kDrive;
    default:
      return commutating() ? Mode::kDrive : Mode::kOff;
  }
}

Output Drive::update(double t, const Pins& pins, const Command& command,
                     const std::optional<Bridge>& bridge) {
  assert(t <= next_ * (1 + 1e-12));
  pwm_.update(t);
  limit_.update(t, pwm_.on(), pins.limit, sequence_.locked() || (following() && !follower_.sure()));
  limited_ |= limit_.hit();
  vco_.update(t, sequence_.reverse());
  bemf_.update(t, pins, bridge.value_or(Bridge{vco_.step(), limit_.on()}), vco_.phase(t),
               sequence_.reverse(), mode() == Mode::kDrive && p_.source == design::Source::kBemf);

  // Phase detector: the step that ended is the one before the present one.
  const int ended = (vco_.step() + (sequence_.reverse() ? 1 : 5)) % 6;
  const int looked_at = vco_.commutated() ? ended : vco_.step();
  const bool u_rises = kFloating[looked_at] == 0 && crossing_rises(looked_at, sequence_.reverse());
  detector_.update({.crossing = bemf_.crossing(),
                    .crossing_phase = bemf_.crossing_phase(),
                    .before_seen = bemf_.before_seen(looked_at),
                    .step_ended = vco_.commutated() && commutating() && !following(),
                    .counts = u_rises || p_.loop.detector == design::Detector::kEveryStep,
                    .window = p_.start.window});
  if (loop_closed()) {
    if (p_.loop.form == design::LoopForm::kPerStep) {
      if (detector_.updated()) filter_.step(detector_.error());
    } else if (pwm_.tick()) {
      filter_.run(detector_.error(), p_.pwm.tick());
    }
    if (filter_.frequency() != vco_.frequency()) vco_.set_frequency(t, filter_.frequency());
  }

  const bool hall = p_.source == design::Source::kHall;
  decoder_.update(t, hall ? pins.hall : pins.comparator);
  caught_ = 0;
  if (sequence_.state() == State::kDetectSpin) detect_spin(t, follows() && command.run && target_ != 0);
  if (hall && sequence_.locked()) follow_halls(t);
  if (following()) follow_rotor(t, pins);

  protection_.update({.running = sequence_.locked(),
                      .tick = pwm_.tick(),
                      .commutated = vco_.commutated() && !hall,
                      .updated = detector_.updated(),
                      .good = detector_.good(),
                      .missed = detector_.missed(),
                      .lags = detector_.error() < 0,
                      .hall = hall,
                      .hall_illegal = decoder_.illegal(),
                      .fault_pin = pins.fault,
                      .frequency = filter_.frequency(),
                      .slip = speed_.duty() - speed_.loaded_duty(filter_.frequency()),
                      .freewheel = bemf_.freewheel(),
                      .stuck = limit_.stuck()});
  // While pulling in, a step without a good crossing says nothing of the speed: the duty rises on none.
  limited_ |= holds_ && detector_.updated() && !detector_.good();
  sequence_.update({.tick = pwm_.tick(),
                    .command = command,
                    .fatal = protection_.fatal(),
                    .lost = protection_.lost(),
                    .fault_pin = pins.fault,
                    .updated = detector_.updated(),
                    .good = detector_.good(),
                    .ramp_done = ramp_done_,
                    .blocked = following() && follower_.blocked(),
                    .hopeful = following() && follower_.moves(),
                    .still = target_ == 0,
                    .frequency = filter_.frequency(),
                    .caught = caught_});
  const bool missed = detector_.missed();
  // A rotor started with more torque than it needs leads the field; less and less lets it fall back
  // to where its crossings show, whatever flux and bus voltage really are.
  // A rotor that lags has too little and gets more, up to the start's.
  if (sequence_.state() == State::kPullIn && !follows() && vco_.commutated()) {
    const bool lags = detector_.error() < 0;
    if (!lags || boost_ < stronger(p_.start.start_duty)) boost_ += lags ? boost_ / 32 : -boost_ / 32;
  }
  if (sequence_.entered()) enter_state(t);
  if (pwm_.tick()) on_tick(t);

  // A cut of a rotor that runs turns all gates off, so that the bus takes every winding's current down.
  const Mode asked = limit_.cut() && sequence_.locked() ? Mode::kOff : mode();
  const Gates wanted = gates_wanted(asked, vco_.step(), limit_.on(), p_.pwm.complementary);
  guard_.update(t, wanted, mode() != Mode::kOff);

  next_ = std::min(
      {pwm_.next(t), limit_.next(t), vco_.next(), bemf_.next(), decoder_.next(), guard_.next()});
  if (following()) next_ = std::min({next_, follower_.next(), overdue_});
  if (next_ <= t) next_ = std::nextafter(t, kNever);
  return {.gates = guard_.gates(),
          .state = sequence_.state(),
          .reason = sequence_.reason(),
          .locked = sequence_.locked(),
          .step = vco_.step(),
          .frequency = filter_.frequency(),
          .step_phase = vco_.phase(t),
          .phase_error = detector_.error(),
          .duty = speed_.duty(),
          .chop = limit_.on(),
          .commutate = vco_.commutated(),
          .crossing = bemf_.crossing(),
          .missed = missed,
          .crossing_phase = bemf_.crossing_phase(),
          .freewheel = bemf_.freewheel()};
}

// A rotor that coasts shows all three back-EMFs: signs are the sector, changes the speed.
void Drive::detect_spin(double t, bool to_be_followed) {
  if (!decoder_.settled()) return;
  const double turns = filter_.frequency() * (t - changed_);
  const int way = decoder_.direction();
  const bool steady = way != 0 && way == way_ && std::abs(1 - turns) < 0.125;
  steady_ = steady ? steady_ + 1 : 0;
  way_ = way;
  changed_ = t;
  if (way != 0) filter_.catch_up(turns);
  // Slower ones are started; so are backward ones below hand-over, which a follower turns round.
  const bool on = (way > 0) != sequence_.reverse();
  const double least = on || !to_be_followed ? p_.start.hand_over / 2 : p_.start.hand_over;
  if (steady_ < p_.start.good_crossings || filter_.frequency() < least) return;
  caught_ = on ? 1 : -1;
}

void Drive::follow_halls(double t) {
  const double turns = filter_.frequency() * (t - changed_);
  if (!decoder_.settled() && turns < 2) return;
  filter_.catch_up(turns);
  changed_ = t;
  if (decoder_.settled()) {
    vco_.load(t, (decoder_.sector() + (sequence_.reverse() ? 3 : 0)) % 6, 0);
  }
}

// The VCO stands while the steps follow the rotor; its frequency is that of the intervals between edges.
void Drive::follow_rotor(double t, const Pins& pins) {
  const double f = filter_.frequency();
  const bool fast = f >= p_.start.hand_over, slow = f < p_.protection.stall;
  const bool overdue = t >= overdue_;
  follower_.update(t, {.comparator = {pins.comparator[0], pins.comparator[1], pins.comparator[2]},
                       .crossing = bemf_.crossing(),
                       .overdue = overdue,
                       .update = measured_,
                       .ready = good_interval_ && (fast || (!slow && steady_ + 1 >= p_.start.good_crossings)),
                       .step = vco_.step(),
                       .reverse = sequence_.reverse()});
  measured_ = false;
  const auto measure = [&](double turns) {
    filter_.catch_up(turns);
  };
  if (overdue) {
    // A step's time more until the next look; twice that time without an edge halves the frequency.
    if (f * (t - changed_) >= 2) {
      measure(2);
      good_interval_ = false;
      steady_ = 0;
    }
    overdue_ = t + 1 / filter_.frequency();
  }
  if (follower_.loaded()) {
    const double turns = f * (t - changed_);
    if (fast && follower_.sure()) ++fast_steps_;
    eases_ = false;
    if (follower_.changed()) {
      // Of a rotor that was fast before, and so hardly accelerated; or of one that has been steady for long.
      const bool good = f > 0 && std::abs(1 - turns) < 0.125;
      good_interval_ = good && (fast || steady_ + 1 >= p_.start.good_crossings);
      steady_ = good ? steady_ + 1 : 0;
      measured_ = true;
      if (f > 0) {
        measure(turns);
      } else {
        filter_.load(p_.start.hand_over);
      }
    }
    vco_.load(t, *follower_.loaded(), 0);
    changed_ = t;
    overdue_ = filter_.frequency() > 0 ? t + 1.25 / filter_.frequency() : kNever;
  }
  if (!follower_.sure()) good_interval_ = false;
  ramp_done_ = follower_.caught();
}

void Drive::enter_state(double t) {
  switch (sequence_.state()) {
    case State::kDetectSpin:
      decoder_.restart();
      filter_.load(p_.start.hand_over);
      steady_ = way_ = 0;
      changed_ = t;
      break;
    case State::kPullIn:
      if (!follows()) break;
      vco_.load(t, vco_.step(), 0.5);
      vco_.set_frequency(t, filter_.frequency());
      detector_.restart();
      holds_ = boosted_ = false;
      follower_.end();
      break;
    case State::kAccelerate:
      if (follows()) {
        filter_.load(0);
        vco_.stop(t);
        changed_ = t;
        overdue_ = kNever;
        ramp_done_ = good_interval_ = measured_ = fell_ = eases_ = was_fast_ = false;
        steady_ = fast_steps_ = 0;
        follower_.begin(t);
        break;
      }
      filter_.load(0);
      vco_.stop(t);
      vco_.load(t, sequence_.reverse() ? 0 : 3, 0.5);
      detector_.restart();
      ramp_done_ = false;
      break;
    case State::kRun:
      if (caught_ > 0) {
        const int s = decoder_.sector();
        vco_.load(t, sequence_.reverse() ? s : (s + 5) % 6, 0.5);
        vco_.set_frequency(t, filter_.frequency());
        detector_.restart();
        const double duty = speed_.bemf_duty(filter_.frequency());
        speed_.follow(duty, duty, filter_.frequency());
      } else if (p_.source == design::Source::kHall) {
        filter_.load(p_.loop.minimum);
        decoder_.restart();
        speed_.follow(p_.start.start_duty, p_.start.start_duty, 0);
      }
      break;
    default:
      if (!commutating()) vco_.stop(t);
      break;
  }
}

void Drive::join(double t, const Joined& other) {
  sequence_.join(other.reverse);
  filter_.join(other.frequency, other.phase_error);
  vco_.set_frequency(t, other.frequency);
  vco_.load(t, other.step, other.step_phase);
  detector_.restart(other.phase_error);
  speed_.join(other.duty, other.reference, other.frequency);
  pwm_.set_duty(other.duty);
  next_ = std::min(next_, vco_.next());
}

void Drive::on_tick(double t) {
  const auto& s = p_.start;
  const double f = filter_.frequency();
  // A load too heavy for the ramp fails; the next attempt takes a quarter of it, three times.
  const double ramp = std::ldexp(s.ramp, -2 * std::min(sequence_.retries(), 3));
  double duty = 0;
  switch (sequence_.state()) {
    case State::kPreAlign:
    case State::kAlign:
      duty = stronger(s.align_duty);
      break;
    case State::kBrake:
      duty = std::clamp(s.brake_duty - speed_.bemf_duty(f), 0.0, p_.speed.maximum);
      break;
    case State::kAccelerate:
      if (follows()) {
        // One that has hand-over's frequency hardly accelerates, so that it is known when it is handed over.
        const bool fast = follower_.sure() && f >= s.hand_over;
        const bool falls = was_fast_ && !fast;
        fell_ = fell_ || (falls && fast_steps_ != 1);
        eases_ = eases_ || falls;
        if (!fast) fast_steps_ = 0;
        was_fast_ = fast;
        boost_ = !follower_.sure() ? s.align_duty : !fast ? s.start_duty / (eases_ ? 2 : 1) : part_of(s.start_duty);
        duty = std::min(boost_ + speed_.bemf_duty(f), p_.speed.maximum);
        break;
      }
      filter_.load(std::min(f + ramp * p_.pwm.tick(), s.hand_over));
      vco_.set_frequency(t, filter_.frequency());
      ramp_done_ = filter_.frequency() >= s.hand_over;
      boost_ = stronger(s.start_duty);
      duty = std::min(boost_ + speed_.bemf_duty(f), p_.speed.maximum);
      break;
    case State::kPullIn:
      if (follows()) boost_ = part_of(s.start_duty);
      duty = std::min(boost_ + speed_.bemf_duty(f), p_.speed.maximum);
      break;
    default:
      break;
  }
  // A rotor that was followed is controlled while it is pulled in, from the second tick on.
  const bool pulls_in = follows() && sequence_.state() == State::kPullIn;
  holds_ = pulls_in && boosted_;
  boosted_ = pulls_in;
  if (sequence_.locked() || holds_) {
    // Freewheeling of 15/32 of a step, and more current would hide the crossing, if it is not hidden yet.  Not while pulling in.
    const bool freewheels = p_.source != design::Source::kHall && sequence_.locked() && bemf_.freewheel() >= 15.0 / 32;
    speed_.tick(sequence_.state() == State::kSlowDown ? s.hand_over : target_, f, limited_,
                detector_.masked_lead(), freewheels);
  } else {
    speed_.follow(duty, duty, f);
  }
  limited_ = false;
  pwm_.set_duty(speed_.duty());
}

}  // namespace steplock::reference
