// How many instructions a part of a program takes: Valgrind counts them.
//
//     A program that wants to be counted calls counted(work) for some arguments of its own, and
//     instructions(arguments) for others: that runs this very program under Valgrind.
//
// Test: tests/tools/CMakeLists.txt (no_engine_takes_more_instructions)
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <regex>
#include <stdexcept>
#include <string>

namespace steplock {

// All that is counted.
[[gnu::noinline]] inline void counted(void (*work)()) {
  work();
  asm volatile("");  // nothing may be called in its place
}

// Of counted() in this program with these arguments; throws std::runtime_error where Valgrind tells no number.
inline double instructions(const std::string& arguments) {
  const std::string program = "/proc/" + std::to_string(getpid()) + "/exe";
  const std::string command = "valgrind --tool=callgrind --callgrind-out-file=/dev/null --collect-atstart=no "
                              "'--toggle-collect=*counted(*' " + program + " " + arguments + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("no shell can be started");
  std::string said;
  char some[4096];
  while (const std::size_t n = std::fread(some, 1, sizeof some, pipe)) said.append(some, n);
  const int status = pclose(pipe);
  std::smatch found;
  if (status >> 8 == 127) throw std::runtime_error("valgrind is not here; tools/setup installs it");
  if (status != 0 || !std::regex_search(said, found, std::regex("Collected : ([0-9]+)"))) {
    throw std::runtime_error(fmt::format("'{}' counts nothing: {}", command, said.substr(0, 600)));
  }
  return std::stod(found[1]);
}

}  // namespace steplock
