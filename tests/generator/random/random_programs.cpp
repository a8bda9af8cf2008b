// Writes random blocks, and a block that holds them all: seeds FIRST .. FIRST + COUNT - 1.
//
//     random_programs 1 80 out/random_1        out/random_1.hpp (blocks) and out/random_1.cpp (top)
//
// The same seed gives the same text on every machine.
//
// Doc: docs/generator.md   Test: tests/generator/random/random_test.cpp

#include "tests/generator/random/program.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
  using hlsgen::test::Program;
  if (argc != 4) {
    std::cerr << "usage: random_programs FIRST COUNT STEM\n";
    return 1;
  }
  const int first = std::stoi(argv[1]);
  const int count = std::stoi(argv[2]);
  const std::string stem = argv[3];
  const std::string group = "RandomGroup" + std::to_string(first);

  std::ofstream header(stem + ".hpp");
  header << "#pragma once\n\n#include \"hls/numeric/bits.hpp\"\n\n#include <array>\n\n"
         << "namespace steplock::test {\n\n";
  for (int i = first; i < first + count; ++i) {
    header << Program(static_cast<std::uint64_t>(i), "Random" + std::to_string(i), true).text();
  }
  header << hlsgen::test::group_text(group, first, count) << "}  // namespace steplock::test\n";

  std::ofstream source(stem + ".cpp");
  source << "#include \"" << std::filesystem::path(stem).filename().string() << ".hpp\"\n"
         << "#include \"hls/numeric/block.hpp\"\n\n"
         << "template struct steplock::Synthesize<steplock::test::" << group << ">;\n";
  if (header && source) return 0;
  std::cerr << "random_programs: cannot write " << stem << ".hpp\n";
  return 1;
}
