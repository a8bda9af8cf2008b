#include "generator/dump.hpp"
#include "generator/front_end.hpp"
#include "generator/refusal.hpp"

#include <CLI/CLI.hpp>

#include <iostream>

int main(int argc, char** argv) {
  CLI::App app{"hlsgen: C++ blocks in, SystemVerilog out"};
  hlsgen::FrontEndOptions options;
  bool dump_netlist = false;
  app.add_option("source", options.compile.source)->required();
  app.add_option("-I", options.compile.include_directories);
  app.add_option("--top", options.top);
  app.add_flag("--dump-netlist", dump_netlist);
  CLI11_PARSE(app, argc, argv);
  try {
    const auto design = hlsgen::build_design(options);
    if (dump_netlist) std::cout << hlsgen::dump(design);
  } catch (const hlsgen::Refusal& refusal) {
    std::cerr << refusal.what() << "\n";
    return 1;
  }
}
