#include "testbench/report/report.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "testbench/report/csv.hpp"
#include "testbench/report/page.hpp"
#include "testbench/report/run_figures.hpp"
#include "testbench/run/trace_writer.hpp"

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

ReportFiles write_report(const fs::path& directory, const DriveFile& file, const Summary& summary,
                         const Record& record, bool traced) {
  fs::create_directories(directory);
  ReportFiles files;
  const auto add = [&](const char* name, const std::string& text) {
    write_file(directory / name, text);
    files.paths.push_back(directory / name);
  };
  const int pole_pairs = file.settings.motor.pole_pairs;
  add("summary.json", to_json(summary).dump(2) + "\n");
  add("run.csv", samples_csv(record.overview, pole_pairs));
  add("lock.csv", samples_csv(record.lock, pole_pairs));
  add("steady.csv", samples_csv(record.steady, pole_pairs));
  if (traced) {
    files.paths.push_back(directory / "wave.fst");
    add("wave.gtkw", gtkwave_save_file("wave.fst"));
  }
  std::vector<PageFigure> figures;
  for (const Figure& figure : run_figures(file.settings, summary, record)) {
    if (!draw(figure, directory)) {
      files.warnings.push_back("gnuplot does not run, so there are no figures; install gnuplot-nox");
      break;
    }
    files.paths.push_back(directory / (figure.name + ".svg"));
    figures.push_back({figure.caption, inline_svg(files.paths.back())});
  }
  add("report.html", report_page(file.settings, summary, record, figures));
  return files;
}

}  // namespace steplock
