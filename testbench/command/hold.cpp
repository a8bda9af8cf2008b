#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <thread>

#include "testbench/command/command.hpp"
#include "testbench/command/terminal.hpp"
#include "testbench/range/hold.hpp"
#include "testbench/report/report.hpp"
#include "testbench/run/check.hpp"
#include "testbench/sweep/workers.hpp"

namespace steplock {
namespace {

struct Arguments {
  std::vector<std::string> files;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::string page, printed_by;
  std::uint64_t seed = 0;
};

int hold(const Arguments& arguments) {
  namespace fs = std::filesystem;
  const std::vector<DriveFile> files = open_six_step_files(arguments.files, "a hold");
  std::vector<HeldMotor> all;
  for (const DriveFile& f : files) all.push_back({fs::path(f.path).stem().string(), f.settings, {}});
  Interrupt interrupt;
  std::size_t done = 0;
  {
    ProgressBar bar("hold");
    do_in_processes({.count = all.size(), .jobs = arguments.jobs,
                     .work = [&](std::uint64_t k, const auto&) -> std::optional<std::string> {
                       return fmt::format("{},{}", k, to_line(start_and_hold(all[k].settings)));
                     },
                     .take = [&](const std::string& line) {
                       const std::size_t comma = line.find(',');
                       all[std::stoul(line.substr(0, comma))].hold = hold_of(line.substr(comma + 1));
                       bar.show(double(++done) / double(all.size()));
                     },
                     .go_on = [&] { return !interrupt.asked(); }});
  }
  if (done < all.size()) return kInterrupted;
  std::size_t held = 0;
  for (const HeldMotor& m : all) {
    held += m.hold.held;
    if (arguments.page.empty() || !m.hold.held) {
      fmt::print("  {}: {}, locked after {}, {:.5g} r/min, {} locks lost {}\n", m.name, m.hold.held ? "held" : "NOT HELD",
                 m.hold.lock_s ? fmt::format("{:.4f} s", *m.hold.lock_s) : "never", m.hold.rpm, m.hold.lost_locks, m.hold.reason);
    }
  }
  fmt::print("  {} of {} held\n", held, all.size());
  if (!arguments.page.empty()) {
    write_file(arguments.page, decades_page(all, arguments.printed_by, arguments.seed));
    fmt::print("  wrote {}\n", arguments.page);
  }
  return held == all.size() ? kWell : kFailed;
}

}  // namespace

void add_hold_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("hold", "Start each drive once from rest: whether it locks and holds the lock.");
  command->add_option("FILES", arguments->files, "drive files")->required();
  command->add_option("--jobs", arguments->jobs, "processes (default: all cores)")->check(CLI::Range(1, 256));
  command->add_option("--page", arguments->page, "write the page of tools/decades into this file");
  command->add_option("--printed-by", arguments->printed_by, "what the page says it was printed by")->group("");
  command->add_option("--seed", arguments->seed, "of the motors, for the page")->group("");
  command->footer("Example: steplock hold drives/bly172s.toml drives/tekin_spindle.toml");
  command->callback([arguments, &exit_code] { exit_code = hold(*arguments); });
}

}  // namespace steplock
