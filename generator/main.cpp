// hlsgen: C++ blocks in, SystemVerilog out.
//
//     hlsgen hls/six_step/vco_counter.cpp -o build/rtl
//
// Exit code: 0 done, 1 the source was refused or a file could not be written (one line says why,
// and nothing has changed), 2 a fault of hlsgen itself, above 100 a wrong command line.

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "generator/backend.hpp"
#include "generator/dump.hpp"
#include "generator/faults.hpp"
#include "generator/files.hpp"
#include "generator/front_end.hpp"
#include "generator/ports.hpp"
#include "generator/refusal.hpp"

namespace {

struct Options {
  hlsgen::FrontEndOptions front_end;
  std::string rtl, ports, plain, depfile;
  bool dump = false;
  bool schedules = false;
};

Options parse(int argc, char** argv) {
  Options options;
  CLI::App app{
      "C++ blocks in, SystemVerilog out.\n"
      "Example: hlsgen hls/six_step/vco_counter.cpp -o build/rtl --ports build/ports"};
  app.set_version_flag("--version", "hlsgen " STEPLOCK_VERSION, "Print the version");
  auto& compile = options.front_end.compile;
  app.add_option("source", compile.source,
                 "C++ source with one line `template struct steplock::Synthesize<Class>;`")
      ->required();
  app.add_option("-o", options.rtl, "Directory for <module>.sv and <top>.f");
  app.add_option("--top", options.front_end.top, "Class or module, when the source names several");
  app.add_option("-I", compile.include_directories, "Where #include looks (default: .)");
  app.add_option("--ports", options.ports, "Directory for <module>_ports.hpp");
  app.add_option("--plain", options.plain, "Directory for the second, plain print, for proofs");
  app.add_option("--depfile", options.depfile, "Write make rules for <top>.f, of all files read");
  app.add_flag("--schedules", options.schedules,
               "Print what each scheduled block takes");
  app.add_flag("--any-clocks", options.front_end.any_clocks,
               "Let schedules take other clocks than the source says: to find out how many");
  app.add_flag("--dump-netlist", options.dump, "Print the netlist");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  if (compile.include_directories.empty()) compile.include_directories.push_back(".");
  return options;
}

void run(const Options& options) {
  const auto stem = std::filesystem::path(options.front_end.compile.source).stem().string();
  hlsgen::working_on("reading the C++");
  auto [design, read, schedules] = hlsgen::build_design(options.front_end);
  hlsgen::working_on("simplifying the netlist");
  hlsgen::check(design);
  hlsgen::optimise(design);
  hlsgen::check(design);

  std::map<std::string, std::string> files;
  for (const auto& module : design.modules) {
    hlsgen::working_on("writing " + module.name);
    if (!options.rtl.empty()) {
      files[options.rtl + "/" + module.name + ".sv"] = hlsgen::print_module(design, module);
    }
    if (!options.plain.empty()) {
      files[options.plain + "/" + module.name + ".sv"] = hlsgen::print_plain(design, module);
    }
    if (!options.ports.empty()) {
      files[options.ports + "/" + module.name + "_ports.hpp"] = hlsgen::print_ports(module);
    }
  }
  if (!options.rtl.empty()) {
    files[options.rtl + "/" + stem + ".f"] = hlsgen::print_file_list(design);
  }
  if (!options.depfile.empty()) {
    auto& rules = files[options.depfile];
    rules = options.rtl + "/" + stem + ".f:";
    for (const auto& file : read) rules += " \\\n  " + file;
    rules += "\n";
  }
  hlsgen::write_files(files);
  if (options.schedules) {
    for (const auto& report : schedules) {
      std::cout << report.module << ": " << fmt::to_string(fmt::join(report.lines(), " ")) << "\n";
    }
  }
  if (options.dump) std::cout << hlsgen::dump(design);
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = parse(argc, argv);
  hlsgen::name_faults(options.front_end.compile.source);
  try {
    run(options);
  } catch (const hlsgen::Refusal& refusal) {
    std::cerr << refusal.what() << "\n";
    return 1;
  } catch (const std::exception& fault) {
    std::cerr << "hlsgen: internal error: " << fault.what() << "; please report it\n";
    return 2;
  }
  return 0;
}
