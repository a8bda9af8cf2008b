#include <fmt/format.h>

#include <algorithm>

#include "testbench/sweep_page/disturbance_statistics.hpp"
#include "testbench/sweep_page/page_head.hpp"
#include "testbench/sweep_page/share.hpp"
#include "testbench/sweep_page/statistics.hpp"

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kWhat[kTroubles] = {
    "load rises, stays", "load rises and is released after 2 to 100 electrical turns",
    "set speed steps, slewed as the words say", "the source's voltage falls for 1 to 200 ms",
    "one comparator keeps its level for some steps", "one comparator keeps a level for good",
    "the floating phase's comparator shows no crossing for one step",
    "the floating phase's comparator is inverted for a part of a step",
    "one winding loses its contact for good",
    "load rises, on a winding whose commutated current flows on for long",
    "a mass that turns along is coupled for good, up to four times the inertia, and the set speed steps"};

const char* what(const std::string& name) {
  for (int k = 0; k < kTroubles; ++k) {
    if (name == name_of(static_cast<Trouble>(k))) return kWhat[k];
  }
  return "";
}

std::string head(const SweepSetup& setup, const Json& j, std::size_t runs) {
  std::string t = setup.drive_kind == design::DriveKind::kSinusoidal
      ? page_head(setup, "Disturbances of the sinusoidal drives", "tools/starts --sinusoidal --disturb",
                  "drives/*.toml --kind sinusoidal --matrix disturb", "docs/sinusoidal_disturbances.md",
                  "the_page_of_sinusoidal_disturbances_is_current")
      : page_head(setup, "Disturbances", "tools/starts --disturb", "drives/*.toml --matrix disturb", "docs/disturbances.md",
                  "the_page_of_disturbances_is_current");
  t += "Each run draws a motor from the milder half of its drive's [envelope](drive_file.md#envelope), starts it, settles "
       "at a drawn speed, and meets one disturbance of drawn size at a drawn instant; sizes are bounded by "
       "[disturbance](drive_file.md#disturbance). What passes must be recovered from: in lock by the rotor's true angle, "
       "within 3 % of the set speed, for 24 electrical turns. What is for good must end in the latched fault. A *silent* "
       "step-out is a rotor out of step for half a second while the drive claims a lock.\n\n";
  const std::size_t well = j["well"];
  t += fmt::format("{} runs, {} as they must, {} silent; engine `fixed`, {} runs repeated on the RTL, {} of them differ. With 95 % "
                   "confidence at most {:.3f} % of such runs do not end as they must (exact binomial bound).\n\n",
                   runs, well, j["silent_step_outs"].get<int>(), j["rtl_repeats"].get<int>(),
                   j["rtl_differing"].get<int>(), 100 * share_at_most(runs - well, runs));
  for (const Json& d : j["rtl_differences"]) {
    t += fmt::format("- {} with seed {} first differs on the RTL in {}.\n", d["drive"].get<std::string>(), d["seed"].get<std::uint64_t>(),
                     d["first"].get<std::string>());
  }
  if (!j["rtl_differences"].empty()) t += "\n";
  return t;
}

std::string kinds_table(const Json& j, bool sinusoidal) {
  // A sinusoidal drive does not commutate in steps.
  const char* const steps_head = sinusoidal ? "" : " in steps |";
  std::string t = fmt::format("| disturbance | | runs | recovered | after retries | latched | silent | unfinished | no start | recovery, ms: "
                              "min / median / max |{} deepest dip, % |\n|---|---|---:|---:|---:|---:|---:|---:|---:|---|{}---:|\n",
                              steps_head, sinusoidal ? "" : "---|");
  for (const auto& [name, p] : j["per_kind"].items()) {
    const std::string steps = sinusoidal ? "" : " " + three(p["recovery_steps"], 1, "{:.0f}") + " |";
    t += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |{} {} |\n", name, what(name), p["runs"].get<int>(),
                     p["recovered"].get<int>(), p["after_retries"].get<int>(), p["latched"].get<int>(),
                     p["silent_step_outs"].get<int>(), p["unfinished"].get<int>(), p["not_started"].get<int>(),
                     three(p["recovery_s"], 1e3), steps,
                     p["dip_percent"]["max"].is_null() ? "-" : fmt::format("{:.1f}", p["dip_percent"]["max"].get<double>()));
  }
  return t;
}

