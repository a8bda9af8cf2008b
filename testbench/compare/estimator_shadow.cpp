#include "testbench/compare/estimator_shadow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/design/sinusoidal/config.hpp"
#include "model/reference/sinusoidal/current_model.hpp"
#include "testbench/compare/control_shadow.hpp"
#include "testbench/compare/differences.hpp"
#include "testbench/compare/rounding.hpp"
#include "testbench/compare/speed_shadow.hpp"
#include "testbench/run/drive_loop.hpp"
#include "testbench/drive/sinusoidal/fixed_engine.hpp"

namespace steplock::sinusoidal {
namespace {

namespace exact = reference::sinusoidal;

constexpr double kTurn = 2 * std::numbers::pi;

// What a sample showed, in turns; Delta i's sources in full scales.
struct Compared {
  double time, angle, step;         // fixed less float
  double gamma, delta;              // likewise, A
  double turns;                     // per sample, in doubles
  double voltage, current;          // lengths, of a phase's peak
  std::vector<double> legs;         // fixed less float, clocks
};

// The blocks drive.  Orders are those under which a sample is taken: what the sequence said when the one before came.
class ShadowedEngine {
 public:
  // `from_s`: when the span begins.
  ShadowedEngine(const design::Settings& s, const design::sinusoidal::Parameters& p, double sense, double from_s)
      : fixed_(s, adc_parameters(s)),
        adc_(adc_parameters(s)),
        p_(p),
        clock_hz_(s.control.clock_hz),
        place_(std::ldexp(design::sinusoidal::current_range(s), -15)),
        sense_(sense),
        period_clocks_(design::sinusoidal::quantise(s).config["bridge.period"]),
        applied_(p.applied),
        current_model_(p.motor, p.current_model, p.pwm.period),
        voltage_model_(p.motor, p.voltage_model, p.pwm.period),
        control_(s, p),
        speed_(s, p),
        from_s_(from_s) {}

  void set_pins(const plant::Pins&) {}
  void set_command(const HostCommand& c) {
    fixed_.set_command(c);
    way_ = c.reverse ? -1 : 1;
  }
  void set_reading(const plant::State& s) {
    fixed_.set_reading(s);
    const plant::AdcCodes codes = adc_.sample(s, samples_++);
    for (std::size_t k = 0; k < 2; ++k) codes_[k] = codes.current[k];
    v_dc_ = codes.bus * adc_.voltage_lsb();
    ordered_ = next_orders_;
    next_orders_ = fixed_.watch().state();
    read_ = true;
  }
  void tick() { run(1); }
  std::uint64_t run(std::uint64_t most) {
    const std::uint64_t taken = fixed_.run(most);
    clock_ += taken;
    const auto& out = fixed_.output();
    // A sample's orders are those of the clock that takes its codes.
    if (read_) regulates_ = out.estimating, read_ = false;
    if (out.sample) ended_ = running_, running_ = {on(out.on_u), on(out.on_v), on(out.on_w)};
    if (out.done && !done_) take(out);
    done_ = out.done;
    return taken;
  }
  Watch watch() const { return fixed_.watch(); }
  View view() const { return fixed_.view(); }

  const std::vector<Compared>& compared() const { return compared_; }
  Rounding legs_error() const { return control_.error(); }
  const SpeedShadow& regulator() const { return speed_; }

 private:
  double on(LegClocks clocks) const { return static_cast<double>(clocks.raw()) / period_clocks_; }
  const exact::Estimate& estimate() const {
    return p_.estimator == design::Estimator::kCurrent ? current_model_.estimate() : voltage_model_.estimate();
  }

  // A sample is worked through: its angle is new.
  void take(const SinusoidalTop::Out& out) {
    if (ordered_ != State::kCalibrate) {
      calibrated_ = 0;
    } else if (calibrated_ < kOffsets) {
      if (calibrated_++ == 0) offset_ = {};
      for (std::size_t k = 0; k < 2; ++k) offset_[k] += codes_[k] / static_cast<double>(kOffsets);
    }
    const double lsb = adc_.current_lsb(), u = (codes_[0] - offset_[0]) * lsb * sense_, v = (codes_[1] - offset_[1]) * lsb;
    const exact::Phases now{u, v, -u - v};
    const bool estimates = ordered_ == State::kStarting || ordered_ == State::kRun || ordered_ == State::kSlowDown;
    const double angle = static_cast<double>(out.angle.raw()) / (1 << 24);
    if (regulates_) {
      control_.take(out, shown_);
      // This angle tells the step of the sample before.
      if (regulated_) speed_.take(shown_, std::remainder(angle - angle_, 1), way_, static_cast<double>(clock_) / clock_hz_ > from_s_);
    } else {
      control_.rest();
      speed_.rest();
    }
    regulated_ = regulates_;
    if (estimates) {
      follow(out, angle, now);
    } else {
      estimated_ = false;
    }
    angle_ = angle, before_ = now, v_dc_before_ = v_dc_, shown_ = out;
  }

