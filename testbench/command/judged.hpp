// What a sweep judges of a drive file, as text that stays while nothing of it changes: the settings in effect, the
// configuration words, and the bounds of a start.  tools/starts makes the seed of the published starts from it.
//
// Doc: docs/sweep.md   Test: tests/tools/starts_digest.sh
#pragma once

#include <string>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock {

// A line per setting, word and bound.  Text of the file (name, source, notes, assumed) is not among them, nor is a setting of
// none (0, false, or left out): so a new key, none by default, changes nothing.
std::string judged_text(const DriveFile&);

}  // namespace steplock
