// Every key that a drive file does not give, as a comment in its section: what could be written there, and what it is without.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <sstream>
#include <vector>

#include "model/design/settings_keys.hpp"
#include "testbench/drive_file/drive_file.hpp"
#include "testbench/drive_file/key_text.hpp"
#include "testbench/drive_file/sheet_terms.hpp"

namespace steplock {
namespace {

constexpr int kColumn = 36;  // where the meaning begins

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
    const std::string line = fmt::format("# {} = {}", name, toml_text(value));
    const std::string unit = key.unit.empty() ? "" : fmt::format("{}, ", key.unit), config = choices(value);
    comments[section].push_back(fmt::format("{:<{}} # {}{}{}{}", line, kColumn, unit, key.about, config.empty() ? "" : ": ", config));
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
