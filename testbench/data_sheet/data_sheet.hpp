// A drive file from what a motor's data sheet prints.
//
// What follows from what is in testbench/drive_file/sheet_terms.hpp, whose formulas a drive file in such terms takes, too.
//
// What says the same thing twice has to agree within 10 %.  What is not given and can be estimated is, and the file
// says so in `assumed`.
//
// Doc: docs/first_motor.md   Test: tests/testbench/data_sheet_test.cpp
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace steplock {

// Nothing is what the sheet does not print.
struct DataSheet {
  std::string name;
  std::optional<double> bus_v;
  std::optional<double> poles, pole_pairs;
  std::optional<double> kv_rpm_per_v, torque_constant_nm_a, no_load_speed_rpm;
  std::optional<double> no_load_current_a;
  std::optional<double> resistance_line_ohm, resistance_phase_ohm;
  std::optional<double> inductance_line_h, inductance_phase_h;
  std::optional<double> inertia_gcm2;
  std::optional<double> rated_current_a, rated_torque_nm;
  std::optional<double> limit_a, speed_rpm;
  double clock_mhz = 24, pwm_khz = 24;
  bool trapezoidal = false;
};

// An entry of the sheet: its option on the command line, the question, and the mistake that is usual with it.
struct SheetEntry {
  const char* option;
  const char* question;
  const char* mistake;
  std::optional<double> DataSheet::*value;
  double least, most;
};
const std::vector<SheetEntry>& sheet_entries();

// The drive file.  Throws BadInput, one line for each thing that is missing, contradicts another or cannot be.
std::string drive_file_of(const DataSheet&);

}  // namespace steplock
