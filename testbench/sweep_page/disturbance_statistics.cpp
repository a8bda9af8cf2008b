#include "testbench/sweep_page/disturbance_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "testbench/sweep_page/page_head.hpp"
#include "testbench/sweep_page/share.hpp"

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<const Row*>;
using Value = std::function<std::optional<double>(const Row&)>;

constexpr const char* kOutcomeKeys[kAfters] = {"recovered", "latched", "silent_step_outs", "unfinished",
                                               "not_started"};

Rows select(const std::vector<Row>& rows, const std::function<bool(const Row&)>& wanted) {
  Rows some;
  for (const Row& r : rows) {
    if (wanted(r)) some.push_back(&r);
  }
  return some;
}

double rounded(double x) { return std::stod(fmt::format("{:.4g}", x)); }

Json spread(const Rows& rows, const Value& value) {
  std::vector<double> v;
  for (const Row* r : rows) {
    if (const auto x = value(*r)) v.push_back(*x);
  }
  if (v.empty()) return {{"min", nullptr}, {"median", nullptr}, {"max", nullptr}};
  std::ranges::sort(v);
  const std::size_t n = v.size();
  return {{"min", rounded(v.front())},
          {"median", rounded((v[(n - 1) / 2] + v[n / 2]) / 2)},
          {"max", rounded(v.back())}};
}

std::optional<double> in_steps(const Row& r, const std::optional<double>& s) {
  return s ? std::optional(*s * r.disturbance.steps_per_s) : std::nullopt;
}

Json summary(const Rows& rows) {
  Json j{{"runs", rows.size()}, {"well", std::ranges::count_if(rows, [](auto* r) { return disturbance_well(*r); })}};
  for (int k = 0; k < kAfters; ++k) {
    j[kOutcomeKeys[k]] =
        std::ranges::count_if(rows, [&](auto* r) { return r->after.outcome == static_cast<After>(k); });
  }
  j["after_retries"] = std::ranges::count_if(
      rows, [](auto* r) { return r->after.outcome == After::kRecovered && r->after.retries > 0; });
  j["recovery_s"] = spread(rows, [](const Row& r) { return r.after.recovery_s; });
  j["recovery_steps"] = spread(rows, [](const Row& r) { return in_steps(r, r.after.recovery_s); });
  j["lock_given_up_s"] = spread(rows, [](const Row& r) { return r.after.fault_s ? r.after.lost_s : std::nullopt; });
  j["lock_given_up_steps"] = spread(
      rows, [](const Row& r) { return r.after.fault_s ? in_steps(r, r.after.lost_s) : std::nullopt; });
  j["fault_s"] = spread(rows, [](const Row& r) { return r.after.fault_s; });
  j["dip_percent"] = spread(rows, [](const Row& r) {
    return r.after.outcome == After::kRecovered ? std::optional(100 * r.after.dip) : std::nullopt;
  });
  j["peak_current_a"] = spread(rows, [](const Row& r) { return std::optional(r.after.peak_current_a); });
  return j;
}

std::string three(const Json& s, double scale, const char* format = "{:.3g}") {
  if (s["min"].is_null()) return "-";
  const auto one = [&](const char* key) { return fmt::format(fmt::runtime(format), scale * s[key].get<double>()); };
  return one("min") + " / " + one("median") + " / " + one("max");
}

constexpr const char* kColors[kTroubles] = {"#1f5fa8", "#c0392b", "#1f7a4d", "#e08214", "#7d3c98",
                                            "#16a085", "#8d6e63", "#22313f", "#d81b60", "#6d8b00", "#5d4037"};

}  // namespace

bool disturbance_well(const Row& r) { return ends_well(r.disturbance.kind, r.after.outcome); }

