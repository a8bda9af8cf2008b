// Prints docs/drive_file.md from the table of keys.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/design/settings_keys.hpp"
#include "testbench/drive_file/drive_file.hpp"
#include "testbench/drive_file/key_text.hpp"
#include "testbench/drive_file/sheet_terms.hpp"

namespace steplock {
namespace {

// As the file has it, but where a table says it plainer.
template <class T>
std::string cell(const T& x) {
  return toml_text(x);
}
std::string cell(const std::string& x) { return x; }
std::string cell(const std::optional<double>& x) { return x ? toml_text(*x) : "worked out"; }
template <class T>
std::string cell(const std::vector<T>& x) {
  return x.empty() ? "empty" : toml_text(x);
}

template <class T>
std::string range(const design::Key& key, const T& value) {
  if constexpr (std::is_enum_v<T>) return choices(value);
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string> || std::is_same_v<T, std::vector<std::string>>) {
    return "";
  } else {
    return fmt::format("{:g} to {:g}", key.low, key.high);
  }
}

}  // namespace

std::string drive_file_reference() {
  std::string page =
      "# The keys of a drive file\n\n"
      "Printed by `steplock keys`; do not edit. The table itself is "
      "`model/design/settings_keys.hpp`.\n\n"
      "A number is in the unit of its column; a text may name another one (`\"188 uH\"`).\n"
      "\"worked out\" means that the design library computes the value if the file is silent\n"
      "(`steplock design FILE` prints what it found).\n";
  std::string section;
  const design::Settings defaults;
  for_each_key(defaults, [&](const design::Key& key, const auto& value) {
    if (section != key.section) {
      section = key.section;
      page += fmt::format("\n## [{}]\n\n| key | unit | default | range | meaning |\n"
                          "|---|---|---|---|---|\n", section);
    }
    page += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name, key.unit,
                        key.required ? "**required**" : cell(value), range(key, value), key.about);
  });
  page += "\n## [motor], as data sheets print it\n\n"
          "Instead of the key named first under its meaning, or beside it: what says the same thing twice has to agree within 10 %. "
          "Where a file is silent on them, inertia and `sensors.limit_a` are estimated, and named as such in the report.\n\n"
          "| key | unit | range | meaning |\n|---|---|---|---|\n";
  const SheetTerms terms;
  for_each_term(terms, [&](const design::Key& key, const auto& value) {
    page += fmt::format("| `{}` | {} | {} | {} |\n", key.name, key.unit, range(key, value), key.about);
  });
  return page;
}

}  // namespace steplock
