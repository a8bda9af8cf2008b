#include "generator/faults.hpp"

#include <fmt/format.h>
#include <llvm/Support/ErrorHandling.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>

namespace hlsgen {
namespace {

// Made beforehand: a handler of signals must not allocate.
struct Line {
  std::array<char, 1024> head, tail;
};
Line line;

void keep(std::array<char, 1024>& place, const std::string& text) {
  const std::size_t length = std::min(text.size(), place.size() - 1);
  std::memcpy(place.data(), text.data(), length);
  place[length] = 0;
}

[[noreturn]] void end(const char* what) {
  for (const char* part : {static_cast<const char*>(line.head.data()), what, static_cast<const char*>(line.tail.data())}) {
    if (write(STDERR_FILENO, part, std::strlen(part)) < 0) break;
  }
  _exit(2);
}

void on_signal(int signal) {
  end(signal == SIGABRT ? "it was aborted" : signal == SIGFPE ? "it divided by zero" : "it used a bad address");
}

// LLVM's reason may have several lines.
void on_fatal_error(void*, const char* reason, bool) {
  static std::array<char, 512> text;
  std::strncpy(text.data(), "LLVM: ", text.size() - 1);
  std::strncat(text.data(), reason, text.size() - std::strlen(text.data()) - 1);
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  end(text.data());
}

}  // namespace

void name_faults(const std::string& source) {
  keep(line.head, fmt::format("hlsgen: internal error: {}: ", source));
  working_on("starting");
  llvm::install_fatal_error_handler(on_fatal_error);
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGILL, SIGFPE}) std::signal(signal, on_signal);
}

void working_on(const std::string& what) {
  keep(line.tail, fmt::format(", while {}; please report it with this source\n", what));
}

}  // namespace hlsgen
