// A module around six_step_bare (docs/blocks/six_step_bare.md) whose words are constants.
#include <fmt/format.h>

#include <string_view>

#include "testbench/registers/registers.hpp"

namespace steplock::registers {
namespace {

// What the compiler calls the way to a word, such as "&steplock::Words::pwm, &steplock::PwmWords::period".
template <auto... Path>
constexpr std::string_view path_name(At<Path...>) {
  return __PRETTY_FUNCTION__;
}

// "words_pwm_period": each member's own name, as in the ports of the RTL.
template <class Place>
std::string port_name() {
  constexpr std::string_view path = path_name(Place{});
  std::string name = "words";
  for (std::size_t at = path.find('&'); at != path.npos; at = path.find('&', at + 1)) {
    const std::size_t end = path.find_first_of(",>})];", at);
    const std::size_t begin = path.rfind("::", end) + 2;
    name += fmt::format("_{}", path.substr(begin, end - begin));
  }
  return name;
}

constexpr const char* kPins[] = {"comparator_u", "comparator_v", "comparator_w", "limit",
                                 "fault",        "hall_u",       "hall_v",       "hall_w"};
constexpr const char* kGates[] = {"uh", "ul", "vh", "vl", "wh", "wl"};
constexpr const char* kShown[] = {"locked", "fault", "turn"};

}  // namespace

std::string words_verilog(const Words& words, const std::string& name, double clock_hz) {
  std::string ports, wires;
  const auto port = [&](const char* direction, const std::string& range, const std::string& port) {
    ports += fmt::format(",\n    {} logic {}{}", direction, range, port);
    wires += fmt::format(",\n      .{0}({0})", port);
  };
  for (const char* pin : kPins) port("input ", "", fmt::format("pins_{}_i", pin));
  port("input ", "", "controls_run_i");
  port("input ", "", "controls_reverse_i");
  port("input ", "[1:0] ", "controls_speed_i");
  port("input ", "", "brake_to_stop_i");
  for (const char* gate : kGates) port("output", "", fmt::format("gates_{}_o", gate));
  for (const char* shown : kShown) port("output", "", fmt::format("{}_o", shown));

  const auto tie = [&](const auto& row) {
    using Word = typename std::remove_cvref_t<decltype(row)>::Word;
    const auto value = static_cast<std::uint32_t>(bits_of(Word::of(words)).raw());
    wires += fmt::format(",\n      .{}_i({}'d{})", port_name<Word>(), row.width, value);
  };
  std::apply([&](const auto&... row) { (tie(row), ...); }, kWordRows);

  return fmt::format(
      "// six_step_fixed: the drive {0} without a host, at a clock of {1:.0f} Hz.\n"
      "// Printed by `steplock design {0}.toml --verilog`; ports: docs/blocks/six_step_bare.md.\n\n"
      "module six_step_fixed (\n    input  logic clk,\n    input  logic rst{2}\n);\n"
      "  six_step_bare drive (\n      .clk(clk),\n      .rst(rst){3}\n  );\nendmodule\n",
      name, clock_hz, ports, wires);
}

}  // namespace steplock::registers
