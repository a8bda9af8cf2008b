// Every key that a drive file does not give, as a comment in its section: what could be written there, and what it is without.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <sstream>
#include <vector>

#include "model/design/settings_keys.hpp"
#include "testbench/drive_file/drive_file.hpp"
#include "testbench/drive_file/sheet_terms.hpp"

namespace steplock {
namespace {

constexpr int kColumn = 36;  // where the meaning begins

std::string toml(double x) { return fmt::format("{:g}", x); }
std::string toml(int x) { return fmt::format("{}", x); }
std::string toml(bool x) { return x ? "true" : "false"; }
std::string toml(const std::string& x) { return fmt::format("\"{}\"", x); }
std::string toml(const std::optional<double>& x) { return x ? toml(*x) : ""; }
template <class T, std::size_t N>
std::string toml(const std::array<T, N>& x) {
  return fmt::format("[{:g}]", fmt::join(x, ", "));
}
std::string toml(const std::vector<double>& x) { return fmt::format("[{:g}]", fmt::join(x, ", ")); }
std::string toml(const std::vector<std::string>& x) { return x.empty() ? "[]" : fmt::format("[\"{}\"]", fmt::join(x, "\", \"")); }
template <class E>
  requires std::is_enum_v<E>
std::string toml(E x) {
  return fmt::format("\"{}\"", design::enum_words(E{})[static_cast<std::size_t>(x)]);
}

template <class T>
std::string choices(const T&) {
  if constexpr (std::is_enum_v<T>) return fmt::format(": {}", fmt::join(design::enum_words(T{}), ", "));
  return "";
}

// `[section]`s with their lines; what stands before the first one is that of "".
using Sections = std::vector<std::pair<std::string, std::vector<std::string>>>;

Sections sections_of(const std::string& text) {
  Sections sections = {{"", {}}};
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('[')) {
      sections.push_back({line.substr(1, line.find(']') - 1), {}});
    } else {
      sections.back().second.push_back(line);
    }
  }
  return sections;
}

}  // namespace

std::string with_every_key(const std::string& text, const std::string& path) {
  const DriveFile file = parse_drive_file(text, path);
  std::map<std::string, std::vector<std::string>> comments;
  std::vector<std::string> order;
  const auto comment = [&](const design::Key& key, const auto& value) {
    const std::string section(key.section), name(key.name);
    if (comments.try_emplace(section).second) order.push_back(section);
    const design::DriveKind kind = file.settings.drive.kind;
    if (file.line_of.contains(section + "." + name)) return;
    if (!design::belongs(section, kind) || !design::belongs(section, name, kind)) return;
    const std::string line = fmt::format("# {} = {}", name, toml(value));
    const std::string unit = key.unit.empty() ? "" : fmt::format("{}, ", key.unit);
    comments[section].push_back(fmt::format("{:<{}} # {}{}{}", line, kColumn, unit, key.about, choices(value)));
  };
  const design::Settings defaults;
  for_each_key(defaults, comment);
  const SheetTerms none;
  for_each_term(none, comment);

  std::string all;
  const auto put = [&](const std::vector<std::string>& lines) {
    for (const std::string& line : lines) all += line + "\n";
  };
  std::map<std::string, std::vector<std::string>> given;
  for (auto& [section, lines] : sections_of(text)) {
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    given[section] = std::move(lines);
  }
  put(given[""]);
  all += "# A line that begins with # and a key is that key's default, or nothing where the design library works it out.\n";
  for (const std::string& section : order) {
    if (!given.contains(section) && comments[section].empty()) continue;
    all += fmt::format("\n[{}]\n", section);
    put(given[section]);
    put(comments[section]);
  }
  return all;
}

}  // namespace steplock
