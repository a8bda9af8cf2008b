// Prints docs/drive_file.md from the table of keys.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/design/settings_keys.hpp"
#include "testbench/drive_file/drive_file.hpp"
#include "testbench/drive_file/sheet_terms.hpp"

namespace steplock {
namespace {

std::string cell(double x) { return fmt::format("{:g}", x); }
std::string cell(int x) { return fmt::format("{}", x); }
std::string cell(bool x) { return x ? "true" : "false"; }
std::string cell(const std::string& x) { return x; }
std::string cell(const std::optional<double>& x) { return x ? cell(*x) : "worked out"; }
std::string cell(const std::array<double, 3>& x) {
  return fmt::format("[{:g}, {:g}, {:g}]", x[0], x[1], x[2]);
}
std::string cell(const std::array<double, 2>& x) { return fmt::format("[{:g}, {:g}]", x[0], x[1]); }
template <class T>
std::string cell(const std::vector<T>& x) {
  if (x.empty()) return "empty";
  return fmt::format("[{}]", fmt::join(x, ", "));
}
template <class E>
  requires std::is_enum_v<E>
std::string cell(E x) {
  return fmt::format("\"{}\"", enum_words(E{})[static_cast<std::size_t>(x)]);
}

template <class E>
std::string choices() {
  std::string all;
  for (const char* word : enum_words(E{})) all += fmt::format("{}{}", all.empty() ? "" : ", ", word);
  return all;
}

template <class T>
std::string range(const design::Key& key, const T&) {
  if constexpr (std::is_enum_v<T>) return choices<T>();
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string> ||
                std::is_same_v<T, std::vector<std::string>>) {
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
