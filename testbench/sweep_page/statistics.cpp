#include "testbench/sweep_page/statistics.hpp"

#include "testbench/sweep_page/disturbance_statistics.hpp"
#include "testbench/sweep_page/share.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<const Row*>;

std::size_t count(const Rows& rows, Outcome o) {
  return static_cast<std::size_t>(
      std::ranges::count_if(rows, [&](const Row* r) { return r->findings.outcome == o; }));
}

Json outcomes(const Rows& rows) {
  return {{"runs", rows.size()},
          {"started", count(rows, Outcome::kStarted)},
          {"rough", count(rows, Outcome::kRough)},
          {"latched", count(rows, Outcome::kLatched)},
          {"silent_step_outs", count(rows, Outcome::kSilentStepOut)},
          {"unfinished", count(rows, Outcome::kUnfinished)},
          {"bus_gives_no_more", std::ranges::count(rows, "bus", [](const Row* r) { return r->findings.beyond; })}};
}

Json spread(std::vector<double> values) {
  if (values.empty()) return {{"min", nullptr}, {"median", nullptr}, {"p90", nullptr}, {"p99", nullptr}, {"max", nullptr}};
  std::ranges::sort(values);
  const std::size_t n = values.size();
  const double median = (values[(n - 1) / 2] + values[n / 2]) / 2;
  // The least value that so many per cent do not pass.
  const auto part = [&](std::size_t percent) { return values[(n * percent + 99) / 100 - 1]; };
  return {{"min", values.front()}, {"median", median}, {"p90", part(90)}, {"p99", part(99)}, {"max", values.back()}};
}

Json spread_of(const Rows& rows, const std::function<std::optional<double>(const Row&)>& value) {
  std::vector<double> values;
  for (const Row* r : rows) {
    if (const auto x = value(*r)) values.push_back(*x);
  }
  return spread(std::move(values));
}

// A rough start is one all the same, and its figures count.
std::optional<double> if_started(const Row& r, const std::optional<double>& x) {
  return has_started(r.findings.outcome) ? x : std::nullopt;
}

std::size_t first_try(const Rows& rows) {
  return static_cast<std::size_t>(std::ranges::count_if(
      rows, [](const Row* r) { return r->findings.outcome == Outcome::kStarted && r->findings.retries == 0; }));
}

// Of all failed tries.
Json causes(const Rows& rows) {
  Json j = Json::object();
  for (int k = 0; k < kCauses; ++k) {
    const std::string name = name_of(static_cast<Cause>(k));
    std::size_t n = 0;
    for (const Row* r : rows) {
      const std::string all = "+" + r->findings.causes + "+";
      for (std::size_t at = 0; (at = all.find("+" + name + "+", at)) != all.npos; ++at) ++n;
    }
    j[name] = n;
  }
  return j;
}

void add_starts(Json& j, const Rows& rows) {
  const std::size_t first = first_try(rows), lost = rows.size() - count(rows, Outcome::kStarted);
  j["started_after_retries"] = count(rows, Outcome::kStarted) - first;
  j["watched"] = std::ranges::count_if(rows, [](const Row* r) {
    return RunSeed{r->seed}.watched() && if_started(*r, 0).has_value();
  });
  j["first_try"] = first;
  j["first_try_at_least"] = share_at_least(first, rows.size());
  j["lost_at_most"] = share_at_most(lost, rows.size());
  j["causes"] = causes(rows);
}

void add_spreads(Json& j, const SweepSetup& setup, const Rows& rows) {
  j["lock_time_s"] = spread_of(rows, [](const Row& r) { return if_started(r, r.findings.lock_time_s); });
  j["speed_time_s"] = spread_of(rows, [](const Row& r) { return if_started(r, r.findings.speed_time_s); });
  j["peak_current_a"] =
      spread_of(rows, [](const Row& r) { return std::optional(r.findings.peak_current_a); });
  j["kick_deg"] = spread_of(rows, [](const Row& r) { return r.findings.kick_deg; });
  j["peak_speed"] = spread_of(rows, [](const Row& r) { return r.findings.peak_speed; });
  j["peak_over_limit"] = spread_of(rows, [&](const Row& r) { return peak_over_limit(setup, r); });
}

