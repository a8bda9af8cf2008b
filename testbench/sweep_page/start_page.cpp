// docs/starts.md and docs/sinusoidal_starts.md: the statistics of drawn starts.
#include <fmt/format.h>

#include "testbench/sweep_page/beyond_goals.hpp"
#include "testbench/sweep_page/page_head.hpp"
#include "testbench/sweep_page/statistics.hpp"

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;

std::string spread(const Json& s, const std::vector<const char*>& parts) {
  std::string t;
  for (const char* part : parts) {
    const std::string value = s[part].is_null() ? "-" : fmt::format("{:.3g}", s[part].get<double>());
    t += (t.empty() ? "" : " / ") + value;
  }
  return t;
}

std::string percent(double share, int digits = 2) { return fmt::format("{:.{}f} %", 100 * share, digits); }

double first_share(const Json& part) {
  return part["runs"] == 0 ? 0 : part["first_try"].get<double>() / part["runs"].get<double>();
}

std::string outcomes_line(const std::string& name, const Json& part) {
  std::string t = fmt::format("| {} | {} | {} | {} | {}", name, part["runs"].get<int>(), part["started"].get<int>(),
                              percent(first_share(part)), percent(part["first_try_at_least"].get<double>()));
  for (const char* key : {"started_after_retries", "rough", "latched", "silent_step_outs", "unfinished"}) {
    t += fmt::format(" | {}", part[key].get<int>());
  }
  return t + fmt::format(" | {} |\n", percent(part["lost_at_most"].get<double>(), 3));
}

std::string spreads_line(const std::string& name, const Json& s) {
  std::string t = fmt::format("| {} | {} | {} | {}", name, spread(s["lock_time_s"], {"min", "median", "p99", "max"}),
                              spread(s["speed_time_s"], {"min", "median", "max"}),
                              spread(s["kick_deg"], {"median", "p90", "p99", "max"}));
  t += " | " + spread(s["peak_current_a"], {"median", "max"});
  t += " | " + spread(s["peak_over_limit"], {"median", "p99", "max"}) + " | " + spread(s["peak_speed"], {"median", "p99", "max"});
  return t + " |\n";
}

// The columns of spreads_line.
constexpr const char* kSpreadsHead =
    "| lock, s: min / median / 99 % / max | set speed, s: min / median / max | kick: median / 90 % / 99 % / max "
    "| peak, A: median / max | peak over limit: median / 99 % / max | speed: median / 99 % / max |\n|---|---|---|---|---|---|---|\n";

std::string causes_table(const Json& j) {
  std::string t = "## Failed tries\n\nWhat the rotor did when a try was given up ([how it is told](sweep.md#a-run)).\n\n| drive ";
  std::string rule = "|---";
  for (const auto& [cause, n] : j["inside"]["causes"].items()) t += "| " + cause + " ", rule += "|---:";
  t += "|\n" + rule + "|\n";
  const auto line = [&](const std::string& name, const Json& causes) {
    t += "| " + name + " ";
    for (const auto& [cause, n] : causes.items()) t += fmt::format("| {} ", n.get<int>());
    t += "|\n";
  };
  for (const auto& [name, part] : j["per_drive"].items()) line(name, part["causes"]);
  line("all", j["inside"]["causes"]);
  return t + "\n";
}

struct Goals {
  double first, each;  // least share of first tries, of all and of each drive; 0: not asked
};
constexpr Goals kGoals{0.995, 0.985}, kHardGoals{0.98, 0.98}, kMotorGoals{0.985, 0};

