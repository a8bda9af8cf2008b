#include <fmt/format.h>

#include <chrono>
#include <charconv>
#include <filesystem>
#include <map>
#include <memory>
#include <thread>

#include "testbench/command/command.hpp"
#include "testbench/command/judged.hpp"
#include "testbench/command/terminal.hpp"
#include "testbench/drive/drive.hpp"
#include "testbench/run/check.hpp"
#include "testbench/sweep_page/statistics.hpp"
#include "testbench/sweep/sweep.hpp"

namespace steplock {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::vector<std::string> files;
  std::string out, page, judged, shard = "0/1";
  SweepKind kind;
  std::optional<design::DriveKind> drive_kind;
  std::uint64_t runs = 100;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  bool resume = false, json = false, prints_judged = false;
};

Shard parse_shard(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto [slash, error] = std::from_chars(text.data(), end, shard.index);
  bool good = error == std::errc() && slash != end && *slash == '/';
  if (good) {
    const auto [rest, wrong] = std::from_chars(slash + 1, end, shard.count);
    good = wrong == std::errc() && rest == end && shard.index < shard.count;
  }
  if (!good) throw BadInput(fmt::format("--shard is {}; write i/n with i from 0 to n - 1, such as 0/4", text));
  return shard;
}

// Prints what the folder now holds and returns the exit code.
int conclude(const SweepSetup& setup, const SweepEnd& end, const fs::path& folder, bool json, bool whole) {
  for (const std::string& warning : write_sweep_report(setup, end.rows, folder)) {
    fmt::print(stderr, "steplock: {}\n", warning);
  }
  if (json) {
    fmt::print("{}\n", sweep_json(setup, end.rows).dump(2));
  } else {
    fmt::print("{}  wrote {}\n", sweep_text(setup, end.rows), (folder / "sweep.html").string());
  }
  if (end.interrupted) return kInterrupted;
  // A shard passes without the others' runs.
  SweepSetup present = setup;
  if (!whole) present.runs = end.rows.size();
  return passed(present, end.rows) ? kWell : kFailed;
}

std::uint64_t seed_of(const std::string& digest) {
  constexpr std::size_t kDigits = 12;
  std::uint64_t seed = 0;
  const char* const end = digest.data() + std::min(kDigits, digest.size());
  const auto [at, error] = std::from_chars(digest.data(), end, seed, 16);
  if (digest.size() < kDigits || error != std::errc() || at != end) {
    throw BadInput(fmt::format("--seed-from is {}; write a digest of 12 hexadecimal digits or more, such as tools/starts makes", digest));
  }
  return seed;
}

int run_sweep(Arguments arguments) {
  if (!arguments.judged.empty()) arguments.kind.seed = seed_of(arguments.judged);
  const Shard shard = parse_shard(arguments.shard);
  const Matrix matrix = arguments.kind.matrix;
  if (matrix != Matrix::kStart && arguments.kind.outside > 0) {
    throw BadInput(fmt::format("--outside is for starts; leave it out with --matrix {}", name_of(matrix)));
  }
  const design::DriveKind drive_kind = arguments.drive_kind ? *arguments.drive_kind : kind_among(arguments.files);
  const bool sinusoidal = drive_kind == design::DriveKind::kSinusoidal;
  if (sinusoidal && matrix == Matrix::kHard) {
    throw BadInput("--matrix hard serves six-step drives alone; leave it out for sinusoidal ones, or write --matrix disturb");
  }
  const std::vector<DriveFile> files = open_files_of(
      drive_kind, arguments.files, sinusoidal ? "a sweep of sinusoidal drives" : "a sweep");
  for (const DriveFile& file : files) {
    if (sinusoidal) check_config(file);
  }
  if (arguments.prints_judged) {
    for (const DriveFile& file : files) fmt::print("{}", judged_text(file));
    return kWell;
  }
  SweepSetup setup = sweep_setup(arguments.kind, arguments.runs, files);
  setup.judged = arguments.judged;
  const fs::path folder = arguments.out.empty() ? fs::path("out/sweep") : fs::path(arguments.out);
  SweepEnd end;
  const auto began = std::chrono::steady_clock::now();
  {
    Interrupt interrupt;
    ProgressBar bar("sweep");
    const SweepOptions options{.shard = shard, .jobs = arguments.jobs, .resume = arguments.resume,
                               .progress = [&](std::uint64_t done, std::uint64_t all) {
                                 bar.show(all > 0 ? static_cast<double>(done) / static_cast<double>(all) : 1,
                                          fmt::format(" {}/{}", done, all));
                                 return !interrupt.asked();
                               }};
    end = with_drive(files.front().settings, [&](auto drive) {
      return matrix == Matrix::kDisturb ? drive.disturb(setup, files, options, folder) : sweep(setup, files, options, folder);
    });
  }
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  fmt::print(stderr, "{} runs in {:.1f} s with {} jobs: {:.2f} runs per second\n", end.done, wall,
             arguments.jobs, static_cast<double>(end.done) / wall);
  if (!arguments.page.empty() && end.rows.size() == setup.runs) write_sweep_page(setup, end.rows, arguments.page);
  return conclude(setup, end, folder, arguments.json, shard.count == 1);
}

