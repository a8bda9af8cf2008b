// How a paper's page is made.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/run/run_options.hpp"

namespace steplock {

struct PaperOptions {
  EngineKind engine = EngineKind::kRtl;
  // These alone, counted from 1 in the order of the page; none: the whole page.
  std::vector<int> sections = {};
  bool wants(int section) const {
    return sections.empty() || std::ranges::find(sections, section) != sections.end();
  }
  // Throws BadInput if one of them is not on the page.
  void check_sections(int first, int last) const {
    for (const int section : sections) {
      if (section >= first && section <= last) continue;
      throw BadInput("--section " + std::to_string(section) + " is not measured: name one of " +
                     std::to_string(first) + " to " + std::to_string(last));
    }
  }
  // What is under way, and how much of it is done; false stops.
  std::function<bool(const std::string& what, double done)> progress = {};
};

}  // namespace steplock
