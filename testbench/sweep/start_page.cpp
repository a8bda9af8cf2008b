// docs/starts.md and docs/sinusoidal_starts.md: the statistics of drawn starts.
#include <fmt/format.h>

#include "testbench/sweep/statistics.hpp"

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;

std::string three(const Json& s) {
  if (s["min"].is_null()) return "-";
  return fmt::format("{:.3g} / {:.3g} / {:.3g}", s["min"].get<double>(), s["median"].get<double>(),
                     s["max"].get<double>());
}

std::string line(const std::string& name, const Json& part, const Json& spreads) {
  std::string t = "| " + name;
  for (const char* key : {"runs", "started", "started_after_retries", "latched", "silent_step_outs", "unfinished"}) {
    t += fmt::format(" | {}", part[key].get<int>());
  }
  for (const char* key : {"lock_time_s", "speed_time_s", "kick_deg", "peak_current_a"}) {
    t += " | " + three(spreads[key]);
  }
  return t + " |\n";
}

std::string six_step_head(const SweepSetup& setup, const std::string& outside) {
  std::string t = fmt::format(
      "# Starts\n\nPrinted by `steplock sweep drives/*.toml --runs {} --seed {}{} --page docs/starts.md`; the test "
      "`all_of_300_drawn_starts_succeed_and_rtl_agrees` repeats its first runs and fails when they are not the page's.\n\n",
      setup.runs, setup.kind.seed, outside);
  t += "Each run draws a motor from its drive's [envelope](drive_file.md#envelope): rotor angle, load, inertia, bus, "
       "resistance, inductance, flux, comparators, and whether the rotor turns already, either way. The drive's words stay "
       "those of the file. *Started* is in lock by the rotor's true angle, without a slipped step, for 24 electrical turns, "
       "at the set speed; *silent* is a rotor out of step for half a second while the drive claims a lock "
       "([how it is judged](sweep.md#a-run)).\n\n";
  return t;
}

std::string sinusoidal_head(const SweepSetup& setup, const std::string& outside) {
  std::string t = fmt::format(
      "# Starts of the sinusoidal drives\n\nPrinted by `steplock sweep drives/*.toml --kind sinusoidal --runs {} --seed {}{} "
      "--page docs/sinusoidal_starts.md`; the test `the_page_of_sinusoidal_starts_is_current` repeats its first runs and fails "
      "when they are not the page's.\n\n",
      setup.runs, setup.kind.seed, outside);
  t += "Each run draws a motor from its drive's [envelope](drive_file.md#envelope): rotor angle, load, inertia, bus, "
       "resistance, inductance, flux, and the current converters' offsets and noise. The drive's words stay those of the file. "
       "*Started* is in lock by the rotor's true angle, the estimate never 90 electrical degrees from it, for 24 electrical "
       "turns, at the set speed; *silent* is an angle lost for half a second while the drive claims a lock "
       "([how it is judged](sweep.md#a-run)). Pattern starts turn the rotor to their angle first: a kick of half a turn and "
       "its swing. More than that is a try that ran backward and failed.\n\n";
  return t;
}

}  // namespace

std::string start_page(const SweepSetup& setup, const std::vector<Row>& rows) {
  const Json j = sweep_json(setup, rows);
  const std::string outside = setup.kind.outside > 0 ? fmt::format(" --outside {:g}", setup.kind.outside) : "";
  const bool sinusoidal = setup.drive_kind == design::DriveKind::kSinusoidal;
  std::string t = sinusoidal ? sinusoidal_head(setup, outside) : six_step_head(setup, outside);
  t += fmt::format("{} runs; engine `fixed`, {} runs repeated on the RTL, {} of them differ on any clock.\n\n", rows.size(),
                   j["rtl_repeats"].get<int>(), j["rtl_differing"].get<int>());
  t += "Times from `run`, kicks backwards from rest in electrical degrees, peaks of any phase; each as min / median / max.\n\n"
       "| drive | runs | started | after retries | latched | silent | unfinished | lock, s | set speed, s | kick, deg | peak, A |\n"
       "|---|---:|---:|---:|---:|---:|---:|---|---|---|---|\n";
  for (const auto& [name, part] : j["per_drive"].items()) t += line(name, part, part);
  t += line("all, inside the envelope", j["inside"], j);
  if (const Json& o = j["outside_of_envelope"]; o["runs"] > 0) {
    t += fmt::format("\nOutside the envelope: {} runs, {} started, {} latched, {} silent, {} unfinished.\n", o["runs"].get<int>(),
                     o["started"].get<int>(), o["latched"].get<int>(), o["silent_step_outs"].get<int>(),
                     o["unfinished"].get<int>());
  }
  t += fmt::format("\n![Time to lock](figures/{0}_lock_time.svg)\n\n![Peak current](figures/{0}_peak_current.svg)\n",
                   sinusoidal ? "sinusoidal_starts" : "starts");
  const auto failed = failures(rows);
  if (failed.empty()) return t;
  t += "\n## Failed\n\n";
  if (sinusoidal) t += "Why, as far as it is known: [causes](sweep.md#why-sinusoidal-starts-are-lost).\n\n";
  t += "| replay | outcome | reason | envelope |\n|---|---|---|---|\n";
  for (const Row* r : failed) {
    t += fmt::format("| `steplock run drives/{}.toml --replay {}` | {} | {} | {} |\n", r->drive, r->seed,
                     name_of(r->findings.outcome), start_reason(*r), r->outside ? "outside" : "inside");
  }
  return t;
}

}  // namespace steplock