int run_merge(const std::vector<std::string>& parts, const std::string& out, bool json) {
  SweepSetup setup;
  const std::vector<fs::path> folders(parts.begin(), parts.end());
  const SweepEnd end = merge_sweeps(folders, out, setup);
  return conclude(setup, end, out, json, true);
}

}  // namespace

void add_sweep_command(CLI::App& app, int& exit_code) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "sweep", "Simulate many runs, drawn at random from the drives' envelopes, and count.");
  command->add_option("FILE", a->files, "drive files")->required();
  command->add_option("--runs", a->runs, "runs in total (default 100)")->check(CLI::Range(1, 100000000));
  CLI::Option* const seed = command->add_option("--seed", a->kind.seed, "of the sweep (default 1)");
  command->add_option("--seed-from", a->judged,
                      "a digest in hexadecimal, whose first 12 digits are the seed; the page names it (tools/starts)")
      ->excludes(seed);
  command->add_option("--jobs", a->jobs, "processes (default: as many as cores)")->check(CLI::Range(1, 4096));
  command->add_option("--shard", a->shard, "i/n: only every n-th run, i from 0 to n - 1; see merge");
  command->add_option("--out", a->out, "folder (default out/sweep)");
  command->add_option("--page", a->page, "when all runs are done, print the committed page there, such as docs/starts.md");
  command->add_flag("--resume", a->resume, "do only the runs that the folder does not hold");
  command->add_flag("--json", a->json, "print sweep.json on standard output");
  command->add_flag("--judged", a->prints_judged,
                    "run nothing; print settings, words and bounds of each drive, from which tools/starts makes its seed");
  command->add_option("--matrix", a->kind.matrix,
                      "start (the default): a start alone; disturb: then one disturbance of the running drive; "
                      "hard: a start with one hardship more than the envelope has")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Matrix>{{"start", Matrix::kStart}, {"disturb", Matrix::kDisturb}, {"hard", Matrix::kHard}}));
  command->add_option("--kind", a->drive_kind,
                      "six_step or sinusoidal: the drives of the other kind are left out (default: six_step if there is one)")
      ->transform(CLI::CheckedTransformer(std::map<std::string, design::DriveKind>{
          {"six_step", design::DriveKind::kSixStep}, {"sinusoidal", design::DriveKind::kSinusoidal}}));
  command->add_option("--outside", a->kind.outside, "part of the runs drawn outside the envelope (default 0)")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--rtl", a->kind.rtl, "part of the runs repeated on the RTL (default 0.01)")
      ->check(CLI::Range(0.0, 1.0));
  command->footer("Example: steplock sweep drives/*.toml --runs 1000 --seed 7 --out out/starts");
  command->callback([a, &exit_code] { exit_code = run_sweep(*a); });
}

void add_merge_command(CLI::App& app, int& exit_code) {
  struct Merge {
    std::vector<std::string> parts;
    std::string out;
    bool json = false;
  };
  auto a = std::make_shared<Merge>();
  CLI::App* command = app.add_subcommand("merge", "Put the shards of a sweep together.");
  command->add_option("DIR", a->parts, "folders of the shards")->required();
  command->add_option("--out", a->out, "folder of the whole")->required();
  command->add_flag("--json", a->json, "print sweep.json on standard output");
  command->footer("Example: steplock merge out/shard0 out/shard1 --out out/whole");
  command->callback([a, &exit_code] { exit_code = run_merge(a->parts, a->out, a->json); });
}

}  // namespace steplock
