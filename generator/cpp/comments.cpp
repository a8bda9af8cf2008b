#include "generator/cpp/comments.hpp"

#include <fstream>
#include <map>

namespace hlsgen {
namespace {

const std::vector<std::string>& lines_of(const std::string& file) {
  static std::map<std::string, std::vector<std::string>> files;
  const auto [entry, is_new] = files.try_emplace(file);
  if (is_new) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) entry->second.push_back(line);
  }
  return entry->second;
}

}  // namespace

std::string comment_at(const SourceLine& line) {
  const auto& lines = lines_of(line.file);
  if (line.line == 0 || line.line > lines.size()) return {};
  const std::string& text = lines[line.line - 1];
  const auto slashes = text.find("//");
  if (slashes == std::string::npos) return {};
  const auto first = text.find_first_not_of("/!< \t", slashes);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> contract_of(const std::string& file) {
  std::vector<std::string> out;
  for (const std::string& line : lines_of(file)) {
    if (line.rfind("//", 0) != 0) break;
    out.push_back(line.substr(line.rfind("// ", 0) == 0 ? 3 : 2));
  }
  return out;
}

}  // namespace hlsgen
