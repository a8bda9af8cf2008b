#include "testbench/sweep/beyond_goals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>


namespace steplock {
namespace {

constexpr std::size_t kShown = 3;

struct Goal {
  const char* what;
  double goal;
  std::function<std::optional<double>(const Row&)> measured;  // nothing: not asked of this run
  const char* why;
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
  std::ranges::stable_sort(beyond, std::greater{}, [&](const Row* r) { return *goal.measured(*r); });
  std::string t = fmt::format("{} beyond {:g}: {} of {} runs. {}\n\n| replay | measured | motor |\n|---|---:|---|\n",
                              goal.what, goal.goal, beyond.size(), asked, goal.why);
  for (std::size_t k = 0; k < std::min(kShown, beyond.size()); ++k) {
    const Row& r = *beyond[k];
    t += fmt::format("| {} `--replay {}` | {:.3g} | {} |\n", r.drive, r.seed, *goal.measured(r), motor_of(r));
  }
  return t + "\n";
}

}  // namespace

std::string beyond_goals(const SweepSetup& setup, const std::vector<Row>& rows) {
  const Goal goals[] = {
      {"Peak current, over the limit,", kPeakGoal,
       [&](const Row& r) {
         const auto d = std::ranges::find(setup.drives, r.drive, &SweepDrive::name);
         return d == setup.drives.end() || d->limit_a == 0 ? std::nullopt : std::optional(r.findings.peak_current_a / d->limit_a);
       },
       "A rotor that turns backwards is braked by its shorted windings: that current flows through no shunt, and speed, flux and "
       "inductance set it."},
      {"Time to lock, s,", kLockGoal,
       [](const Row& r) { return r.findings.outcome == Outcome::kStarted ? r.findings.lock_time_s : std::nullopt; },
       "The limit's torque, less the load, needs that time, more than once where the rotor turned backwards."},
      {"Kick backwards, electrical degrees,", kKickGoal, [](const Row& r) { return r.findings.kick_deg; },
       "A code and its opposite, turned the other way, look alike, so an edge at least is passed before the direction is known; one "
       "whose back-EMF is lost in the comparators' offset and noise tells nothing, and the next is waited for."},
      {"Speed from rest, over the set speed,", kSpeedGoal, [](const Row& r) { return r.findings.peak_speed; },
       "A light rotor gets there under the limit's current while its direction is being told; a heavy one passes the set speed as the "
       "ramp ends, since the control is designed for the file's inertia."},
  };
  std::string t;
  for (const Goal& goal : goals) t += part(rows, goal);
  if (t.empty()) return t;
  return fmt::format("## Beyond the goals\n\nThe {} worst of each. One that is beyond what its own motor's physics explains "
                     "([bounds](drive_file.md#bounds)) is rough.\n\n", kShown) + t;
}

}  // namespace steplock
