#include "generator/files.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

namespace fs = std::filesystem;

bool holds(const std::string& path, const std::string& text) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream present;
  present << stream.rdbuf();
  return stream && present.str() == text;
}

}  // namespace

void write_files(const std::map<std::string, std::string>& files) {
  // All texts go beside their places first, so that a full disk leaves the old files.
  std::map<std::string, std::string> beside;
  for (const auto& [path, text] : files) {
    if (holds(path, text)) continue;
    std::error_code error;
    fs::create_directories(fs::path(path).parent_path(), error);
    const std::string temporary = path + "." + std::to_string(::getpid());
    std::ofstream stream(temporary, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) {
      fs::remove(temporary, error);
      for (const auto& [written, place] : beside) fs::remove(written, error);
      throw Refusal({path, 0}, "cannot be written", "check that the directory exists and has room");
    }
    beside[temporary] = path;
  }
  for (const auto& [temporary, path] : beside) fs::rename(temporary, path);
}

}  // namespace hlsgen