Rows select(const std::vector<Row>& rows, const std::function<bool(const Row&)>& wanted) {
  Rows some;
  for (const Row& r : rows) {
    if (wanted(r)) some.push_back(&r);
  }
  return some;
}

}  // namespace

std::vector<const Row*> failures(const std::vector<Row>& rows) {
  return select(rows, [](const Row& r) {
    const Findings& f = r.findings;
    if (r.matrix() == Matrix::kDisturb) return !disturbance_well(r);
    if (f.outcome == Outcome::kStarted) return false;
    // Outside, a lock that holds but cannot reach the set speed is no failure either.
    const bool holds = f.outcome == Outcome::kUnfinished && f.lock_time_s && f.slips == 0;
    return !(r.outside && (f.outcome == Outcome::kLatched || f.outcome == Outcome::kRough || holds));
  });
}

std::string failure(const Row& r) {
  if (r.findings.beyond == "bus") return "the bus gives no more";
  return r.findings.outcome == Outcome::kRough ? "beyond " + r.findings.beyond : start_reason(r);
}

std::string prefix_digest(const std::vector<Row>& rows, std::uint64_t count) {
  std::string text;
  for (const Row& r : rows) {
    if (r.index < count) text += csv_line(r) + "\n";
  }
  return digest(text);
}

const SweepDrive* drive_of(const SweepSetup& setup, const Row& r) {
  const auto d = std::ranges::find(setup.drives, r.drive, &SweepDrive::name);
  return d == setup.drives.end() ? nullptr : &*d;
}

std::optional<double> peak_over_limit(const SweepSetup& setup, const Row& r) {
  const SweepDrive* d = drive_of(setup, r);
  return d == nullptr || d->limit_a == 0 ? std::nullopt : std::optional(r.findings.peak_current_a / d->limit_a);
}

bool of_many(const SweepSetup& setup) {
  constexpr std::size_t kNamed = 20;
  return setup.drives.size() > kNamed;
}

bool of_drawn_motors(const SweepSetup& setup) {
  return of_many(setup) && std::ranges::all_of(setup.drives, [](const SweepDrive& d) { return d.name.starts_with("motor_"); });
}

bool passed(const SweepSetup& setup, const std::vector<Row>& rows) {
  const bool rtl = std::ranges::all_of(rows, [](const Row& r) { return r.rtl.empty() || r.rtl == "equal"; });
  return rows.size() == setup.runs && rtl && failures(rows).empty();
}

Json sweep_json(const SweepSetup& setup, const std::vector<Row>& rows) {
  if (setup.kind.matrix == Matrix::kDisturb) return disturbance_json(setup, rows, passed(setup, rows));
  const Rows all = select(rows, [](const Row&) { return true; });
  const Rows inside = select(rows, [](const Row& r) { return !r.outside; });
  const Rows outside = select(rows, [](const Row& r) { return r.outside; });
  const Rows on_rtl = select(rows, [](const Row& r) { return !r.rtl.empty(); });
  Json j = Json::parse(setup_text(setup));
  j.erase("runs");
  if (of_many(setup)) j["drives"] = setup.drives.size();
  j["planned"] = setup.runs;
  j.update(outcomes(all));
  j["outside_envelope"] = outside.size();
  j["passed"] = passed(setup, rows);
  j["inside"] = outcomes(inside);
  add_starts(j["inside"], inside);
  j["outside_of_envelope"] = outcomes(outside);
  add_spreads(j, setup, inside);
  j["rtl_repeats"] = on_rtl.size();
  j["rtl_differing"] = std::ranges::count_if(on_rtl, [](const Row* r) { return r->rtl != "equal"; });
  j["per_drive"] = Json::object();
  for (const SweepDrive& d : setup.drives) {
    const Rows mine = select(rows, [&](const Row& r) { return !r.outside && r.drive == d.name; });
    if (of_many(setup) && first_try(mine) == mine.size()) continue;
    Json& part = j["per_drive"][d.name] = outcomes(mine);
    add_starts(part, mine);
    add_spreads(part, setup, mine);
  }
  if (setup.kind.matrix == Matrix::kHard) {
    for (int k = 0; k < kTrials; ++k) {
      const auto kind = static_cast<Trial>(k);
      const Rows some = select(rows, [&](const Row& r) { return r.hardship.kind == kind; });
      Json& part = j["per_hardship"][name_of(kind)] = outcomes(some);
      add_starts(part, some);
      add_spreads(part, setup, some);
    }
  }
  j["failures"] = Json::array();
  for (const Row* r : failures(rows)) {
    j["failures"].push_back({{"drive", r->drive}, {"seed", r->seed}, {"outside", r->outside},
                             {"outcome", name_of(r->findings.outcome)},
                             {"reason", failure(*r)}});
  }
  return j;
}

