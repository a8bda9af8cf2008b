// The values of a drive file's keys as text: as the file has them, or as a table shows them.
//
// Doc: docs/drive_file.md   Test: tests/testbench/data_sheet_test.cpp
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "model/design/settings_keys.hpp"

namespace steplock {

// An optional without a value is no text.
inline std::string toml_text(double x) { return fmt::format("{:g}", x); }
inline std::string toml_text(int x) { return fmt::format("{}", x); }
inline std::string toml_text(bool x) { return x ? "true" : "false"; }
inline std::string toml_text(const std::string& x) { return fmt::format("\"{}\"", x); }
inline std::string toml_text(const std::optional<double>& x) { return x ? toml_text(*x) : ""; }
template <std::size_t N>
std::string toml_text(const std::array<double, N>& x) {
  return fmt::format("[{:g}]", fmt::join(x, ", "));
}
inline std::string toml_text(const std::vector<double>& x) { return fmt::format("[{:g}]", fmt::join(x, ", ")); }
inline std::string toml_text(const std::vector<std::string>& x) {
  return x.empty() ? "[]" : fmt::format("[\"{}\"]", fmt::join(x, "\", \""));
}
template <class E>
  requires std::is_enum_v<E>
std::string toml_text(E x) {
  return fmt::format("\"{}\"", design::enum_words(E{})[static_cast<std::size_t>(x)]);
}

// The words of an enum; of all else none.
template <class T>
std::string choices(const T&) {
  if constexpr (std::is_enum_v<T>) {
    return fmt::format("{}", fmt::join(design::enum_words(T{}), ", "));
  } else {
    return "";
  }
}

}  // namespace steplock
