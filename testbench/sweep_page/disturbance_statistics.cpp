#include "testbench/sweep_page/disturbance_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "testbench/sweep_page/statistics.hpp"

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

// Of the latched fault, or of the last failed attempt.
const char* reason_after(const Row& r) { return r.table().sinusoidal() ? start_reason(r) : name_of(r.after.reason); }

constexpr const char* kColors[kTroubles] = {"#1f5fa8", "#c0392b", "#1f7a4d", "#e08214", "#7d3c98",
                                            "#16a085", "#8d6e63", "#22313f", "#d81b60", "#6d8b00", "#5d4037"};

}  // namespace

std::string three(const Json& s, double scale, const char* format) {
  if (s["min"].is_null()) return "-";
  const auto one = [&](const char* key) { return fmt::format(fmt::runtime(format), scale * s[key].get<double>()); };
  return one("min") + " / " + one("median") + " / " + one("max");
}

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
  j["rtl_differences"] = Json::array();
  for (const Row* r : on_rtl) {
    if (r->rtl != "equal") j["rtl_differences"].push_back({{"drive", r->drive}, {"seed", r->seed}, {"first", r->rtl}});
  }
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
                             {"outcome", name_of(r.after.outcome)}, {"reason", reason_after(r)}});
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
  for (const Json& d : j["rtl_differences"]) {
    t += fmt::format("  {} {}: {}\n", d["drive"].get<std::string>(), d["seed"].get<std::uint64_t>(), d["first"].get<std::string>());
  }
  if (rows.size() != setup.runs) t += fmt::format("{} of {} runs are missing\n", setup.runs - rows.size(), setup.runs);
  for (const Json& f : j["failures"]) {
    t += fmt::format("  FAILED: {} --replay {}: {}, {} ({})\n", f["drive"].get<std::string>(),
                     f["seed"].get<std::uint64_t>(), f["kind"].get<std::string>(),
                     f["outcome"].get<std::string>(), f["reason"].get<std::string>());
  }
  return t;
}

std::vector<Figure> disturbance_figures(const SweepSetup& setup, const std::vector<Row>& rows) {
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
  const std::string stem = page_stem(setup);
  all.push_back(shares({.name = stem + "_recovery", .title = "Time to recover", .axis = "time, s",
                        .caption = "Share of the runs that were back in lock at set speed, for good, by then. A run "
                                   "that never left it stands at the left edge."},
                       false, [](const Row& r) { return r.after.recovery_s; }));
  all.push_back(shares({.name = stem + "_lost", .title = "Faults for good: time until the lock is given up",
                        .axis = "time, s", .caption = "Share of the runs whose gates had been switched off by then, for the "
                                                "first time; tries to start again follow, until the fault latches."},
                       true, [](const Row& r) { return r.after.lost_s; }));
  std::erase_if(all, [](const Figure& f) { return f.panels[0].curves.empty(); });
  return all;
}

}  // namespace steplock
