#include "testbench/disturb/disturbance_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "testbench/disturb/sinusoidal_disturbance.hpp"
#include "testbench/report/report.hpp"
#include "testbench/sweep/workers.hpp"

namespace steplock::sinusoidal {
namespace {

namespace fs = std::filesystem;

const Table kTable{Matrix::kDisturb, design::DriveKind::kSinusoidal};

std::string header() { return csv_header(kTable) + ",drive_reason"; }

std::vector<Row> rows_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::vector<Row> rows;
  std::string text;
  // A line that a stopped machine left half written ends with the file.
  for (int line = 1; std::getline(in, text) && !in.eof(); ++line) {
    if (line > 1) {
      rows.push_back(disturbed_row_of(text, path, line));
    } else if (text != header()) {
      throw BadInput(fmt::format("{}:1: these are not the columns of this version; begin anew in another folder", path));
    }
  }
  return rows;
}

void write_rows(const fs::path& csv, std::vector<Row>& rows) {
  std::ranges::sort(rows, {}, &Row::index);
  std::string text = header() + "\n";
  for (const Row& row : rows) text += disturbed_line(row) + "\n";
  write_file(csv, text);
}

std::vector<Row> resumed(const SweepSetup& setup, const fs::path& folder, bool resume) {
  const fs::path csv = folder / "runs.csv";
  if (!fs::exists(csv)) return {};
  if (!resume) {
    throw BadInput(fmt::format("{}:1: there are runs in this folder; go on with --resume, or name another one with --out", csv.string()));
  }
  const std::string path = (folder / "setup.json").string();
  check_same_sweep(setup, read_setup(path), path);
  std::vector<Row> rows = rows_of(csv.string());
  for (const Row& row : rows) {
    if (row.index < setup.runs) continue;
    throw BadInput(fmt::format("{}:1: it has run {}; go on with --runs {} or more, or name another folder with --out", csv.string(),
                               row.index, row.index + 1));
  }
  return rows;
}

}  // namespace

std::string disturbed_line(const Row& row) { return csv_line(row) + "," + start_reason(row); }

Row disturbed_row_of(const std::string& text, const std::string& path, int line) {
  const std::size_t comma = text.rfind(',');
  const std::string reason = comma == text.npos ? "" : text.substr(comma + 1);
  Row row = parse_csv_line(kTable, text.substr(0, comma), path, line);
  for (int k = 0; k <= static_cast<int>(Reason::kNoPolarity); ++k) {
    row.findings.sinusoidal_reason = static_cast<Reason>(k);
    if (reason == start_reason(row)) return row;
  }
  throw BadInput(fmt::format("{}:{}: drive_reason is \"{}\"; remove this line and go on with --resume", path, line, reason));
}

SweepEnd sweep_disturbances(const SweepSetup& setup, const std::vector<DriveFile>& files, const SweepOptions& options,
                            const fs::path& folder) {
  if (options.shard.count != 1) throw BadInput("--shard serves starts, and six-step drives; leave it out for disturbances of sinusoidal ones");
  SweepEnd end;
  end.rows = resumed(setup, folder, options.resume);
  fs::create_directories(folder);
  const fs::path csv = folder / "runs.csv";
  write_file(folder / "setup.json", setup_text(setup));
  write_rows(csv, end.rows);

  std::set<std::uint64_t> have;
  for (const Row& row : end.rows) have.insert(row.index);
  const std::vector<std::size_t> drives = drives_of_runs(setup);
  std::vector<std::uint64_t> missing;
  for (std::uint64_t k = 0; k < setup.runs; ++k) {
    if (!have.contains(k)) missing.push_back(k);
  }
  std::ofstream out(csv, std::ios::binary | std::ios::app);
  Tasks tasks{.count = missing.size(), .jobs = options.jobs, .work = {}, .take = {}, .go_on = {}};
  tasks.work = [&](std::uint64_t task, const std::function<bool()>& go_on) -> std::optional<std::string> {
    const std::uint64_t k = missing[task];
    const design::Settings& s = files[drives[k]].settings;
    const auto row = disturbed_row(k, setup.drives[drives[k]].name, s, disturbed_seed(s, setup.kind, k), go_on);
    return row ? std::optional(disturbed_line(*row)) : std::nullopt;
  };
  tasks.take = [&](const std::string& line) {
    if (!(out << line + '\n' << std::flush)) throw std::runtime_error(csv.string() + ": cannot write this file");
    end.rows.push_back(disturbed_row_of(line, csv.string(), static_cast<int>(end.rows.size()) + 2));
    ++end.done;
  };
  tasks.go_on = [&] {
    end.interrupted = end.interrupted || (options.progress && !options.progress(end.done, missing.size()));
    return !end.interrupted;
  };
  do_in_processes(tasks);
  out.close();
  write_rows(csv, end.rows);
  return end;
}

}  // namespace steplock::sinusoidal
