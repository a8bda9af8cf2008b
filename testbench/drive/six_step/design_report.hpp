// What `steplock design` shows: filter components, gains, margins, start, register words with their
// quantisation errors, error budget, and a Bode plot of the open loop.
//
// Doc: docs/steplock.md   Test: tests/testbench/command_test.cpp
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "model/design/settings.hpp"
#include "testbench/report/figure.hpp"

namespace steplock {

struct DesignReport {
  std::string text;
  nlohmann::ordered_json json;
  Figure bode;
};

DesignReport design_report(const design::Settings&);

}  // namespace steplock
