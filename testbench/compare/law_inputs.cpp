#include "testbench/compare/law_inputs.hpp"

#include "model/design/design.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/drive/six_step/run.hpp"

namespace steplock {
namespace {

// The blocks as an engine that writes down what three of them are given.
class ListeningEngine {
 public:
  // `shake`: clocks between two set speeds, 0: the scenario's alone.
  ListeningEngine(const SixStepConfig& config, double clock_hz, std::uint64_t shake)
      : fixed_(config, clock_hz), config_(config), clock_hz_(clock_hz), shake_(shake) {}

  void set_pins(const plant::Pins& pins) { fixed_.set_pins(pins); }
  void set_command(const HostCommand& c) {
    command_ = c;
    fixed_.set_command(c);
  }
  void tick() {
    const SkippingTop& top = fixed_.top();
    const bool ticks = top.at_tick(), masked_lead = top.masked_lead(), freewheels = top.freewheels();
    // A cut counts in control; and there, while pulling in, a step without a good crossing.
    const bool locked = fixed_.output().locked;
    if (controls(locked)) limited_ = limited_ || top.limited() || (top.without_crossing() && !locked);
    if (shake_ > 0 && clock_ % shake_ == shake_ - 1) shake();
    fixed_.tick();
    ++clock_;
    look();
    if (ticks) {
      tell_speed(masked_lead, freewheels);
      told_at_ = clock_;
    } else if (asked_speed_ && clock_ - told_at_ <= kAtWork) {
      const SpeedControlLaw::In& in = told_.speed.back().in;
      const bool same = fixed_.output().frequency == in.frequency && fixed_.top().masked_lead() == in.masked_lead &&
                        fixed_.top().freewheels() == in.freewheels && !fixed_.top().limited() &&
                        controls(fixed_.output().locked) == (in.mode == SpeedMode::kControl);
      told_.speed.back().disturbed |= !same;
    }
  }
  std::uint64_t quiet() const {
    const std::uint64_t clocks = fixed_.quiet();
    return shake_ == 0 ? clocks : std::min(clocks, shake_ - 1 - clock_ % shake_);
  }
  void skip(std::uint64_t clocks) {
    fixed_.skip(clocks);
    clock_ += clocks;
  }
  Watch watch() const { return fixed_.watch(); }
  DriveView view() const { return fixed_.view(); }

  LawInputs take() {
    answer_loop();
    answer_speed();
    return std::move(told_);
  }

 private:
  using Out = SixStepTop::Out;
  static constexpr std::uint64_t kAtWork = 140;         // clocks: speed_control.hpp's latency
  static constexpr std::uint64_t kLoopAtWork = 7 * 24;  // clocks: loop_filter.hpp's six products, and bounds

  double time() const { return static_cast<double>(clock_) / clock_hz_; }

  // From half the set speed to the whole of it, in an order that repeats itself after all.
  void shake() {
    constexpr int kParts[] = {32, 22, 29, 16, 27, 19, 31, 24};
    const double full = std::ldexp(static_cast<double>(config_.speed.target.raw()) * clock_hz_, -32 - int(config_.loop.divide.raw()));
    HostCommand c = command_;
    c.set_speed = full * kParts[clock_ / shake_ % std::size(kParts)] / 32;
    fixed_.set_command(c);
  }

  void look() {
    const Out& out = fixed_.output();
    const bool tracks = config_.source == Source::kBemf && (out.locked || out.state == State::kPullIn);
    if (!tracks) {
      // An update that the end of tracking overtook has no answer.
      if (asked_loop_ && clock_ - loop_at_ <= kLoopAtWork) told_.loop.pop_back(), asked_loop_ = false;
      answer_loop();
      watched_ = tracked_ = false;
      return;
    }
    if (out.update) {
      told_.detector.push_back({.time = time(), .crossing = !out.missed, .before_seen = out.phase_error.negative(),
                                .crossing_phase = last_crossing_, .error = out.phase_error, .begins = !watched_});
      watched_ = true;
      if (config_.loop.bandwidth == Bandwidth::kPerStep) tell_loop(out);
    }
    // The detector answers a clock later.
    if (out.crossing) last_crossing_ = out.crossing_phase;
  }

  void tell_loop(const Out& out) {
    answer_loop();
    const auto& w = config_;
    told_.loop.push_back({.time = time(),
                          .in = {.loop = Loop::kTrack, .error = out.phase_error, .bandwidth = w.loop.bandwidth,
                                 .delay = w.loop.delay >> int(w.loop.divide.raw()), .ki = w.loop.ki, .kp = w.loop.kp,
                                 .alpha = w.loop.alpha, .scale = w.loop.scale, .minimum = w.loop.minimum, .maximum = w.loop.maximum,
                                 .hand_over = w.start.hand_over, .stall = w.protection.stall},
                          .before = out.frequency, .begins = !tracked_});
    tracked_ = asked_loop_ = true;
    loop_at_ = clock_;
  }

  void tell_speed(bool masked_lead, bool freewheels) {
    answer_speed();
    const Out& out = fixed_.output();
    if (config_.source == Source::kBemf && config_.loop.bandwidth == Bandwidth::kPerSecond &&
        (out.locked || out.state == State::kPullIn)) {
      tell_loop(out);
    }
    // While pulling in, the duty is controlled from the second tick on.
    in_pull_in_ = out.state == State::kPullIn ? in_pull_in_ + 1 : 0;
    const bool control = controls(out.locked);
    told_.speed.push_back({.time = time(),
                           .in = {.mode = control ? SpeedMode::kControl : SpeedMode::kFixed, .frequency = out.frequency,
                                  .target = out.state == State::kSlowDown ? Frequency(0) : fixed_.config().speed.target,
                                  .limited = limited_, .masked_lead = masked_lead,
                                  .freewheels = freewheels, .period = config_.pwm.period, .slip = config_.protection.slip,
                                  .config = config_.speed}});
    asked_speed_ = true;
    limited_ = false;
  }

  bool controls(bool locked) const { return locked || (config_.start.method == Method::kFollow && in_pull_in_ > 1); }

  // A block has long answered when the next update comes.
  void answer_loop() {
    if (asked_loop_) told_.loop.back().after = fixed_.output().frequency;
    asked_loop_ = false;
  }
  void answer_speed() {
    if (!asked_speed_) return;
    SpeedInput& last = told_.speed.back();
    last.after = fixed_.output().duty;
    if (last.in.mode == SpeedMode::kFixed) last.in.fixed_duty = last.after;
    asked_speed_ = false;
  }

  FixedEngine fixed_;
  SixStepConfig config_;
  HostCommand command_;
  double clock_hz_;
  std::uint64_t clock_ = 0, shake_, told_at_ = 0, loop_at_ = 0;
  LawInputs told_;
  Phase last_crossing_ = 0;
  int in_pull_in_ = 0;  // ticks
  bool limited_ = false;  // since the last tick of speed control
  bool watched_ = false, tracked_ = false, asked_loop_ = false, asked_speed_ = false;
};

}  // namespace

LawInputs law_inputs(const design::Settings& s, double angle_deg, bool shaken, const std::function<bool(double done)>& progress) {
  constexpr double kShakes = 32;
  const double clock_hz = s.control.clock_hz;
  const auto config = design::quantise(design::design_drive(s).parameters, clock_hz).config;
  const auto shake = static_cast<std::uint64_t>(shaken ? s.scenario.duration_s * clock_hz / kShakes : 0);
  ListeningEngine engine(hls_config(config), clock_hz, shake);
  run_with(engine, s, {.angle_deg = angle_deg, .progress = progress});
  return engine.take();
}

}  // namespace steplock
