#include "testbench/compare/shadow.hpp"

#include <algorithm>
#include <cmath>

#include "model/design/budget.hpp"
#include "testbench/compare/differences.hpp"
#include "testbench/compare/shadow_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/drive/six_step/run.hpp"
#include "testbench/run/units.hpp"

namespace steplock {
namespace {

struct Pair {
  StepChange fixed, reference;
};

// Each fixed commutation of the span with the reference's nearest to the same step.
std::vector<Pair> pairs(const ShadowEngine& engine, double from, double to) {
  const auto& others = engine.float_commutations();
  std::vector<Pair> all;
  for (const StepChange& mine : engine.fixed_commutations()) {
    if (mine.time < from || mine.time > to) continue;
    const auto after = std::ranges::lower_bound(others, mine.time, {}, &StepChange::time);
    const StepChange* best = nullptr;
    for (auto it = after == others.begin() ? after : after - 1; it != others.end(); ++it) {
      if (it->step == mine.step && (best == nullptr || std::abs(it->time - mine.time) <
                                                           std::abs(best->time - mine.time))) {
        best = &*it;
      }
      if (it->time > mine.time) break;
    }
    if (best != nullptr) all.push_back({mine, *best});
  }
  return all;
}

std::vector<SignalError> errors(const std::vector<Pair>& all, const design::Budget& budget,
                                int pole_pairs) {
  if (all.size() < 2) return {};
  Differences instant, angle, error, speed, mean, duty;
  const double steps = static_cast<double>(all.size() - 1);
  const double step_s = (all.back().fixed.time - all.front().fixed.time) / steps;
  for (const auto& [fixed, reference] : all) {
    instant.add(fixed.time - reference.time);
    angle.add(60 * (fixed.time - reference.time) / step_s);
    error.add(fixed.view.phase_error_deg - reference.view.phase_error_deg);
    speed.add(rpm_of_steps(fixed.view.steps_per_second - reference.view.steps_per_second,
                           pole_pairs));
    duty.add(fixed.view.duty - reference.view.duty);
  }
  const double other_s = (all.back().reference.time - all.front().reference.time) / steps;
  mean.add(rpm_of_steps(1 / step_s - 1 / other_s, pole_pairs));
  return {error.beside(budget.phase_error), angle.beside(budget.commutation),
          instant.beside(budget.instant),   speed.beside(budget.frequency),
          mean.beside(budget.mean_speed),   duty.beside(budget.duty)};
}

}  // namespace

FloatErrors shadow_errors(const design::Settings& s, const Summary& blocks,
                          const std::function<bool(double done)>& progress,
                          const std::optional<design::Parameters>& reference) {
  FloatErrors result;
  result.from_s = blocks.steady.from_s;
  result.to_s = blocks.steady.to_s;
  if (!blocks.locked || !blocks.start_time_s) return result;
  const design::Design designed = design::design_drive(s);
  const double clock_hz = s.control.clock_hz;
  const design::Config config = design::quantise(designed.parameters, clock_hz).config;
  // Where the steady span begins: the set speed is slewed all the way then, and the duty at rest.  Sooner
  // a slew that the blocks held back, and the reference does not know of, would stay in its duty for ever.
  const double tick_s = config["pwm.period"] * config["pwm.tick_periods"] / clock_hz;
  const double join_s = result.from_s - (ShadowEngine::kPatience + 1) * tick_s;
  ShadowEngine engine(hls_config(config), reference.value_or(designed.parameters), clock_hz,
                      static_cast<std::uint64_t>(join_s * clock_hz));

  design::Settings part = s;  // the same run, as far as it is needed
  part.scenario.duration_s = result.to_s;
  run_with(engine, part, {.angle_deg = blocks.angle_deg, .progress = progress});

  const auto all = pairs(engine, result.from_s, result.to_s);
  result.count = all.size();
  result.signals = errors(
      all, design::error_budget(s, designed, config, result.to_s - join_s), s.motor.pole_pairs);
  return result;
}

}  // namespace steplock
