#include "testbench/sweep_page/beyond_goals.hpp"

#include "testbench/sweep_page/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

namespace steplock {
namespace {

constexpr std::size_t kShown = 3;

// What explains a run beyond a goal, and of which runs.
struct Cause {
  std::function<bool(const Row&)> of;
  const char* text;
};

struct Goal {
  const char* what;
  double goal;
  std::function<std::optional<double>(const Row&)> measured;  // nothing: not asked of this run
  std::vector<Cause> causes;                                  // the first that is of a run counts
};

std::string motor_of(const Row& r) {
  const Conditions& c = r.conditions;
  std::string t = fmt::format("inertia {:.2g}, bus {:.2g}, flux {:.2g}, load {:.2g}", c.inertia, c.bus, c.flux, c.load);
  if (c.speed != 0) t += fmt::format(", turns at {:+.2g} of the set speed", c.speed);
  return t;
}

std::string part(const std::vector<Row>& rows, const Goal& goal) {
  std::vector<const Row*> beyond;
  std::size_t asked = 0;
  for (const Row& r : rows) {
    const auto measured = goal.measured(r);
    asked += measured.has_value();
    if (measured && *measured > goal.goal) beyond.push_back(&r);
  }
  if (beyond.empty()) return "";
  std::string t = fmt::format("{} beyond {:g}: {} of {} runs.", goal.what, goal.goal, beyond.size(), asked);
  std::vector<std::size_t> of(goal.causes.size() + 1);  // the last is none
  for (const Row* r : beyond) {
    const auto cause = std::ranges::find_if(goal.causes, [&](const Cause& c) { return c.of(*r); });
    ++of[static_cast<std::size_t>(cause - goal.causes.begin())];
  }
  for (std::size_t k = 0; k < goal.causes.size(); ++k) {
    if (of[k] > 0) t += fmt::format(" {} {}.", of[k], goal.causes[k].text);
  }
  if (of.back() > 0) t += fmt::format(" {}: not explained here.", of.back());
  std::ranges::stable_sort(beyond, std::greater{}, [&](const Row* r) { return *goal.measured(*r); });
  t += "\n\n| replay | measured | motor |\n|---|---:|---|\n";
  for (std::size_t k = 0; k < std::min(kShown, beyond.size()); ++k) {
    const Row& r = *beyond[k];
    t += fmt::format("| {} `--replay {}` | {:.3g} | {} |\n", r.drive, r.seed, *goal.measured(r), motor_of(r));
  }
  return t + "\n";
}

std::optional<double> lock_of(const Row& r) {
  return r.findings.outcome == Outcome::kStarted ? r.findings.lock_time_s : std::nullopt;
}

bool light(const Row& r) { return r.conditions.inertia < 1; }
bool heavy(const Row& r) { return r.conditions.inertia > 1; }
// The duty of the file's back-EMF is a fifth too much for it, and it follows that at once.
bool eager(const Row& r) { return r.conditions.bus > 1.2 * r.conditions.flux && r.conditions.inertia < 3; }
// Those that eager() is not asked of.  A little more inertia explains nothing (m2310p_servo 1684255456947816, 1.18 times).
bool swings(const Row& r) { return r.conditions.inertia >= 3; }
bool again(const Row& r) { return r.findings.retries > 0; }
bool any(const Row&) { return true; }

std::vector<Goal> six_step_goals(const SweepSetup& setup) {
  const auto backwards = [](const Row& r) { return r.conditions.speed < 0; };
  return {
      {"Peak current, over the limit,", kPeakGoal, [&](const Row& r) { return peak_over_limit(setup, r); },
       {{backwards, "turned backwards, and such a rotor is braked by shorted windings: that current flows through no shunt, and the duty that "
                    "bounds it is made for the file's flux and bus"}}},
      {"Time to lock, s,", kLockGoal, lock_of,
       {{backwards, "turned backwards first"},
        {again, "needed more than one attempt"},
        {heavy, "had more inertia than the file's, and a limit to its torque"}}},
      {"Kick backwards, electrical degrees,", kKickGoal, [](const Row& r) { return r.findings.kick_deg; },
       {{any, "passed more than the one edge that tells the direction: a code and its opposite, turned the other way, look alike, and "
              "the back-EMF of a first edge may be less than the comparators' offset and noise"}}},
      {"Speed from rest, over the set speed,", kSpeedGoal, [](const Row& r) { return r.findings.peak_speed; },
       {{eager, "had so much bus for its flux that the duty of the file's back-EMF took it on, before speed control had taken that back"},
        {light, "had less inertia than the file's, and got there under the limit's current while its direction was being told"},
        {swings, "had more inertia than the file's, three times of it at least, and swung at the end of the ramp: the control is designed for the file's inertia"}}},
  };
}

std::vector<Goal> sinusoidal_goals(const SweepSetup& setup) {
  const auto pilot = [&](const Row& r) {
    const SweepDrive* d = drive_of(setup, r);
    return d != nullptr && d->pilot;
  };
  return {
      {"Peak current, over the limit,", kPeakGoal, [&](const Row& r) { return peak_over_limit(setup, r); },
       {{pilot, "were found by pilot pulses, whose lengths are the file's: bus and inductance set their current"}}},
      {"Time to lock, s,", kLockGoal, lock_of, {{again, "needed more than one attempt"}}},
      {"Kick backwards, electrical degrees,", kKickGoal, [](const Row& r) { return r.findings.kick_deg; },
       {{again, "turned backwards in an attempt that was given up"},
        {any, "were turned backwards before the lock: by the pattern (half a turn at most to its first place, and "
              "swings), or by an angle that was mistaken"}}},
      {"Speed from rest, over the set speed,", kSpeedGoal, [](const Row& r) { return r.findings.peak_speed; },
       {{heavy, "had more inertia than the file's, and swung at the end of the ramp: the control is designed for the file's inertia"}}},
  };
}

}  // namespace

std::string beyond_goals(const SweepSetup& setup, const std::vector<Row>& rows) {
  const bool sinusoidal = setup.drive_kind == design::DriveKind::kSinusoidal;
  std::string t;
  for (const Goal& goal : sinusoidal ? sinusoidal_goals(setup) : six_step_goals(setup)) t += part(rows, goal);
  if (t.empty()) return t;
  return fmt::format("## Beyond the goals\n\nThe {} worst of each. One that is beyond what its own motor's physics explains "
                     "([bounds](drive_file.md#bounds)) is rough.\n\n", kShown) + t;
}

}  // namespace steplock