// What a start should be, and what it is.
std::string goals(const Json& j, const Goals& g) {
  std::string t = "## Goals\n\n| what | goal | measured | met |\n|---|---|---|---|\n";
  const auto row = [&](const std::string& what, const std::string& goal, const std::string& measured, bool met) {
    t += fmt::format("| {} | {} | {} | {} |\n", what, goal, measured, met ? "yes" : "no");
  };
  const auto below = [&](const char* what, const char* key, const char* part, double bound) {
    if (j[key][part].is_null()) return;
    const double x = j[key][part].get<double>();
    t += fmt::format("| {} | at most {:g} | {:.4g} | {} |\n", what, bound, x, x <= bound ? "yes" : "no");
  };
  const Json& inside = j["inside"];
  double least = 1;
  std::string worst;
  for (const auto& [name, part] : j["per_drive"].items()) {
    if (part["runs"] != 0 && first_share(part) <= least) least = first_share(part), worst = name;
  }
  const double lost_bound = inside["lost_at_most"].get<double>();
  row("started at the first try", "at least " + percent(g.first, 1), percent(first_share(inside)), first_share(inside) >= g.first);
  if (const int slow = inside["bus_gives_no_more"].get<int>(); slow > 0) {
    const double share = inside["first_try"].get<double>() / (inside["runs"].get<int>() - slow);
    row(fmt::format("the same, without {} in lock below a set speed that the bus does not give", slow), "at least " + percent(g.first, 1),
        percent(share), share >= g.first);
  }
  if (g.each > 0) row("the drive with the fewest", "at least " + percent(g.each, 1), percent(least) + ", " + worst, least >= g.each);
  row("lost", "none, 95 % bound below 0.03 %",
      fmt::format("{}, below {}", inside["runs"].get<int>() - inside["started"].get<int>(), fmt::format("{:.4g} %", 100 * lost_bound)),
      inside["runs"] == inside["started"] && lost_bound < 0.0003);
  below("peak current over the limit, highest", "peak_over_limit", "max", kPeakGoal);
  below("time to lock, s: median", "lock_time_s", "median", 0.2);
  below("time to lock, s: 99 %", "lock_time_s", "p99", 2);
  below("time to lock, s: longest", "lock_time_s", "max", kLockGoal);
  below("kick backwards, electrical degrees: 90 %", "kick_deg", "p90", 150);
  below("kick backwards, electrical degrees: 99 %", "kick_deg", "p99", kKickGoal);
  below("speed from rest over the set speed, highest", "peak_speed", "max", kSpeedGoal);
  return t + "\n";
}

std::string six_step_head(const SweepSetup& setup) {
  std::string t = page_head(setup, "Starts", "tools/starts", "drives/*.toml", "docs/starts.md",
                            "all_of_100_drawn_starts_succeed_and_rtl_agrees");
  t += "Each run draws a motor from its drive's [envelope](drive_file.md#envelope): rotor angle, load, inertia, bus, "
       "resistance, inductance, flux, comparators, and whether the rotor turns already, either way. The drive's words stay "
       "those of the file. *Started* is in lock by the rotor's true angle, without a slipped step, for 24 electrical turns, a fifth of "
       "the runs for 200 and a second at least, at the set speed; *rough* is that, but with more current, kick, speed or time than "
       "the drive's "
       "[bounds](drive_file.md#bounds); *silent* is a rotor out of step for half a second while the drive claims a lock "
       "([how it is judged](sweep.md#a-run)).\n\n";
  return t;
}

std::string hard_head(const SweepSetup& setup) {
  std::string t = page_head(setup, "Hard starts", "tools/starts --hard", "drives/*.toml --matrix hard", "docs/hard_starts.md",
                            "the_page_of_hard_starts_is_current");
  t += "Each run draws a motor from its drive's [envelope](drive_file.md#envelope) as [a start](starts.md) does, and one "
       "hardship more from its [hardship](drive_file.md#hardship): a weight about which the rotor swings, wind on a fan, a belt's "
       "spring, cogging, stiction, a load that holds until it breaks away, or comparators with twice the offsets, noise and "
       "delay ([the physics](sweep.md#hard-starts)). The drive's words stay those of the file. Outcomes are those of "
       "[starts](starts.md); what a rotor turns backwards by weight or wind is no kick.\n\n";
  return t;
}

std::string motors_head(const SweepSetup& setup) {
  std::string t = page_head(setup, "Starts of motors that no file knows", "tools/starts --motors", "out/motors/*.toml",
                            "docs/motor_starts.md", "the_page_of_motor_starts_is_current");
  t += fmt::format("`steplock motors --count 300 --seed {}` writes the motors into out/motors: 3 W to 3 kW, 3.7 to 96 V, 1 to 21 pole "
                   "pairs, each value drawn or following from what is ([how](sweep.md#motors-that-no-file-knows)). Of them the design "
                   "library accepts {}; the runs go through these in turn. Each run draws what its motor meets from the default "
                   "[envelope](drive_file.md#envelope), as a [start](starts.md) does. A motor of which every run started at the first "
                   "attempt is not named.\n\n",
                   setup.kind.seed, setup.drives.size());
  return t;
}

std::string hardships_table(const Json& j) {
  std::string t = "## By hardship\n\n| hardship | runs | started | first try | at least | after retries | rough | latched | silent | unfinished "
                  "| lost at most |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const auto& [name, part] : j["per_hardship"].items()) t += outcomes_line(name, part);
  t += "\n| hardship ";
  t += kSpreadsHead;
  for (const auto& [name, part] : j["per_hardship"].items()) t += spreads_line(name, part);
  return t + "\n";
}

