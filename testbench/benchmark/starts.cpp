// How many drawn starts a second the sweep does on one core: the first runs of `steplock sweep --seed 1` over all
// drives, in the sweep's own proportion, without the RTL.  CPU time.
//
//     cmake --build build -t benchmark_starts && build/bin/benchmark_starts
//
// Doc: docs/sweep.md
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>

#include "testbench/sweep/sweep.hpp"

namespace steplock {
namespace {

std::vector<DriveFile> all_drives() {
  std::vector<DriveFile> files;
  for (const auto& entry : std::filesystem::directory_iterator(STEPLOCK_DRIVES)) {
    if (entry.path().extension() != ".toml") continue;
    DriveFile file = load_drive_file(entry.path().string());
    if (file.settings.drive.kind == design::DriveKind::kSixStep) files.push_back(std::move(file));
  }
  std::ranges::sort(files, {}, &DriveFile::path);
  return files;
}

void starts(benchmark::State& state) {
  constexpr std::uint64_t kRuns = 24;
  const std::vector<DriveFile> files = all_drives();
  const SweepSetup setup = sweep_setup({.seed = 1, .rtl = 0}, kRuns, files);
  const std::vector<std::size_t> drives = drives_of_runs(setup);
  double simulated_s = 0;
  for (auto _ : state) {
    for (std::uint64_t k = 0; k < kRuns; ++k) {
      const auto row = make_row(k, setup.drives[drives[k]].name, files[drives[k]].settings, run_seed(setup.kind, k));
      simulated_s += row->findings.end_s;
    }
  }
  const auto count = static_cast<double>(state.iterations());
  state.counters["runs_per_s"] = benchmark::Counter(count * kRuns, benchmark::Counter::kIsRate);
  state.counters["simulated_s_per_run"] = simulated_s / count / kRuns;
}
BENCHMARK(starts)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace steplock

BENCHMARK_MAIN();
