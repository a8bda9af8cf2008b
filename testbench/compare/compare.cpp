#include "testbench/compare/compare.hpp"

#include <algorithm>
#include <cmath>

#include "model/design/budget.hpp"
#include "testbench/compare/paired_engines.hpp"
#include "testbench/engine/words.hpp"
#include "testbench/run/drive_loop.hpp"
#include "testbench/run/units.hpp"

namespace steplock {
namespace {

// Collects differences of one signal.
class Differences {
 public:
  Differences(std::string name, std::string unit) : name_(std::move(name)), unit_(std::move(unit)) {}
  void add(double d) {
    ++count_;
    sum_ += d;
    squares_ += d * d;
    greatest_ = std::max(greatest_, std::abs(d));
  }
  SignalError error(const std::optional<design::BudgetRow>& budget = {}) const {
    const double n = std::max(1.0, static_cast<double>(count_));
    SignalError e{name_, unit_, sum_ / n, std::sqrt(squares_ / n), greatest_, {}, {}};
    if (budget) {
      e.budget_rms = budget->rms;
      e.budget_bound = budget->bound;
    }
    return e;
  }

 private:
  std::string name_, unit_;
  std::size_t count_ = 0;
  double sum_ = 0, squares_ = 0, greatest_ = 0;
};

// Pairs each fixed commutation of the span with the reference's nearest of the same step.
std::vector<std::pair<StepChange, StepChange>> pairs(const ShadowEngine& engine, double from,
                                                       double to) {
  const auto& others = engine.float_commutations();
  std::vector<std::pair<StepChange, StepChange>> all;
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
    if (best != nullptr) all.emplace_back(mine, *best);
  }
  return all;
}

std::vector<SignalError> shadow_errors(const design::Settings& s, const design::Budget& budget,
                                       const ShadowEngine& engine, const Summary& sum,
                                       std::size_t& paired) {
  const int pole_pairs = s.motor.pole_pairs;
  Differences instant("commutation instant", "s"), angle("commutation", "deg electrical"),
      error("phase error", "deg electrical"), speed("speed, momentary", "rpm"),
      mean("speed, mean", "rpm"), duty("duty", "1");
  const auto all = pairs(engine, sum.steady.from_s, sum.steady.to_s);
  paired = all.size();
  if (all.size() < 2) return {};
  const double steps = static_cast<double>(all.size() - 1);
  const double step_s = (all.back().first.time - all.front().first.time) / steps;
  for (const auto& [fixed, reference] : all) {
    instant.add(fixed.time - reference.time);
    angle.add(60 * (fixed.time - reference.time) / step_s);
    error.add(fixed.view.phase_error_deg - reference.view.phase_error_deg);
    speed.add(rpm_of_steps(fixed.view.steps_per_second - reference.view.steps_per_second,
                           pole_pairs));
    duty.add(fixed.view.duty - reference.view.duty);
  }
  const double other_s = (all.back().second.time - all.front().second.time) / steps;
  mean.add(rpm_of_steps(1 / step_s - 1 / other_s, pole_pairs));
  return {error.error(budget.phase_error), angle.error(budget.commutation),
          instant.error(budget.instant),   speed.error(budget.frequency),
          mean.error(budget.mean_speed),   duty.error(budget.duty)};
}

}  // namespace

bool Comparison::passed() const {
  return lockstep.equal() && !shadow.empty() && std::ranges::all_of(shadow, &SignalError::within);
}

Comparison compare_engines(const design::Settings& s, const CompareOptions& options) {
  const design::Design designed = design::design_drive(s);
  const double clock_hz = s.control.clock_hz;
  const design::Words quantised = design::quantise(designed.parameters, clock_hz).words;
  const Words words = hls_words(quantised);
  bool go_on = true;
  const auto run_options = [&](EngineKind kind, const char* what) {
    return RunOptions{.engine = kind, .angle_deg = options.angle_deg, .progress = [&, what](double done) {
                        go_on = !options.progress || options.progress(what, done);
                        return go_on;
                      }};
  };

  Comparison c;
  if (options.lockstep) {
    LockstepEngine engine(words, clock_hz);
    engine.flip_a_comparator_after(options.flip_at_clock);
    const Record record = run_with(engine, s, run_options(EngineKind::kFixed, "rtl = fixed"));
    c.lockstep = {record.clocks, engine.differing_clocks(), engine.first_clock(),
                  engine.first_port()};
  }
  const RunOptions fixed_options = run_options(EngineKind::kFixed, "fixed against float");
  const RunOptions float_options = run_options(EngineKind::kFloat, "float");
  if (go_on) {
    ShadowEngine engine(words, designed.parameters, clock_hz);
    c.fixed = summarise(s, fixed_options, run_with(engine, s, fixed_options));
    c.shadow = shadow_errors(s, design::error_budget(s, designed, quantised), engine, c.fixed,
                             c.paired);
  }
  if (go_on) {
    FloatEngine engine(designed.parameters, clock_hz);
    c.floating = summarise(s, float_options, run_with(engine, s, float_options));
  }
  c.fixed.interrupted = c.fixed.interrupted || !go_on;
  return c;
}

}  // namespace steplock
