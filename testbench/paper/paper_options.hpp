// How a paper's page is made.
#pragma once

#include <functional>
#include <string>

#include "testbench/run/run_drive.hpp"

namespace steplock {

struct PaperOptions {
  EngineKind engine = EngineKind::kRtl;
  // What is under way, and how much of it is done; false stops.
  std::function<bool(const std::string& what, double done)> progress = {};
};

}  // namespace steplock