std::string sweep_text(const SweepSetup& setup, const std::vector<Row>& rows) {
  if (setup.kind.matrix == Matrix::kDisturb) return disturbance_text(setup, rows, passed(setup, rows));
  const Json j = sweep_json(setup, rows);
  const auto cell = [](const Json& x) { return x.is_null() ? "-" : fmt::format("{:.4g}", x.get<double>()); };
  std::string t = fmt::format("{:<18}{:>7}{:>9}{:>9}{:>7}{:>9}{:>8}{:>11}{:>12}{:>12}{:>12}{:>12}\n", "inside", "runs",
                              "started", "retried", "rough", "latched", "silent", "unfinished", "lock med, s",
                              "lock max, s", "kick max,deg", "peak max, A");
  const auto line = [&](const std::string& name, const Json& p, const Json& spreads) {
    t += fmt::format("{:<18}{:>7}{:>9}{:>9}{:>7}{:>9}{:>8}{:>11}{:>12}{:>12}{:>12}{:>12}\n", name,
                     p["runs"].get<int>(), p["started"].get<int>(), p["started_after_retries"].get<int>(),
                     p["rough"].get<int>(), p["latched"].get<int>(), p["silent_step_outs"].get<int>(), p["unfinished"].get<int>(),
                     cell(spreads["lock_time_s"]["median"]), cell(spreads["lock_time_s"]["max"]),
                     cell(spreads["kick_deg"]["max"]), cell(spreads["peak_current_a"]["max"]));
  };
  for (const auto& [name, part] : j["per_drive"].items()) line(name, part, part);
  if (setup.drives.size() > 1) line("all", j["inside"], j);
  if (const Json& o = j["outside_of_envelope"]; o["runs"] > 0) {
    t += fmt::format("outside the envelope: {} runs, {} started, {} rough, {} latched, {} silent, {} unfinished\n",
                     o["runs"].get<int>(), o["started"].get<int>(), o["rough"].get<int>(), o["latched"].get<int>(),
                     o["silent_step_outs"].get<int>(), o["unfinished"].get<int>());
  }
  t += fmt::format("repeated on the RTL: {}, {} of them differ\n", j["rtl_repeats"].get<int>(),
                   j["rtl_differing"].get<int>());
  if (rows.size() != setup.runs) t += fmt::format("{} of {} runs are missing\n", setup.runs - rows.size(), setup.runs);
  constexpr std::size_t kMost = 12;
  const auto failed = failures(rows);
  for (std::size_t k = 0; k < std::min(kMost, failed.size()); ++k) {
    const Row& r = *failed[k];
    t += fmt::format("  FAILED: {} --replay {}: {} ({})\n", r.drive, r.seed, name_of(r.findings.outcome), failure(r));
  }
  if (failed.size() > kMost) t += fmt::format("  and {} more, in sweep.json\n", failed.size() - kMost);
  return t;
}

}  // namespace steplock
