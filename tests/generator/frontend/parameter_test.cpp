// steplock::Parameter: a bool of In to C++ and to the netlist, a parameter of the module in print.

#include "generator/ports.hpp"
#include "tests/generator/frontend/against_native.hpp"
#include "tests/generator/frontend/blocks/parameters.hpp"

namespace hlsgen::test {
namespace {

#define EXPECT_PRINTS(text, line) \
  EXPECT_NE((text).find(line), std::string::npos) << "no `" << (line) << "` in\n" << (text)

Design parted() {
  auto design = design_of("parted_counters");
  optimise(design);
  check(design);
  return design;
}

// Both values, from clock to clock.
TEST(Parameter, TheNetlistEqualsItsCpp) {
  expect_equal_to_native<steplock::test::PartedCounters>("parted_counters");
}

TEST(Parameter, TheModuleDeclaresItWithItsDefaultAndComment) {
  const auto design = parted();
  const auto text = print_module(design, design.modules.front());
  EXPECT_PRINTS(text, "module counted #(\n"
                      "    parameter logic COUNTS = 1'b1,\n"
                      "    parameter logic DOUBLES = 1'b0  // two for each event\n"
                      ") (\n"
                      "    input  logic       clk,");
  EXPECT_EQ(text.find("counts_i"), std::string::npos);
}

TEST(Parameter, AnInstanceIsGivenTheParentsOwnOrAConstant) {
  const auto design = parted();
  const auto text = print_module(design, design.modules.back());
  EXPECT_PRINTS(text, "    parameter logic WITH_FIRST = 1'b1  // the first counter\n");
  EXPECT_PRINTS(text, "  counted #(.COUNTS(WITH_FIRST), .DOUBLES(1'b0)) first (\n");
  EXPECT_PRINTS(text, "  counted #(.COUNTS(1'b1), .DOUBLES(1'b1)) second (\n");
  EXPECT_PRINTS(text, "assign both_o = ");
}

TEST(Parameter, ThePlainPrintHasTheSame) {
  const auto design = parted();
  EXPECT_PRINTS(print_plain(design, design.modules.front()),
                "module counted #(parameter COUNTS = 1, parameter DOUBLES = 0) (\n");
  const auto text = print_plain(design, design.modules.back());
  EXPECT_PRINTS(text, "  counted #(.COUNTS(WITH_FIRST), .DOUBLES(1'b0)) first (");
  EXPECT_PRINTS(text, "  counted #(.COUNTS(1'b1), .DOUBLES(1'b1)) second (");
}

TEST(Parameter, AnotherClassOfThatNameIsPorts) {
  expect_equal_to_native<steplock::test::OwnParameter<3>>("own_parameter_3");
  const auto design = design_of("own_parameter_3");
  const auto& gain = design.modules.back().inputs.front();
  EXPECT_FALSE(gain.parameter);
  EXPECT_EQ(gain.name, "gain.value");
  EXPECT_EQ(gain.width, 8U);
}

// The Verilated model has no port for it.
TEST(Parameter, LockstepLeavesItAsItIs) {
  const auto design = parted();
  const auto text = print_ports(design.modules.back());
  EXPECT_EQ(text.find("with"), std::string::npos);
  EXPECT_EQ(text.find("WITH"), std::string::npos);
  EXPECT_PRINTS(text, "set_port(rtl.event_i, word_of(in.event, 1));");
}

}  // namespace
}  // namespace hlsgen::test