Json disturbance_json(const SweepSetup& setup, const std::vector<Row>& rows, bool passed) {
  const Rows all = select(rows, [](const Row&) { return true; });
  const Rows on_rtl = select(rows, [](const Row& r) { return !r.rtl.empty(); });
  Json j = Json::parse(setup_text(setup));
  j.erase("runs");
  j["planned"] = setup.runs;
  j.update(summary(all));
  j["passed"] = passed;
  j["rtl_repeats"] = on_rtl.size();
  j["rtl_differing"] = std::ranges::count_if(on_rtl, [](const Row* r) { return r->rtl != "equal"; });
  const auto per_kind = [&](const std::function<bool(const Row&)>& wanted) {
    Json kinds = Json::object();
    for (int k = 0; k < kTroubles; ++k) {
      const auto kind = static_cast<Trouble>(k);
      const Rows some = select(rows, [&](const Row& r) { return r.disturbance.kind == kind && wanted(r); });
      if (some.empty()) continue;
      kinds[name_of(kind)] = summary(some);
      if (kind == Trouble::kDemagnetisation) {
        kinds[name_of(kind)]["measured_deg"] =
            spread(some, [](const Row& r) { return std::optional(r.after.demagnetisation_deg); });
      }
    }
    return kinds;
  };
  j["per_kind"] = per_kind([](const Row&) { return true; });
  j["per_drive"] = Json::object();
  for (const SweepDrive& d : setup.drives) {
    const auto mine = [&](const Row& r) { return r.drive == d.name; };
    j["per_drive"][d.name] = summary(select(rows, mine));
    j["per_drive"][d.name]["per_kind"] = per_kind(mine);
  }
  j["failures"] = Json::array();
  for (const Row& r : rows) {
    if (disturbance_well(r)) continue;
    j["failures"].push_back({{"drive", r.drive}, {"seed", r.seed}, {"kind", name_of(r.disturbance.kind)},
                             {"outcome", name_of(r.after.outcome)}, {"reason", name_of(r.after.reason)}});
  }
  return j;
}

std::string disturbance_text(const SweepSetup& setup, const std::vector<Row>& rows, bool passed) {
  const Json j = disturbance_json(setup, rows, passed);
  std::string t = fmt::format("{:<18}{:>6}{:>6}{:>7}{:>8}{:>8}{:>7}{:>11}{:>10}   {:<26}{}\n", "disturbance", "runs", "well",
                              "recov.", "retried", "latched", "silent", "unfinished", "no start",
                              "recovery, ms", "fault, s");
  const auto line = [&](const std::string& name, const Json& p) {
    t += fmt::format("{:<18}{:>6}{:>6}{:>7}{:>8}{:>8}{:>7}{:>11}{:>10}   {:<26}{}\n", name, p["runs"].get<int>(),
                     p["well"].get<int>(), p["recovered"].get<int>(), p["after_retries"].get<int>(),
                     p["latched"].get<int>(), p["silent_step_outs"].get<int>(), p["unfinished"].get<int>(),
                     p["not_started"].get<int>(), three(p["recovery_s"], 1e3), three(p["fault_s"], 1));
  };
  for (const auto& [name, part] : j["per_kind"].items()) line(name, part);
  for (const auto& [name, part] : j["per_drive"].items()) line(name, part);
  line("all", j);
  t += fmt::format("repeated on the RTL: {}, {} of them differ\n", j["rtl_repeats"].get<int>(),
                   j["rtl_differing"].get<int>());
  if (rows.size() != setup.runs) t += fmt::format("{} of {} runs are missing\n", setup.runs - rows.size(), setup.runs);
  for (const Json& f : j["failures"]) {
    t += fmt::format("  FAILED: {} --replay {}: {}, {} ({})\n", f["drive"].get<std::string>(),
                     f["seed"].get<std::uint64_t>(), f["kind"].get<std::string>(),
                     f["outcome"].get<std::string>(), f["reason"].get<std::string>());
  }
  return t;
}

