#include "testbench/report/report.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "testbench/report/zoom.hpp"

namespace steplock {
namespace fs = std::filesystem;

void write_file(const fs::path& path, const std::string& text) {
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  if (!(out << text << std::flush)) {
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored)) fs::remove(path, ignored);
    throw std::runtime_error(path.string() + ": cannot write this file");
  }
}

std::string inline_svg(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  const std::string all = text.str();
  const std::size_t start = all.find("<svg");
  return start == all.npos ? "" : all.substr(start);
}

ReportFiles write_report(const fs::path& directory, const RunReport& report) {
  fs::create_directories(directory);
  ReportFiles files;
  const auto add = [&](const std::string& name, const std::string& text) {
    write_file(directory / name, text);
    files.paths.push_back(directory / name);
  };
  add("summary.json", report.page.numbers.dump(2) + "\n");
  for (const auto& [name, text] : report.samples) add(name, text);
  if (report.wave) {
    files.paths.push_back(directory / "wave.fst");
    add("wave.gtkw", gtkwave_save_file("wave.fst", *report.wave));
  }
  std::vector<PageFigure> figures;
  for (const Figure& figure : report.figures) {
    if (!draw(figure, directory)) {
      files.warnings.push_back("gnuplot does not run, so there are no figures; install gnuplot-nox");
      break;
    }
    files.paths.push_back(directory / (figure.name + ".svg"));
    figures.push_back({figure.caption, inline_svg(files.paths.back()), zoom_body(figure)});
  }
  if (zoom_head().empty()) files.warnings.push_back(kNoZoom);
  add("report.html", report_page(report.page, figures));
  return files;
}

}  // namespace steplock