std::string sinusoidal_head(const SweepSetup& setup) {
  std::string t = page_head(setup, "Starts of the sinusoidal drives", "tools/starts --sinusoidal", "drives/*.toml --kind sinusoidal",
                            "docs/sinusoidal_starts.md", "the_page_of_sinusoidal_starts_is_current");
  t += "Each run draws a motor from its drive's [envelope](drive_file.md#envelope): rotor angle, load, inertia, bus, "
       "resistance, inductance, flux, and the current ADCs' offsets and noise. The drive's words stay those of the file. "
       "*Started* is in lock by the rotor's true angle, the estimate never 90 electrical degrees from it, for 24 electrical "
       "turns, a fifth of the runs for 200 and a second at least, at the set speed; *rough* is that, but with more current, kick, "
       "speed or time than the drive's "
       "[bounds](drive_file.md#bounds); *silent* is an angle lost for half a second while the drive claims a lock "
       "([how it is judged](sweep.md#a-run)). Pattern starts turn the rotor to their angle first, by three places in the wanted direction: a kick of "
       "half a turn at most to the first, and swings. Each place is held until the swing of the heaviest rotor of the envelope has faded to a "
       "fifth ([start](sinusoidal.md#start)): that is nearly all of the time to lock. The goals are those of the six-step drives, whose start "
       "follows the rotor and waits for no swing.\n\n";
  return t;
}

}  // namespace

std::string start_page(const SweepSetup& setup, const std::vector<Row>& rows) {
  const Json j = sweep_json(setup, rows);
  const bool sinusoidal = setup.drive_kind == design::DriveKind::kSinusoidal;
  const bool hard = setup.kind.matrix == Matrix::kHard;
  std::string t = hard                     ? hard_head(setup)
                  : of_drawn_motors(setup) ? motors_head(setup)
                  : sinusoidal             ? sinusoidal_head(setup)
                                           : six_step_head(setup);
  t += fmt::format("{} runs; engine `fixed`, {} runs repeated on the RTL, {} of them differ on any clock.\n\n", rows.size(),
                   j["rtl_repeats"].get<int>(), j["rtl_differing"].get<int>());
  t += fmt::format("{} of the started ones were watched for 200 turns and a second.\n\n", j["inside"]["watched"].get<int>());
  t += "*At least* and *lost at most* are exact binomial bounds with 95 % confidence.\n\n"
       "| drive | runs | started | first try | at least | after retries | rough | latched | silent | unfinished | lost at most |\n"
       "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const auto& [name, part] : j["per_drive"].items()) t += outcomes_line(name, part);
  t += outcomes_line("all, inside the envelope", j["inside"]);
  if (const Json& o = j["outside_of_envelope"]; o["runs"] > 0) {
    t += fmt::format("\nOutside the envelope: {} runs, {} started, {} rough, {} latched, {} silent, {} unfinished.\n",
                     o["runs"].get<int>(), o["started"].get<int>(), o["rough"].get<int>(), o["latched"].get<int>(),
                     o["silent_step_outs"].get<int>(), o["unfinished"].get<int>());
  }
  t += "\nTimes from `run`, kicks backwards from rest in electrical degrees, peaks of any phase, also over the current limit (sinusoidal: of the speed "
       "control's regulator); the highest speed of a rotor that stood, over the set speed.\n\n"
       "| drive ";
  t += kSpreadsHead;
  for (const auto& [name, part] : j["per_drive"].items()) t += spreads_line(name, part);
  t += spreads_line("all, inside the envelope", j) + "\n";
  if (hard) t += hardships_table(j);
  t += goals(j, hard ? kHardGoals : of_drawn_motors(setup) ? kMotorGoals : kGoals);
  t += beyond_goals(setup, rows);
  t += causes_table(j);
  t += fmt::format("![Time to lock](figures/{0}_lock_time.svg)\n\n![Peak current](figures/{0}_peak_current.svg)\n",
                   page_stem(setup));
  const auto failed = failures(rows);
  if (failed.empty()) return t;
  t += "\n## Failed\n\n";
  if (sinusoidal) t += "Why, as far as it is known: [causes](sweep.md#why-sinusoidal-starts-are-lost).\n\n";
  t += "| replay | outcome | reason | envelope |\n|---|---|---|---|\n";
  for (const Row* r : failed) {
    t += fmt::format("| `steplock run {}/{}.toml --replay {}` | {} | {} | {} |\n",
                     of_drawn_motors(setup) ? "out/motors" : "drives", r->drive, r->seed,
                     name_of(r->findings.outcome), failure(*r), r->outside ? "outside" : "inside");
  }
  return t;
}

}  // namespace steplock
