// Modules around six_step_standalone and sinusoidal_standalone (docs/blocks/) whose words are constants.
#include <fmt/format.h>

#include "testbench/engine/word_name.hpp"
#include "testbench/registers/registers.hpp"

namespace steplock::registers {
namespace {

constexpr const char* kPins[] = {"comparator_u", "comparator_v", "comparator_w", "limit",
                                 "fault",        "hall_u",       "hall_v",       "hall_w"};
constexpr const char* kGates[] = {"uh", "ul", "vh", "vl", "wh", "wl"};
constexpr const char* kShown[] = {"locked", "fault", "turn"};
constexpr const char* kConverterPins[] = {"cs_n", "sclk", "mosi"};

// A module around another one: what is passed through, and what is tied.
class FixedModule {
 public:
  void port(const char* direction, const std::string& range, const std::string& port) {
    ports_ += fmt::format(",\n    {} logic {}{}", direction, range, port);
    wires_ += fmt::format(",\n      .{0}({0})", port);
  }
  void tie(const std::string& port, int width, std::uint64_t value) {
    wires_ += fmt::format(",\n      .{}({}'d{})", port, width, value);
  }
  // A parameter of the drive inside.
  void part(const char* parameter, bool there) {
    parts_ += fmt::format("{}.{}({})", parts_.empty() ? "" : ", ", parameter, there ? 1 : 0);
  }
  // What pins have in common in every drive without a host.
  void controls_and_gates() {
    port("input ", "", "controls_run_i");
    port("input ", "", "controls_reverse_i");
    port("input ", "[1:0] ", "controls_speed_i");
    port("input ", "", "brake_to_stop_i");
    for (const char* gate : kGates) port("output", "", fmt::format("gates_{}_o", gate));
    for (const char* shown : kShown) port("output", "", fmt::format("{}_o", shown));
  }
  // `kind`_fixed around `kind`_standalone.
  std::string text(const char* kind, const std::string& name, double clock_hz) const {
    return fmt::format(
        "// {0}_fixed: the drive {1} without a host, at a clock of {2:.0f} Hz.\n"
        "// Printed by `steplock design {1}.toml --verilog`; ports: docs/blocks/{0}_standalone.md.\n\n"
        "module {0}_fixed (\n    input  logic clk,\n    input  logic rst{3}\n);\n"
        "  {0}_standalone {5}drive (\n      .clk(clk),\n      .rst(rst){4}\n  );\nendmodule\n",
        kind, name, clock_hz, ports_, wires_, parts_.empty() ? "" : fmt::format("#({}) ", parts_));
  }

 private:
  std::string ports_, wires_, parts_;
};

// Every word of a drive, at the port that is called after it.
template <class Table>
void tie_config(FixedModule& module, const typename Table::Config& config) {
  const auto tie = [&](const auto& row) {
    using Word = typename std::remove_cvref_t<decltype(row)>::Word;
    const auto value = static_cast<std::uint32_t>(bits_of(Word::of(config)).raw());
    module.tie("config_" + word_name<Word>('_') + "_i", row.width, value);
  };
  std::apply([&](const auto&... row) { (tie(row), ...); }, Table::kWordRows);
}

}  // namespace

std::string config_verilog(const SixStepConfig& config, const std::string& name, double clock_hz) {
  FixedModule module;
  for (const char* pin : kPins) module.port("input ", "", fmt::format("pins_{}_i", pin));
  module.controls_and_gates();
  // Without Hall sensors, and without a look for a rotor that turns, nothing asks the decoder.
  module.part("WITH_HALL_DECODER", config.source == Source::kHall || config.start.detect_spin != Ticks(0));
  const bool follows = config.start.method == Method::kFollow;
  module.part("WITH_RAMP", !follows);
  module.part("WITH_FOLLOWER", follows);
  tie_config<SixStep>(module, config);
  return module.text("six_step", name, clock_hz);
}

std::string config_verilog(const SinusoidalConfig& config, const SpiAdcConfig& adc_config,
                          const std::string& name, double clock_hz) {
  FixedModule module;
  module.port("input ", "", "pins_fault_i");
  module.port("input ", "", "pins_miso_i");
  module.controls_and_gates();
  for (const char* pin : kConverterPins) module.port("output", "", fmt::format("{}_o", pin));
  const auto number = [](auto word) { return static_cast<std::uint64_t>(word.raw()); };
  module.tie("adc_half_i", 6, number(adc_config.half));
  module.tie("adc_quiet_i", 8, number(adc_config.quiet));
  module.tie("adc_u_i", 3, number(adc_config.u));
  module.tie("adc_v_i", 3, number(adc_config.v));
  module.tie("adc_dc_i", 3, number(adc_config.dc));
  module.tie("adc_twice_i", 1, adc_config.twice ? 1 : 0);
  tie_config<Sinusoidal>(module, config);
  return module.text("sinusoidal", name, clock_hz);
}

}  // namespace steplock::registers
