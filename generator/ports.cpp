#include "generator/ports.hpp"

#include <fmt/format.h>

#include "generator/names.hpp"

namespace hlsgen {
namespace {

constexpr const char* kHeader = R"(// Ports of module {module}, from {file}.
// Printed by hlsgen; do not edit.

#pragma once

#include "generator/port_words.hpp"

namespace steplock::ports::{module} {{

)";

std::string drive(const Module& module) {
  std::string text =
      "template <class Rtl, class In>\n"
      "void drive_ports([[maybe_unused]] Rtl& rtl, [[maybe_unused]] const In& in) {\n";
  for (const auto& leaf : module.inputs) {
    if (leaf.parameter) continue;  // nothing to drive: the model was built with a value
    text += fmt::format("  set_port(rtl.{}, word_of(in.{}, {}));\n",
                        port_name(leaf, Direction::kIn), leaf.name, leaf.width);
  }
  return text + "}\n\n";
}

std::string compare(const Module& module) {
  std::string text =
      "// The first output port that differs, or null.\n"
      "template <class Rtl, class Out>\n"
      "const char* differs([[maybe_unused]] const Rtl& rtl, [[maybe_unused]] const Out& out) {\n";
  for (const auto& output : module.outputs) {
    const auto port = port_name(output.leaf, Direction::kOut);
    text += fmt::format("  if (word_at(rtl.{0}) != word_of(out.{1}, {2})) return \"{0}\";\n", port,
                        output.leaf.name, output.leaf.width);
  }
  return text + "  return nullptr;\n}\n\n";
}

std::string random(const Module& module) {
  std::string text =
      "// Stimulus::bits(width) gives a number of so many bits.\n"
      "template <class In, class Stimulus>\n"
      "void randomise([[maybe_unused]] In& in, [[maybe_unused]] Stimulus& stimulus) {\n";
  for (const auto& leaf : module.inputs) {
    if (leaf.parameter) continue;
    if (leaf.enumeration < 0) {
      text += fmt::format("  set_number(in.{}, stimulus.bits({}));\n", leaf.name, leaf.width);
      continue;
    }
    const auto& values = module.enumerations[leaf.enumeration].values;
    std::string list;
    for (const auto& value : values) {
      list += (list.empty() ? "" : ", ") + std::to_string(value.second);
    }
    text += fmt::format(
        "  {{\n    constexpr unsigned long long values[] = {{{}}};\n"
        "    set_number(in.{}, values[stimulus.bits({}) % {}]);\n  }}\n",
        list, leaf.name, leaf.width, values.size());
  }
  return text + "}\n\n";
}

}  // namespace

std::string print_ports(const Module& module) {
  return fmt::format(kHeader, fmt::arg("module", module.name),
                     fmt::arg("file", module.source.file)) +
         drive(module) + compare(module) + random(module) +
         fmt::format("}}  // namespace steplock::ports::{}\n", module.name);
}

}  // namespace hlsgen
