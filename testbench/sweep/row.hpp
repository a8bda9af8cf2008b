// A run of a sweep as one line of runs.csv, and back.
//
// A line holds what was drawn and what came of it, and nothing of how it was computed (no times of
// the machine, no paths): the same run is the same text wherever and in whatever order it is done.
//
// Doc: docs/sweep.md   Test: tests/testbench/row_test.cpp
#pragma once

#include <string>

#include "testbench/sweep/conditions.hpp"
#include "testbench/sweep/witness.hpp"

namespace steplock {

struct Row {
  std::uint64_t index = 0;   // in the sweep
  std::string drive;         // the file's name without folder and ending
  std::uint64_t seed = 0;    // of the run
  bool outside = false;      // drawn outside the envelope
  std::string rtl;           // "": not repeated; "equal"; or where the RTL differed
  Conditions conditions;
  Findings findings;
};

// visit(name, value) for each column, in order.
template <class R, class Visitor>
void for_each_column(R& r, Visitor&& visit) {
  auto& c = r.conditions;
  auto& f = r.findings;
  visit("index", r.index);
  visit("drive", r.drive);
  visit("seed", r.seed);
  visit("outside", r.outside);
  visit("outcome", f.outcome);
  visit("reason", f.reason);
  visit("lock_time_s", f.lock_time_s);
  visit("speed_time_s", f.speed_time_s);
  visit("kick_deg", f.kick_deg);
  visit("peak_current_a", f.peak_current_a);
  visit("retries", f.retries);
  visit("lost_locks", f.lost_locks);
  visit("slips", f.slips);
  visit("end_s", f.end_s);
  visit("angle_deg", c.angle_deg);
  visit("load", c.load);
  visit("fan", c.fan);
  visit("inertia", c.inertia);
  visit("bus", c.bus);
  visit("resistance", c.resistance);
  visit("inductance", c.inductance);
  visit("flux", c.flux);
  visit("offset_u_v", c.offset_u_v);
  visit("offset_v_v", c.offset_v_v);
  visit("offset_w_v", c.offset_w_v);
  visit("noise_v", c.noise_v);
  visit("delay_s", c.delay_s);
  visit("speed", c.speed);
  visit("rtl", r.rtl);
}

std::string csv_header();
std::string csv_line(const Row&);  // without the newline
// Throws BadInput, `file:line: what; how to mend`.
Row parse_csv_line(const std::string& text, const std::string& path, int line);
// Rows of a whole file; a last line without its newline, left by a machine that stopped, is dropped.
std::vector<Row> read_rows(const std::string& path);

}  // namespace steplock
