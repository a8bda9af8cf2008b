// The statistics of a disturbance matrix: as sweep.json, as text, as figures, and as the page that
// docs/disturbances.md and docs/sinusoidal_disturbances.md are.
//
//     runs = recovered + latched + silent_step_outs + unfinished + not_started, per kind and per drive.
//     Recovery times of the runs that recovered, in seconds and in commutation steps of the set speed;
//     times to the first loss of lock (gates off) and to the latched fault of those that latched.
//
// A run ends well if a fault that passes is recovered from and one for good is latched.
//
// Doc: docs/disturbances.md   Test: tests/testbench/disturbance_test.cpp
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "testbench/report/figure.hpp"
#include "testbench/sweep/row.hpp"
#include "testbench/sweep/setup.hpp"

namespace steplock {

bool disturbance_well(const Row&);
nlohmann::ordered_json disturbance_json(const SweepSetup&, const std::vector<Row>&, bool passed);
std::string disturbance_text(const SweepSetup&, const std::vector<Row>&, bool passed);
std::vector<Figure> disturbance_figures(const SweepSetup&, const std::vector<Row>&);
// "min / median / max" of what the statistics have so, each times `scale`.
std::string three(const nlohmann::ordered_json& spread, double scale, const char* format = "{:.3g}");
// Markdown; figures beside it under figures/.
std::string disturbance_page(const SweepSetup&, const std::vector<Row>&, bool passed);

}  // namespace steplock
