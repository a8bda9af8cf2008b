#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/command/terminal.hpp"
#include "testbench/range/gallery.hpp"
#include "testbench/report/report.hpp"
#include "testbench/run/check.hpp"

namespace steplock {
namespace {

struct Arguments {
  std::vector<std::string> files;
  std::string out = "out/gallery";
};

int print_gallery(const Arguments& arguments) {
  namespace fs = std::filesystem;
  const std::vector<DriveFile> files = open_six_step_files(arguments.files, "the gallery");
  std::vector<GalleryEntry> all;
  {
    Interrupt interrupt;
    ProgressBar bar("gallery");
    for (const DriveFile& file : files) {
      all.push_back(gallery_entry(file, [&](double done) {
        bar.show((static_cast<double>(all.size()) + done) / static_cast<double>(files.size()), fs::path(file.path).stem().string());
        return !interrupt.asked();
      }));
    }
  }
  const fs::path out = arguments.out;
  std::vector<Figure> figures;
  bool well = true;
  for (const GalleryEntry& e : all) {
    if (!e.start.panels.empty()) figures.push_back(e.start);
    for (const std::string& why : e.summary.failures()) {
      fmt::print("  {}: {}\n", e.file, why);
      well = false;
    }
  }
  draw_all(figures, out / "figures");
  write_file(out / "gallery.md", gallery_page(all));
  fmt::print("  wrote {}\n", (out / "gallery.md").string());
  return well ? kWell : kFailed;
}

}  // namespace

void add_gallery_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("gallery", "Run several drive files once each: a table of motors and runs, and the curves of their starts.");
  command->add_option("FILES", arguments->files, "drive files")->required();
  command->add_option("--out", arguments->out, "directory of gallery.md and its figures (default out/gallery)");
  command->footer("Example: steplock gallery drives/data_sheets/*.toml");
  command->callback([arguments, &exit_code] { exit_code = print_gallery(*arguments); });
}

}  // namespace steplock
