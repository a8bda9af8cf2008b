#include "generator/cpp/comments.hpp"

#include <fstream>
#include <map>
#include <vector>

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

}  // namespace hlsgen