  void follow(const SinusoidalTop::Out& out, double angle, const exact::Phases& now) {
    if (!estimated_) {
      const double initial = kTurn * static_cast<double>(out.initial.raw()) / (1 << 24);
      current_model_.start(initial, 0);
      voltage_model_.start(initial, 0);
    }
    exact::Phases mean;
    for (std::size_t k = 0; k < 3; ++k) mean[k] = 0.5 * (before_[k] + now[k]);
    const exact::Interval interval{.voltage = exact::clarke(applied_(ended_, mean, 0.5 * (v_dc_ + v_dc_before_))),
                                   .before = exact::clarke(before_),
                                   .current = exact::clarke(now)};
    const double edge = ordered_ == State::kStarting ? -way_ * p_.start.lock_speed : 0;
    const double step_before = estimate().speed * p_.pwm.period / kTurn;
    current_model_.set_edge(edge), voltage_model_.set_edge(edge);
    current_model_.update(interval), voltage_model_.update(interval);
    // The blocks' step shows in the next angle.
    if (estimated_ && ordered_ == State::kRun) {
      const double seen_from = kTurn * static_cast<double>(out.angle.raw() >> 8) / 65536;  // as Park sees it
      const double alpha = now[0], beta = (now[0] + 2 * now[1]) / std::numbers::sqrt3;
      const double sine = std::sin(seen_from), cosine = std::cos(seen_from);
      compared_.push_back({.time = static_cast<double>(clock_) / clock_hz_,
                           .angle = std::remainder(angle - estimate().angle / kTurn, 1),
                           .step = std::remainder(angle - angle_, 1) - step_before,
                           .gamma = place_ * static_cast<double>(out.i_gamma.raw()) - (alpha * cosine + beta * sine),
                           .delta = place_ * static_cast<double>(out.i_delta.raw()) - (beta * cosine - alpha * sine),
                           .turns = std::abs(step_before),
                           .voltage = interval.voltage.length() / std::sqrt(1.5),
                           .current = interval.current.length() / std::sqrt(1.5),
                           .legs = control_.clocks()});
    }
    estimated_ = true;
  }

  static constexpr int kOffsets = 16;  // samples of a calibration, in the blocks

