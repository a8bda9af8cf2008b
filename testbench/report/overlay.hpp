// Two runs laid over each other, from the folders that `steplock run` left: figures with a curve each, and their numbers side by side.
//
// Doc: docs/report.md   Test: tests/testbench/overlay_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "testbench/report/figure.hpp"

namespace steplock {

// Throws BadInput where a folder is not that of a run.
struct RunFolder {
  explicit RunFolder(const std::filesystem::path& folder);
  // Of run.csv or steady.csv; an empty column is one that it does not have.
  std::vector<double> column(const std::string& file, const std::string& name) const;

  std::filesystem::path path;
  std::string summary;  // JSON
};

// Speed, largest phase current, torque and duty over the whole run, and current and speed in steady state; what both runs have.
std::vector<Figure> overlay_figures(const RunFolder& a, const RunFolder& b);
// The page, with these figures drawn in `out`.
std::string overlay_page(const RunFolder& a, const RunFolder& b, const std::vector<Figure>&, const std::filesystem::path& out);

}  // namespace steplock
