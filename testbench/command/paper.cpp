#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/command/terminal.hpp"
#include "testbench/paper/amano2003.hpp"
#include "testbench/paper/matsui1996.hpp"
#include "testbench/run/check.hpp"

namespace steplock {
namespace {

struct Arguments {
  std::string name, out = "out/papers", drives = "drives";
  EngineKind engine = EngineKind::kRtl;
  std::vector<int> sections;
};

int print_paper(const Arguments& arguments) {
  const DriveFile file = open_drive_file(arguments.drives + "/" + arguments.name + ".toml");
  PaperPage page;
  {
    Interrupt interrupt;
    ProgressBar bar(arguments.name);
    const PaperOptions options{.engine = arguments.engine,
                               .sections = arguments.sections,
                               .progress = [&](const std::string& what, double done) {
                                 bar.show(done, what);
                                 return !interrupt.asked();
                               }};
    if (arguments.name == "amano2003") {
      page = amano2003_page(file.settings, options);
    } else {
      const DriveFile salient = open_drive_file(arguments.drives + "/ipm_2k2.toml");
      page = matsui1996_page(file.settings, salient.settings, options);
    }
  }
  for (const auto& path : write_paper(page, arguments.out)) fmt::print("  wrote {}\n", path.string());
  int exit_code = kWell;
  for (const PaperSection& s : page.sections) {
    for (const std::string& failure : s.failures) {
      fmt::print(stderr, "{}: does not hold: {}\n", s.title, failure);
      exit_code = kFailed;
    }
  }
  return exit_code;
}

}  // namespace

void add_paper_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "paper", "Run a paper's figures on this drive and print them side by side with the paper's.");
  command->add_option("PAPER", arguments->name, "amano2003 or matsui1996")
      ->required()
      ->check(CLI::IsMember({"amano2003", "matsui1996"}));
  command->add_option("--engine", arguments->engine,
                      "rtl (generated SystemVerilog, the default) or fixed (its C++ source, faster)")
      ->transform(engine_among({EngineKind::kRtl, EngineKind::kFixed}));
  command->add_option("--section", arguments->sections,
                      "only these sections of the page, counted from 1 (default all)")
      ->check(CLI::PositiveNumber);
  command->add_option("--drives", arguments->drives, "where the drive file is (default drives)");
  command->add_option("--out", arguments->out,
                      "directory of the page and its figures (default out/papers)");
  command->footer("Example: steplock paper amano2003 --out docs/papers");
  command->callback([arguments, &exit_code] { exit_code = print_paper(*arguments); });
}

}  // namespace steplock
