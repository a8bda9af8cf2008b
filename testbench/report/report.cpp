#include "testbench/report/report.hpp"

#include <fmt/format.h>

#include <fstream>

#include "testbench/report/csv.hpp"
#include "testbench/run/trace_writer.hpp"

namespace steplock {
namespace {

namespace fs = std::filesystem;

void write_file(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  if (!(out << text << std::flush)) {
    throw std::runtime_error(path.string() + ": cannot write this file");
  }
}

}  // namespace

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
  return files;
}

}  // namespace steplock
