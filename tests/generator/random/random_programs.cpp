// Writes random blocks, and a block that holds them all: seeds FIRST .. FIRST + COUNT - 1.
//
//     random_programs 1 80 out/random_1        out/random_1.hpp (blocks) and out/random_1.cpp (top)
//
//     random_programs 1 80 out/c_1 compiled            as programs of one datapath each, of clocks yet unknown
//     random_programs 1 80 out/c_1 compiled CLOCKS     of the clocks that hlsgen --schedules found
//
// The same seed gives the same text on every machine.
//
// Doc: docs/generator.md   Test: tests/generator/random/random_test.cpp

#include "tests/generator/random/program.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

namespace {

// "random17: A sample takes 12 clocks, ..." -> 12, in the order of the seeds; 2 where there is no
// such line.
std::vector<int> clocks_of(const std::string& file, int first, int count) {
  std::ifstream lines(file);
  std::map<std::string, int> known;
  for (std::string line; std::getline(lines, line);) {
    const std::string words = ": A sample takes ";
    const auto at = line.find(words);
    if (at == std::string::npos) continue;
    known[line.substr(0, at)] = std::stoi(line.substr(at + words.size()));
  }
  std::vector<int> clocks;
  for (int i = first; i < first + count; ++i) {
    const auto found = known.find("random" + std::to_string(i));
    clocks.push_back(found == known.end() ? 2 : found->second);
  }
  return clocks;
}

}  // namespace

int main(int argc, char** argv) {
  using hlsgen::test::Program;
  if (argc < 4 || argc > 6 || (argc > 4 && std::string(argv[4]) != "compiled")) {
    std::cerr << "usage: random_programs FIRST COUNT STEM [compiled [CLOCKS]]\n";
    return 1;
  }
  const int first = std::stoi(argv[1]);
  const int count = std::stoi(argv[2]);
  const std::string stem = argv[3];
  const bool is_compiled = argc > 4;
  const std::string group = (is_compiled ? "CompiledGroup" : "RandomGroup") + std::to_string(first);

  std::ofstream header(stem + ".hpp");
  header << "#pragma once\n\n#include \"hls/numeric/" << (is_compiled ? "scheduled" : "bits")
         << ".hpp\"\n\n#include <array>\n\nnamespace steplock::test {\n\n";
  for (int i = first; i < first + count; ++i) {
    const std::string name = "Random" + std::to_string(i);
    header << Program(static_cast<std::uint64_t>(i), name, true, is_compiled).text();
  }
  const auto clocks = clocks_of(argc > 5 ? argv[5] : "", first, count);
  header << (is_compiled ? hlsgen::test::compiled_group_text(group, first, clocks)
                         : hlsgen::test::group_text(group, first, count))
         << "}  // namespace steplock::test\n";

  std::ofstream source(stem + ".cpp");
  source << "#include \"" << std::filesystem::path(stem).filename().string() << ".hpp\"\n"
         << "#include \"hls/numeric/block.hpp\"\n\n"
         << "template struct steplock::Synthesize<steplock::test::" << group << ">;\n";
  if (header && source) return 0;
  std::cerr << "random_programs: cannot write " << stem << ".hpp\n";
  return 1;
}
