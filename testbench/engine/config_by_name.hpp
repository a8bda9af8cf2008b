// A drive's configuration as the blocks take it, from the same words as the design library gives them: each by its name, because
// model/ and hls/ must not know each other.
//
// Test: tests/testbench/engine_test.cpp
#pragma once

#include <stdexcept>
#include <tuple>
#include <type_traits>

#include "model/design/config.hpp"
#include "testbench/engine/word_name.hpp"

namespace steplock {

// `rows` is a register map's: every word of the drive.  One that `from` does not name keeps its reset value.  Throws
// std::logic_error where `from` names a word that the drive does not have, or one that does not fit it.
template <class DriveConfig, class... Rows>
DriveConfig config_by_name(const std::tuple<Rows...>& rows, const design::Config& from) {
  DriveConfig config;
  auto left = from.all();
  const auto set = [&](const auto& row) {
    using Place = typename std::remove_cvref_t<decltype(row)>::Word;
    const auto at = left.find(word_name<Place>('.'));
    if (at == left.end()) return;
    auto& word = Place::of(config);
    word = word_of<std::remove_cvref_t<decltype(word)>>(UInt<32>(at->second));
    if (bits_of(word).raw() != at->second) throw std::logic_error(at->first + " has fewer bits than the design library gives it");
    left.erase(at);
  };
  std::apply([&](const auto&... row) { (set(row), ...); }, rows);
  if (!left.empty()) throw std::logic_error("the drive has no word " + left.begin()->first + ", which the design library names");
  return config;
}

}  // namespace steplock