std::string faults_for_good(const Json& j, bool sinusoidal) {
  std::string t = "\n## Faults for good\n\n"
                  "The first loss of the lock switches all gates off. The drive then tries to start again, as often as its words say "
                  "(each try has its time limit), and latches.\n\n";
  if (sinusoidal) {
    t += "These drives have no test for an open winding. The two others give no torque twice per electrical turn; where that is enough to stay in step and at "
         "speed, the drive goes on: *recovered*, and counted as not as it must.\n\n";
  }
  t += fmt::format("| fault | drive | runs | latched | lock given up, ms: min / median / max |{} latched after, s |\n"
                   "|---|---|---:|---:|---|{}---|\n", sinusoidal ? "" : " in steps |", sinusoidal ? "" : "---|");
  for (const Trouble kind : {Trouble::kStuckForGood, Trouble::kOpenPhase}) {
    for (const auto& [drive, part] : j["per_drive"].items()) {
      if (!part["per_kind"].contains(name_of(kind))) continue;
      const Json& p = part["per_kind"][name_of(kind)];
      const std::string steps = sinusoidal ? "" : " " + three(p["lock_given_up_steps"], 1, "{:.0f}") + " |";
      t += fmt::format("| {} | {} | {} | {} | {} |{} {} |\n", name_of(kind), drive, p["runs"].get<int>(), p["latched"].get<int>(),
                       three(p["lock_given_up_s"], 1e3), steps, three(p["fault_s"], 1));
    }
  }
  return t;
}

std::string demagnetisation(const Json& j) {
  const char* const name = name_of(Trouble::kDemagnetisation);
  if (!j["per_kind"].contains(name)) return "";
  std::string t =
      "\n## Demagnetisation\n\n"
      "The longest that the commutated current flowed on, by the plant's own current. The crossing stands 30 degrees "
      "into the step: beyond, it is hidden, and only the commutation's lead that follows from a hidden crossing keeps "
      "it in sight.\n\n| drive | runs | recovered | measured, electrical degrees: min / median / max | recovery, ms |\n"
      "|---|---:|---:|---|---|\n";
  for (const auto& [drive, part] : j["per_drive"].items()) {
    if (!part["per_kind"].contains(name)) continue;
    const Json& p = part["per_kind"][name];
    t += fmt::format("| {} | {} | {} | {} | {} |\n", drive, p["runs"].get<int>(), p["recovered"].get<int>(),
                     three(p["measured_deg"], 1, "{:.1f}"), three(p["recovery_s"], 1e3));
  }
  return t;
}

std::string per_drive(const Json& j) {
  std::string t = "\n## Per drive\n\n| drive | runs | as they must | silent | recovery, ms: min / median / max | peak, A |\n"
                  "|---|---:|---:|---:|---|---:|\n";
  for (const auto& [drive, p] : j["per_drive"].items()) {
    t += fmt::format("| [{0}](../drives/{0}.toml) | {1} | {2} | {3} | {4} | {5:.1f} |\n", drive, p["runs"].get<int>(),
                     p["well"].get<int>(), p["silent_step_outs"].get<int>(), three(p["recovery_s"], 1e3),
                     p["peak_current_a"]["max"].is_null() ? 0 : p["peak_current_a"]["max"].get<double>());
  }
  return t;
}

std::string failed(const Json& failures, bool sinusoidal) {
  if (failures.empty()) return "";
  std::string t = "\n## Runs that did not end as they must\n\n| replay | kind | outcome | reason |\n|---|---|---|---|\n";
  int goes_on = 0;  // of a sinusoidal drive: said above, and too many to name
  for (const Json& f : failures) {
    if (sinusoidal && f["kind"] == name_of(Trouble::kOpenPhase) && f["outcome"] != name_of(After::kSilentStepOut)) {
      ++goes_on;
      continue;
    }
    t += fmt::format("| `steplock run drives/{}.toml --replay {} --trace` | {} | {} | {} |\n", f["drive"].get<std::string>(),
                     f["seed"].get<std::uint64_t>(), f["kind"].get<std::string>(), f["outcome"].get<std::string>(),
                     f["reason"].get<std::string>());
  }
  if (goes_on > 0) t += fmt::format("\nAnd {} that went on with an open phase.\n", goes_on);
  return t;
}

}  // namespace

std::string disturbance_page(const SweepSetup& setup, const std::vector<Row>& rows, bool passed) {
  const Json j = disturbance_json(setup, rows, passed);
  const bool sinusoidal = setup.drive_kind == design::DriveKind::kSinusoidal;
  const auto figure = [stem = page_stem(setup)](const char* title, const char* name) {
    return fmt::format("\n![{}](figures/{}_{}.svg)\n", title, stem, name);
  };
  return head(setup, j, rows.size()) + kinds_table(j, sinusoidal) + figure("Time to recover", "recovery") +
         faults_for_good(j, sinusoidal) + figure("Time until the lock is given up", "lost") + demagnetisation(j) + per_drive(j) +
         failed(j["failures"], sinusoidal);
}

}  // namespace steplock