std::vector<Figure> disturbance_figures(const SweepSetup&, const std::vector<Row>& rows) {
  constexpr double kLeast = 1e-4;  // s; stands for 0 on the logarithmic axis
  const auto shares = [&](Figure f, bool good, const Value& value) {
    Panel panel{.label = "runs, %", .weight = 2.4, .extra = "set yrange [0:100]\n"};
    for (int k = 0; k < kTroubles; ++k) {
      const auto kind = static_cast<Trouble>(k);
      if (for_good(kind) != good) continue;
      std::vector<double> v;
      std::size_t all = 0;
      for (const Row& r : rows) {
        if (r.disturbance.kind != kind) continue;
        ++all;
        if (const auto x = value(r)) v.push_back(std::max(*x, kLeast));
      }
      std::ranges::sort(v);
      Curve curve{name_of(kind), kColors[k], {}, 1.6};
      curve.steps = true;
      for (std::size_t i = 0; i < v.size(); ++i) {
        curve.points.push_back({v[i], 100.0 * static_cast<double>(i + 1) / static_cast<double>(all)});
      }
      if (!curve.points.empty()) panel.curves.push_back(std::move(curve));
    }
    f.logarithmic = true;
    f.panels = {std::move(panel)};
    return f;
  };
  std::vector<Figure> all;
  all.push_back(shares({.name = "disturbances_recovery", .title = "Time to recover", .axis = "time, s",
                        .caption = "Share of the runs that were back in lock at set speed, for good, by then. A run "
                                   "that never left it stands at the left edge."},
                       false, [](const Row& r) { return r.after.recovery_s; }));
  all.push_back(shares({.name = "disturbances_lost", .title = "Faults for good: time until the lock is given up",
                        .axis = "time, s", .caption = "Share of the runs whose gates had been switched off by then, for the "
                                                "first time; tries to start again follow, until the fault latches."},
                       true, [](const Row& r) { return r.after.lost_s; }));
  std::erase_if(all, [](const Figure& f) { return f.panels[0].curves.empty(); });
  return all;
}

