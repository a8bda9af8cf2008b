// Writes everything a run leaves in its directory: summary.json, the samples as CSV, figures as SVG,
// and one self-contained HTML page.
//
// Figures need gnuplot; without it the rest is written and a warning says so.
//
// Doc: docs/report.md   Test: tests/testbench/report_test.cpp
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "testbench/report/figure.hpp"
#include "testbench/report/page.hpp"
#include "testbench/run/trace_writer.hpp"

namespace steplock {

struct ReportFiles {
  std::vector<std::filesystem::path> paths;
  std::vector<std::string> warnings;
};

// What a run of either drive leaves.
struct RunReport {
  PageContent page;                                           // its numbers are summary.json
  std::vector<std::pair<std::string, std::string>> samples;   // file and text
  std::vector<Figure> figures;
  const WaveTable* wave = nullptr;                            // if wave.fst was written
};
ReportFiles write_report(const std::filesystem::path& directory, const RunReport&);

// Whole or not at all; makes the directory.  Throws std::runtime_error.
void write_file(const std::filesystem::path&, const std::string& text);
// Of a drawn figure, without the XML prologue, which has no place inside a page.
std::string inline_svg(const std::filesystem::path&);

}  // namespace steplock
