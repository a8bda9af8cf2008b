// Prints random netlists both ways, for proof and linters:
//
//     random_netlists COUNT OPERATORS DIRECTORY
//
// writes DIRECTORY/rtl/random_<seed>.sv and .f, and DIRECTORY/plain/random_<seed>.sv.

#include "generator/backend.hpp"
#include "tests/generator/random_netlist.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: random_netlists COUNT OPERATORS DIRECTORY\n";
    return 1;
  }
  const std::filesystem::path directory = argv[3];
  std::filesystem::create_directories(directory / "rtl");
  std::filesystem::create_directories(directory / "plain");
  for (int seed = 0; seed < std::atoi(argv[1]); ++seed) {
    hlsgen::Design design;
    const std::string name = "random_" + std::to_string(seed);
    const auto operators = static_cast<unsigned>(std::atoi(argv[2]));
    design.modules.push_back(
        hlsgen::test::RandomNetlist(static_cast<unsigned>(seed)).make(name, operators));
    hlsgen::optimise(design);
    hlsgen::check(design);
    const hlsgen::Module& module = design.modules[0];
    std::ofstream(directory / "rtl" / (name + ".sv")) << hlsgen::print_module(design, module);
    std::ofstream(directory / "rtl" / (name + ".f")) << hlsgen::print_file_list(design);
    std::ofstream(directory / "plain" / (name + ".sv")) << hlsgen::print_plain(design, module);
  }
}
