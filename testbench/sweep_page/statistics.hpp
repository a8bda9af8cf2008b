// The statistics of a sweep, as sweep.json and as text; and the page with plots.
//
//     runs = started + rough + latched + silent_step_outs + unfinished, all of them and per part:
//     inside and outside the envelope, per drive.  Times, currents and kicks are min, median, max;
//     lock times of the runs that started, kicks of those whose rotor was at rest.
//
// Nothing here depends on the machine or on how the sweep was cut.
//
// Doc: docs/sweep.md   Test: tests/testbench/sweep_test.cpp
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "testbench/sweep/row.hpp"
#include "testbench/sweep/setup.hpp"

namespace steplock {

nlohmann::ordered_json sweep_json(const SweepSetup&, const std::vector<Row>&);
std::string sweep_text(const SweepSetup&, const std::vector<Row>&);  // for a terminal

// Runs inside the envelope that did not start, and runs outside it that did not end as they must.
std::vector<const Row*> failures(const std::vector<Row>&);
// Why: the reason of the fault, or the bounds that a rough start passed.
std::string failure(const Row&);
// A fingerprint of the first `count` runs, which are the same in a longer sweep: with it a page can tell
// whether it is stale.  The rows are in the order of their index.
std::string prefix_digest(const std::vector<Row>&, std::uint64_t count);
// Every run is here, none failed, and the RTL agreed wherever it was asked.
bool passed(const SweepSetup&, const std::vector<Row>&);

// sweep.json, sweep.html and its figures; returns warnings.
std::vector<std::string> write_sweep_report(const SweepSetup&, const std::vector<Row>&,
                                            const std::filesystem::path& folder);
// The drive of a run; null if the setup does not name it.
const SweepDrive* drive_of(const SweepSetup&, const Row&);
// The highest current of a run over what its drive keeps it to, where that is known.
std::optional<double> peak_over_limit(const SweepSetup&, const Row&);
// So many drives that a page names only those of which something is to be told.
bool of_many(const SweepSetup&);
// That many, and all of them from `steplock motors`.
bool of_drawn_motors(const SweepSetup&);
// Of the page's file and figures: starts, sinusoidal_starts, hard_starts, motor_starts or disturbances.
std::string page_stem(const SweepSetup&);
std::string start_page(const SweepSetup&, const std::vector<Row>&);  // docs/starts.md
// The sweep as a committed page: PAGE.md, PAGE.json (the statistics and a prefix digest), figures/.
void write_sweep_page(const SweepSetup&, const std::vector<Row>&, const std::filesystem::path& page);

}  // namespace steplock