std::string disturbance_page(const SweepSetup& setup, const std::vector<Row>& rows, bool passed) {
  const Json j = disturbance_json(setup, rows, passed);
  std::string t = page_head(setup, "Disturbances", "tools/starts --disturb", "drives/*.toml --matrix disturb",
                            "docs/disturbances.md", "the_page_of_disturbances_is_current");
  t += "Each run draws a motor from the milder half of its drive's [envelope](drive_file.md#envelope), starts it, settles "
       "at a drawn speed, and meets one disturbance of drawn size at a drawn instant; sizes are bounded by "
       "[disturbance](drive_file.md#disturbance). What passes must be recovered from: in lock by the rotor's true angle, "
       "within 3 % of the set speed, for 24 electrical turns. What is for good must end in the latched fault. A *silent* "
       "step-out is a rotor out of step for half a second while the drive claims a lock.\n\n";
  const std::size_t well = j["well"];
  t += fmt::format("{} runs, {} as they must, {} silent; engine `fixed`, {} runs repeated on the RTL, {} of them differ. With 95 % "
                   "confidence at most {:.3f} % of such runs do not end as they must (exact binomial bound).\n\n",
                   rows.size(), well, j["silent_step_outs"].get<int>(), j["rtl_repeats"].get<int>(),
                   j["rtl_differing"].get<int>(), 100 * share_at_most(rows.size() - well, rows.size()));
  const auto what = [](const std::string& name) -> const char* {
    constexpr const char* kWhat[kTroubles] = {
        "load rises, stays", "load rises and is released after 2 to 100 electrical turns",
        "set speed steps, slewed as the words say", "the source's voltage falls for 1 to 200 ms",
        "one comparator keeps its level for some steps", "one comparator keeps a level for good",
        "the floating phase's comparator shows no crossing for one step",
        "the floating phase's comparator is inverted for a part of a step",
        "one winding loses its contact for good",
        "load rises, on a winding whose commutated current flows on for long",
        "a mass that turns along is coupled for good, up to four times the inertia, and the set speed steps"};
    for (int k = 0; k < kTroubles; ++k) {
      if (name == name_of(static_cast<Trouble>(k))) return kWhat[k];
    }
    return "";
  };
  t += "| disturbance | | runs | recovered | after retries | latched | silent | unfinished | no start | recovery, ms: min / "
       "median / max | in steps | deepest dip, % |\n|---|---|---:|---:|---:|---:|---:|---:|---:|---|---|---:|\n";
  for (const auto& [name, p] : j["per_kind"].items()) {
    t += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", name, what(name), p["runs"].get<int>(),
                     p["recovered"].get<int>(), p["after_retries"].get<int>(), p["latched"].get<int>(),
                     p["silent_step_outs"].get<int>(), p["unfinished"].get<int>(), p["not_started"].get<int>(),
                     three(p["recovery_s"], 1e3), three(p["recovery_steps"], 1, "{:.0f}"),
                     p["dip_percent"]["max"].is_null() ? "-" : fmt::format("{:.1f}", p["dip_percent"]["max"].get<double>()));
  }
  t += "\n![Time to recover](figures/disturbances_recovery.svg)\n\n## Faults for good\n\n"
       "The first loss of the lock switches all gates off. The drive then tries to start again, as often as its words say "
       "(each try has its time limit), and latches.\n\n"
       "| fault | drive | runs | latched | lock given up, ms: min / median / max | in steps | latched after, s |\n"
       "|---|---|---:|---:|---|---|---|\n";
  for (const Trouble kind : {Trouble::kStuckForGood, Trouble::kOpenPhase}) {
    for (const auto& [drive, part] : j["per_drive"].items()) {
      if (!part["per_kind"].contains(name_of(kind))) continue;
      const Json& p = part["per_kind"][name_of(kind)];
      t += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", name_of(kind), drive, p["runs"].get<int>(), p["latched"].get<int>(),
                       three(p["lock_given_up_s"], 1e3), three(p["lock_given_up_steps"], 1, "{:.0f}"), three(p["fault_s"], 1));
    }
  }
  t += "\n![Time until the lock is given up](figures/disturbances_lost.svg)\n\n## Demagnetisation\n\n"
       "The longest that the commutated current flowed on, by the plant's own current. The crossing stands 30 degrees "
       "into the step: beyond, it is hidden, and only the commutation's lead that follows from a hidden crossing keeps "
       "it in sight.\n\n| drive | runs | recovered | measured, electrical degrees: min / median / max | recovery, ms |\n"
       "|---|---:|---:|---|---|\n";
  for (const auto& [drive, part] : j["per_drive"].items()) {
    const char* name = name_of(Trouble::kDemagnetisation);
    if (!part["per_kind"].contains(name)) continue;
    const Json& p = part["per_kind"][name];
    t += fmt::format("| {} | {} | {} | {} | {} |\n", drive, p["runs"].get<int>(), p["recovered"].get<int>(),
                     three(p["measured_deg"], 1, "{:.1f}"), three(p["recovery_s"], 1e3));
  }
  t += "\n## Per drive\n\n| drive | runs | as they must | silent | recovery, ms: min / median / max | peak, A |\n"
       "|---|---:|---:|---:|---|---:|\n";
  for (const auto& [drive, p] : j["per_drive"].items()) {
    t += fmt::format("| [{0}](../drives/{0}.toml) | {1} | {2} | {3} | {4} | {5:.1f} |\n", drive, p["runs"].get<int>(),
                     p["well"].get<int>(), p["silent_step_outs"].get<int>(), three(p["recovery_s"], 1e3),
                     p["peak_current_a"]["max"].is_null() ? 0 : p["peak_current_a"]["max"].get<double>());
  }
  if (!j["failures"].empty()) t += "\n## Runs that did not end as they must\n\n| replay | kind | outcome | reason |\n|---|---|---|---|\n";
  for (const Json& f : j["failures"]) {
    t += fmt::format("| `steplock run drives/{}.toml --replay {} --trace` | {} | {} | {} |\n", f["drive"].get<std::string>(),
                     f["seed"].get<std::uint64_t>(), f["kind"].get<std::string>(), f["outcome"].get<std::string>(),
                     f["reason"].get<std::string>());
  }
  return t;
}

}  // namespace steplock
