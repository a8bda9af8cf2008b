// Checks a loaded drive file for sense, beyond the range of each key: what the plant, the design
// library and the scenario object to, each as `file:line: ...` at the key it begins with.
//
// Test: tests/testbench/check_test.cpp
#pragma once

#include "testbench/drive_file/drive_file.hpp"

namespace steplock {

void check_drive_file(const DriveFile&);      // throws BadInput with all lines
DriveFile open_drive_file(const std::string& path);  // loads and checks

// Of a sinusoidal drive: what the blocks of fixed point cannot do, as one line at its kind.
void check_config(const DriveFile&);
// For what serves one kind of drive alone: throws BadInput with one line that names `what` and the kind.
void require_kind(const DriveFile&, design::DriveKind, const std::string& what);
// The drives of one kind among files; the others are named on standard error.  Throws if there is none.
std::vector<DriveFile> open_files_of(design::DriveKind, const std::vector<std::string>& paths,
                                     const std::string& what);
std::vector<DriveFile> open_six_step_files(const std::vector<std::string>& paths,
                                           const std::string& what);
// The kind that a sweep over these files is of: six-step if there is one among them.
design::DriveKind kind_among(const std::vector<std::string>& paths);

}  // namespace steplock
