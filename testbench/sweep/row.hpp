// A run of a sweep as one line of runs.csv, and back.
//
// A line holds what was drawn and what came of it, and nothing of how it was computed (no times of
// the machine, no paths): the same run is the same text wherever and in whatever order it is done.
//
// Doc: docs/sweep.md   Test: tests/testbench/row_test.cpp
#pragma once

#include <string>

#include "testbench/sweep/conditions.hpp"
#include "testbench/sweep/aftermath.hpp"
#include "testbench/sweep/disturbance.hpp"
#include "testbench/sweep/hardship.hpp"

namespace steplock {

// Which columns a line has.
struct Table {
  Table(Matrix m, design::DriveKind d = design::DriveKind::kSixStep) : matrix(m), drive(d) {}
  bool sinusoidal() const { return drive == design::DriveKind::kSinusoidal; }
  Matrix matrix;
  design::DriveKind drive;
};

struct Row {
  std::uint64_t index = 0;   // in the sweep
  std::string drive;         // the file's name without folder and ending
  std::uint64_t seed = 0;    // of the run
  bool outside = false;      // drawn outside the envelope
  std::string rtl;           // "": not repeated; "equal"; or where the RTL differed
  Conditions conditions;
  Findings findings;         // of the start
  Disturbance disturbance;   // of a seed that says so
  Hardship hardship;         // likewise
  AfterFindings after;
  design::DriveKind kind = design::DriveKind::kSixStep;  // of the drive; every row of a sweep has the same

  Matrix matrix() const {
    const RunSeed s{seed};
    return s.hard() ? Matrix::kHard : s.disturbed() ? Matrix::kDisturb : Matrix::kStart;
  }
  Table table() const { return {matrix(), kind}; }
};

const char* start_reason(const Row&);  // of the latched fault, or of the last failed try

// visit(name, value) for each column of a start or of a disturbance, in order.
template <class R, class Visitor>
void for_each_start_column(const Table& table, R& r, Visitor&& visit) {
  auto& f = r.findings;
  visit("outside", r.outside);
  visit("outcome", f.outcome);
  if (table.sinusoidal()) {
    visit("reason", f.sinusoidal_reason);
  } else {
    visit("reason", f.reason);
  }
  visit("lock_time_s", f.lock_time_s);
  visit("speed_time_s", f.speed_time_s);
  visit("kick_deg", f.kick_deg);
  visit("peak_current_a", f.peak_current_a);
  visit("peak_speed", f.peak_speed);
  visit("causes", f.causes);
  visit("beyond", f.beyond);
  visit("retries", f.retries);
  visit("lost_locks", f.lost_locks);
  visit("slips", f.slips);
  visit("end_s", f.end_s);
}

template <class R, class Visitor>
void for_each_disturbance_column(R& r, Visitor&& visit) {
  auto& d = r.disturbance;
  auto& f = r.after;
  visit("kind", d.kind);
  visit("size", d.size);
  visit("duration_s", d.duration_s);
  visit("set_speed", d.set_speed);
  visit("steps_per_s", d.steps_per_s);
  visit("outcome", f.outcome);
  visit("reason", f.reason);
  visit("recovery_s", f.recovery_s);
  visit("lost_s", f.lost_s);
  visit("fault_s", f.fault_s);
  visit("dip", f.dip);
  visit("peak_current_a", f.peak_current_a);
  visit("demagnetisation_deg", f.demagnetisation_deg);
  visit("retries", f.retries);
  visit("lost_locks", f.lost_locks);
  visit("slips", f.slips);
  visit("disturbed_s", f.disturbed_s);
  visit("end_s", f.end_s);
  visit("start", r.findings.outcome);
}

template <class R, class Visitor>
void for_each_column(const Table& table, R& r, Visitor&& visit) {
  auto& c = r.conditions;
  visit("index", r.index);
  visit("drive", r.drive);
  visit("seed", r.seed);
  if (table.matrix == Matrix::kDisturb) {
    for_each_disturbance_column(r, visit);
  } else {
    for_each_start_column(table, r, visit);
  }
  if (table.matrix == Matrix::kHard) {
    visit("hardship", r.hardship.kind);
    visit("hard_size", r.hardship.size);
    visit("hard_detail", r.hardship.detail);
    visit("hard_speed", r.hardship.speed);
  }
  visit("angle_deg", c.angle_deg);
  visit("load", c.load);
  visit("fan", c.fan);
  visit("inertia", c.inertia);
  visit("bus", c.bus);
  visit("resistance", c.resistance);
  visit("inductance", c.inductance);
  visit("flux", c.flux);
  if (table.sinusoidal()) {
    visit("offset_u_a", c.offset_u_a);
    visit("offset_v_a", c.offset_v_a);
    visit("offset_w_a", c.offset_w_a);
    visit("noise_a", c.noise_a);
  } else {
    visit("offset_u_v", c.offset_u_v);
    visit("offset_v_v", c.offset_v_v);
    visit("offset_w_v", c.offset_w_v);
    visit("noise_v", c.noise_v);
    visit("delay_s", c.delay_s);
  }
  visit("speed", c.speed);
  visit("rtl", r.rtl);
}

std::string csv_header(const Table&);
std::string csv_line(const Row&);  // without the newline
// Throws BadInput, `file:line: what; how to mend`.
Row parse_csv_line(const Table&, const std::string& text, const std::string& path, int line);
// Rows of a whole file; a last line without its newline, left by a machine that stopped, is dropped.
std::vector<Row> read_rows(const std::string& path);

}  // namespace steplock
