// The words of a drive as the C driver takes them: what `steplock design FILE --c-header` prints,
// straight from the table of registers.
//
// Doc: docs/registers.md   Test: tests/testbench/host_driver_test.cpp
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <type_traits>
#include <vector>

#include "hls/bus/word_rows.hpp"
#include "rtl/host/steplock.h"

namespace steplock {

inline std::vector<steplock_word> register_words(const Words& words) {
  std::map<int, std::uint32_t> values;
  const auto place = [&](const auto& row) {
    using Word = typename std::remove_cvref_t<decltype(row)>::Word;
    values[row.address] |= static_cast<std::uint32_t>(bits_of(Word::of(words)).raw()) << row.lsb;
  };
  std::apply([&](const auto&... row) { (place(row), ...); }, kWordRows);
  std::vector<steplock_word> list;
  for (const auto& [address, value] : values) list.push_back({std::uint32_t(address), value});
  return list;
}

}  // namespace steplock
