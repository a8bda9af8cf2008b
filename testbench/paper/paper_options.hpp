// How a paper's page is made.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "testbench/run/run_drive.hpp"

namespace steplock {

struct PaperOptions {
  EngineKind engine = EngineKind::kRtl;
  // These alone, counted from 1 in the order of the page; none: the whole page.
  std::vector<int> sections = {};
  bool wants(int section) const {
    return sections.empty() || std::ranges::find(sections, section) != sections.end();
  }
  // What is under way, and how much of it is done; false stops.
  std::function<bool(const std::string& what, double done)> progress = {};
};

}  // namespace steplock
