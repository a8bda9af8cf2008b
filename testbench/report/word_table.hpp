// The register words of a drive with their quantisation errors, as `steplock design` shows them.
//
// Doc: docs/steplock.md   Test: tests/testbench/command_test.cpp
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/design/config.hpp"

namespace steplock {

std::string word_table(const std::vector<design::WordRow>&);
// name, word, unit, wanted, meant, error, error_percent; what is not finite is null.
nlohmann::ordered_json word_table_json(const std::vector<design::WordRow>&);

}  // namespace steplock
