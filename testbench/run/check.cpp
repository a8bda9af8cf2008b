#include "testbench/run/check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/design/design.hpp"
#include "model/design/settings_keys.hpp"
#include "model/design/sinusoidal/config.hpp"

namespace steplock {
namespace {

// The line of the key that a complaint begins with.  The plant's names lack the unit suffix; a key
// that the file does not set stands for its section.
int line_of(const DriveFile& file, const std::string& complaint) {
  const std::string key = complaint.substr(0, complaint.find_first_of(" :[="));
  if (const auto exact = file.line_of.find(key); exact != file.line_of.end()) return exact->second;
  const auto near = file.line_of.lower_bound(key + "_");
  if (near != file.line_of.end() && near->first.starts_with(key + "_")) return near->second;
  const auto section = file.line_of.find(key.substr(0, key.find('.')));
  return section != file.line_of.end() ? section->second : 1;
}

}  // namespace

void check_drive_file(const DriveFile& file) {
  const design::Settings& s = file.settings;
  std::vector<std::string> complaints = plant::validate(plant_parameters(s));
  std::ranges::copy(design::problems(s), std::back_inserter(complaints));
  if (complaints.empty()) return;
  std::vector<std::pair<int, std::string>> lines;
  for (const std::string& c : complaints) lines.emplace_back(line_of(file, c), c);
  std::ranges::stable_sort(lines, {}, &std::pair<int, std::string>::first);
  std::string all;
  for (const auto& [line, text] : lines) {
    all += fmt::format("{}{}:{}: {}", all.empty() ? "" : "\n", file.path, line, text);
  }
  throw BadInput(all);
}

void check_config(const DriveFile& file) {
  const auto config = design::sinusoidal::quantise(file.settings);
  if (config.problems.empty()) return;
  throw BadInput(fmt::format("{}:{}: {}", file.path, file.line_of.at("drive.kind"), config.problems.front()));
}

void require_kind(const DriveFile& file, design::DriveKind kind, const std::string& what) {
  const design::DriveKind is = file.settings.drive.kind;
  if (is == kind) return;
  const auto word = [](design::DriveKind k) {
    return enum_words(k)[static_cast<std::size_t>(k)];
  };
  const auto line = file.line_of.find("drive.kind");
  throw BadInput(fmt::format("{}:{}: drive.kind is \"{}\"; {} serves \"{}\" drives alone, name one",
                             file.path, line == file.line_of.end() ? 1 : line->second, word(is), what,
                             word(kind)));
}

std::vector<DriveFile> open_files_of(design::DriveKind kind, const std::vector<std::string>& paths,
                                     const std::string& what) {
  const bool six_step = kind == design::DriveKind::kSixStep;
  std::vector<DriveFile> files;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    DriveFile file = open_drive_file(paths[k]);
    if (file.settings.drive.kind == kind) {
      files.push_back(std::move(file));
    } else if (k + 1 == paths.size() && files.empty()) {
      require_kind(file, kind, what);
    } else {
      fmt::print(stderr, "steplock: {} is no {} drive; {} leaves it out\n", paths[k],
                 six_step ? "six-step" : "sinusoidal", what);
    }
  }
  return files;
}

std::vector<DriveFile> open_six_step_files(const std::vector<std::string>& paths,
                                           const std::string& what) {
  return open_files_of(design::DriveKind::kSixStep, paths, what);
}

design::DriveKind kind_among(const std::vector<std::string>& paths) {
  const bool six_step = std::ranges::any_of(paths, [](const std::string& path) {
    return load_drive_file(path).settings.drive.kind == design::DriveKind::kSixStep;
  });
  return six_step ? design::DriveKind::kSixStep : design::DriveKind::kSinusoidal;
}

DriveFile open_drive_file(const std::string& path) {
  DriveFile file = load_drive_file(path);
  check_drive_file(file);
  return file;
}

}  // namespace steplock
