// Files that appear whole or not at all, and keep their time when their text has not changed.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/refusal_test.cpp

#pragma once

#include <map>
#include <string>

namespace hlsgen {

// Path -> text.  Throws Refusal when a file cannot be written.
void write_files(const std::map<std::string, std::string>& files);

}  // namespace hlsgen
