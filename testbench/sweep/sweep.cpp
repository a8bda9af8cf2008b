#include "testbench/sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "testbench/report/report.hpp"
#include "testbench/sweep/drawn_run.hpp"
#include "testbench/sweep/workers.hpp"

namespace steplock {
namespace {

namespace fs = std::filesystem;

std::string text_of(const SweepSetup& setup, const std::vector<Row>& rows) {
  std::string text = csv_header({setup.kind.matrix, setup.drive_kind}) + "\n";
  for (const Row& row : rows) text += csv_line(row) + "\n";
  return text;
}

// A file is replaced as a whole or not at all.
void replace_file(const fs::path& path, const std::string& text) {
  fs::path part = path;
  part += ".part";
  write_file(part, text);
  fs::rename(part, path);
}

void sort_rows(std::vector<Row>& rows) { std::ranges::sort(rows, {}, &Row::index); }

// The rows that an earlier call left, all of this sweep.
std::vector<Row> resumed_rows(const SweepSetup& setup, const fs::path& folder, bool resume) {
  const fs::path csv = folder / "runs.csv";
  if (!fs::exists(csv)) return {};
  if (!resume) {
    throw BadInput(fmt::format("{}:1: there are runs in this folder; go on with --resume, or name "
                               "another one with --out", csv.string()));
  }
  const std::string path = (folder / "setup.json").string();
  check_same_sweep(setup, read_setup(path), path);
  std::vector<Row> rows = read_rows(csv.string());
  sort_rows(rows);
  if (!rows.empty() && rows.back().index >= setup.runs) {
    throw BadInput(fmt::format("{}:1: it has run {}; go on with --runs {} or more, or name another folder with --out",
                               csv.string(), rows.back().index, rows.back().index + 1));
  }
  return rows;
}

}  // namespace

std::optional<Row> make_row(std::uint64_t index, const std::string& drive, const design::Settings& s,
                            RunSeed seed, const std::function<bool()>& go_on) {
  const DrawnRun run = drawn_run(s, seed);
  const DrawnResult result = simulate(run, {.go_on = go_on});
  if (result.stopped) return std::nullopt;
  Row row{.index = index, .drive = drive, .seed = seed.value, .outside = seed.outside(), .rtl = "",
          .conditions = run.conditions, .findings = result.findings, .disturbance = run.disturbance,
          .hardship = run.hardship, .after = result.after, .kind = s.drive.kind};
  if (!seed.on_rtl()) return row;
  const DrawnResult again = simulate(run, {.rtl_beside = true, .go_on = go_on});
  if (again.stopped) return std::nullopt;
  Row other = row;
  other.findings = again.findings;
  other.after = again.after;
  row.rtl = !again.rtl_agrees                  ? again.rtl_difference
            : csv_line(other) != csv_line(row) ? "another outcome"
                                               : "equal";
  return row;
}

SweepEnd sweep(const SweepSetup& setup, const std::vector<DriveFile>& files,
               const SweepOptions& options, const fs::path& folder) {
  SweepEnd end;
  end.rows = resumed_rows(setup, folder, options.resume);
  fs::create_directories(folder);
  replace_file(folder / "setup.json", setup_text(setup));
  // A line that a stopped machine left half written must not be continued.
  replace_file(folder / "runs.csv", text_of(setup, end.rows));

  std::set<std::uint64_t> have;
  for (const Row& row : end.rows) have.insert(row.index);
  const std::vector<std::size_t> drives = drives_of_runs(setup);
  std::vector<std::uint64_t> missing;
  for (std::uint64_t k = 0; k < setup.runs; ++k) {
    if (options.shard.has(run_seed(setup.kind, k)) && !have.contains(k)) missing.push_back(k);
  }

  const std::string csv = (folder / "runs.csv").string();
  std::ofstream out(csv, std::ios::binary | std::ios::app);
  Tasks tasks{.count = missing.size(), .jobs = options.jobs, .work = {}, .take = {}, .go_on = {}};
  tasks.work = [&](std::uint64_t task, const std::function<bool()>& go_on) -> std::optional<std::string> {
    const std::uint64_t k = missing[task];
    const std::size_t d = drives[k];
    const auto row = make_row(k, setup.drives[d].name, files[d].settings, run_seed(setup.kind, k), go_on);
    if (!row) return std::nullopt;
    return csv_line(*row);
  };
  tasks.take = [&](const std::string& line) {
    if (!(out << line + '\n' << std::flush)) throw std::runtime_error(csv + ": cannot write this file");
    end.rows.push_back(parse_csv_line({setup.kind.matrix, setup.drive_kind}, line, csv, static_cast<int>(end.rows.size()) + 2));
    ++end.done;
  };
  tasks.go_on = [&] {
    end.interrupted = end.interrupted || (options.progress && !options.progress(end.done, missing.size()));
    return !end.interrupted;
  };
  do_in_processes(tasks);
  out.close();
  sort_rows(end.rows);
  replace_file(csv, text_of(setup, end.rows));
  return end;
}

SweepEnd merge_sweeps(const std::vector<fs::path>& parts, const fs::path& folder, SweepSetup& setup) {
  SweepEnd end;
  std::map<std::uint64_t, Row> rows;
  bool first = true;
  for (const fs::path& part : parts) {
    const std::string path = (part / "setup.json").string();
    const SweepSetup other = read_setup(path);
    if (first) setup = other;
    first = false;
    check_same_sweep(setup, other, path);
    setup.runs = std::max(setup.runs, other.runs);
    const std::string csv = (part / "runs.csv").string();
    for (const Row& row : read_rows(csv)) {
      const auto [at, fresh] = rows.emplace(row.index, row);
      if (!fresh && csv_line(at->second) != csv_line(row)) {
        throw BadInput(fmt::format("{}:1: run {} ended otherwise than in another folder; they come from "
                                   "different versions, do one of them again", csv, row.index));
      }
    }
  }
  for (const auto& [index, row] : rows) end.rows.push_back(row);
  fs::create_directories(folder);
  replace_file(folder / "setup.json", setup_text(setup));
  replace_file(folder / "runs.csv", text_of(setup, end.rows));
  return end;
}

}  // namespace steplock