  FixedEngine fixed_;
  plant::Adc adc_;
  design::sinusoidal::Parameters p_;
  double clock_hz_, place_, sense_, period_clocks_;  // place_: of s0.15, A
  exact::AppliedVoltage applied_;
  exact::CurrentModelEstimator current_model_;
  exact::VoltageModelEstimator voltage_model_;
  std::int64_t samples_ = 0;
  std::uint64_t clock_ = 0;
  std::array<int, 2> codes_ = {};
  std::array<double, 2> offset_ = {};
  double v_dc_ = 0, v_dc_before_ = 0;
  State ordered_ = State::kIdle, next_orders_ = State::kIdle;
  exact::Phases ended_ = {}, running_ = {}, before_ = {};
  int calibrated_ = 0, way_ = 1;
  bool done_ = false, estimated_ = false, read_ = false, regulates_ = false, regulated_ = false;
  double angle_ = 0;  // turns, at the sample before
  SinusoidalTop::Out shown_;  // likewise
  ControlShadow control_;
  SpeedShadow speed_;
  double from_s_;
  std::vector<Compared> compared_;
};

// What word lengths put into a step, in turns: what lasts and what scatters; estimator_shadow.hpp has the equations.
Rounding step_error(const design::Settings& s, const std::vector<Compared>& all) {
  const auto q = design::sinusoidal::quantise(s);
  const auto word = [&](const char* name, int fraction) { return std::ldexp(q.config[name], -fraction); };
  const double gain = word("estimator.gain", 13), decay = word("estimator.decay", 15), k_theta = word("estimator.k_theta", 14);
  const double dc = s.inverter.bus_v / design::sinusoidal::voltage_range(s);
  double voltage = 0, current = 0, turns = 0;
  for (const Compared& c : all) {
    voltage = std::max(voltage, c.voltage / design::sinusoidal::voltage_range(s));
    current = std::max(current, c.current / design::sinusoidal::current_range(s));
    turns = std::max(turns, c.turns);
  }
  const double sixteenth = 65536 * dc / (16 * word("bridge.period", 0));  // of a clock, in places of 2^-16
  const double legs = std::sqrt(6) / 3 * sixteenth * std::hypot(kUniform, word("bridge.dead_time_loss", 6));
  const double moved = std::hypot(gain * std::hypot(legs, 2 * kUniform), kUniform * std::sqrt(6)) / 65536;
  const double per_clock = word("bridge.reciprocal", 0) * dc;  // the whole number that the blocks have for the volts in a clock
  const double of_voltage = rounded(q.rows, "estimator.gain") + rounded(q.rows, "bridge.reciprocal") + 0.5 / per_clock;
  const double moved_wrongly = gain * voltage * of_voltage + decay * current * rounded(q.rows, "estimator.decay");
  const bool voltage_model = q.config["estimator.voltage"] != 0;
  const double by_emf = voltage_model ? word("estimator.k_emf", 15) : word("estimator.k_speed", 17) / gain;
  return {moved_wrongly * (k_theta + by_emf) + turns * rounded(q.rows, voltage_model ? "estimator.k_emf" : "estimator.k_speed"),
          moved * (k_theta + by_emf)};
}

}  // namespace

FloatErrors shadow_errors(const design::Settings& s, const Result& blocks, const std::function<bool(double done)>& progress,
                          const std::optional<design::sinusoidal::Parameters>& reference, double sense) {
  FloatErrors result;
  result.compared = "samples";
  if (!blocks.locked || !blocks.speed_time_s) return result;
  result.from_s = *blocks.speed_time_s;
  result.to_s = load_end(s.scenario);
  if (result.from_s >= result.to_s) return result;
  design::Settings part = s;  // the same run, as far as it is needed
  part.scenario.duration_s = result.to_s;
  design::sinusoidal::Parameters parameters = reference.value_or(design::sinusoidal::design_drive(s).parameters);
  // What the bridge does is the blocks': their gate guard has a floor.
  parameters.applied.dead_time =
      std::max(parameters.applied.dead_time, design::sinusoidal::kDeadTimeFloor / s.control.clock_hz);
  ShadowedEngine engine(s, parameters, sense, result.from_s);
  run_recorded<ShadowedEngine, Recorder>(engine, part, {.angle_deg = blocks.angle_deg, .progress = progress});

  std::vector<Compared> all = engine.compared();
  std::erase_if(all, [&](const Compared& c) { return c.time < result.from_s; });
  result.count = all.size();
  if (all.empty()) return result;
  const double slowest = std::ranges::min(all, {}, &Compared::turns).turns;
  const double taken_away = 2 * kTurn * slowest;  // of an angle's error, per sample
  const Rounding step = step_error(s, all);
  const double rpm = rpm_of_steps(6 * s.control.pwm_hz, s.motor.pole_pairs);  // of a turn per sample
  Differences angle, speed, gamma, delta, legs;
  double longest = 0;
  for (const Compared& c : all) {
    angle.add(360 * c.angle), speed.add(rpm * c.step), gamma.add(c.gamma), delta.add(c.delta);
    longest = std::max(longest, c.current);
    for (const double clocks : c.legs) legs.add(clocks);
  }
  const auto row = [](const char* name, const char* unit, double bias, double scatter) {
    return design::BudgetRow{.name = name, .unit = unit, .rms = scatter, .bound = bias + 6 * scatter, .bias = bias};
  };
  const double place = std::ldexp(design::sinusoidal::current_range(s), -15);  // A
  const double lasts = 0.5 * place + 2 * std::ldexp(1, -15) * std::numbers::sqrt2 * longest;
  const double scatters = kUniform * std::numbers::sqrt2 * place;
  constexpr double kCut = 1.0 / 131072;  // turns: sine and cosine are those of 16 bits of the angle, cut
  const SpeedShadow& regulator = engine.regulator();
  result.signals = {angle.beside(row("estimated angle", "deg", 360 * (step.bias / taken_away + kCut),
                                     360 * step.scatter / std::sqrt(2 * taken_away))),
                    speed.beside(row("momentary speed", "rpm", rpm * step.bias, rpm * step.scatter)),
                    gamma.beside(row("current, gamma", "A", lasts, scatters)), delta.beside(row("current, delta", "A", lasts, scatters)),
                    legs.beside(row("on-time", "clocks", engine.legs_error().bias, engine.legs_error().scatter)),
                    regulator.speed().beside(row("smoothed speed", "rpm", regulator.speed_error().bias, regulator.speed_error().scatter)),
                    regulator.current().beside(
                        row("wanted current", "A", regulator.current_error().bias, regulator.current_error().scatter))};
  return result;
}

}  // namespace steplock::sinusoidal
