// Loads a drives/*.toml file into design::Settings, or says everything that is wrong with it.
//
// The keys, their units, ranges and defaults are the table of model/design/settings_keys.hpp; this
// loader only walks it.  A value is a number in the key's own unit, or a string that names one:
//
//     inductance_h = 188e-6        inductance_h = "188 uH"
//
// Refused, one line `file:line: what; how to mend` each, sorted by line: unknown and missing keys and
// sections, wrong types and units, values out of range, and what the plant finds absurd.
//
// Doc: docs/drive_file.md   Test: tests/testbench/drive_file_test.cpp
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/design/settings.hpp"
#include "model/plant/adc.hpp"

namespace steplock {

// what() is one or more whole lines, the last one without a newline.
class BadInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct DriveFile {
  std::string path;                    // as given, for messages
  design::Settings settings;
  std::map<std::string, int> line_of;  // "motor.flux_vs" and "motor"
};

DriveFile load_drive_file(const std::string& path);  // throws BadInput
DriveFile parse_drive_file(const std::string& text, const std::string& path);

// The same file with every key that it does not give as a comment in its section.  Throws BadInput where `text` is no drive file.
std::string with_every_key(const std::string& text, const std::string& path);

// The motor, bridge and sensors that the settings describe.
plant::Parameters plant_parameters(const design::Settings&);
plant::AdcParameters adc_parameters(const design::Settings&);
// The rotor at t = 0; the angle is electrical.
plant::InitialState initial_state(const design::Settings&, double angle_deg);

// Every key with unit, default, range and meaning, as a Markdown page (docs/drive_file.md).
std::string drive_file_reference();

}  // namespace steplock
