// What the netlist knows of the source: names, widths, signs, comments, reset values, lines.

#include <algorithm>
#include <fstream>

#include "tests/generator/frontend/against_native.hpp"

namespace hlsgen::test {
namespace {

std::vector<std::string> names_of(const std::vector<Leaf>& leaves) {
  std::vector<std::string> names;
  for (const auto& leaf : leaves) names.push_back(leaf.name);
  return names;
}

std::string line_of(const SourceLine& at) {
  std::ifstream stream(at.file);
  std::string text;
  for (unsigned line = 0; line < at.line; ++line) std::getline(stream, text);
  return text;
}

TEST(Layout, PortsAreTheMembersInTheirOrder) {
  const auto design = design_of("history");
  EXPECT_EQ(names_of(design.modules.back().inputs),
            (std::vector<std::string>{"value", "write", "read", "row", "column", "any", "flag",
                                      "gains[0]", "gains[1]", "gains[2]"}));
}

TEST(Layout, MembersOfMembersFlatten) {
  const auto design = design_of("hierarchy");
  EXPECT_EQ(names_of(design.modules.back().inputs),
            (std::vector<std::string>{"enable", "middle.value", "middle.bypass", "step"}));
}

TEST(Layout, WidthsAndSignsAreThoseOfTheNumbers) {
  const auto design = design_of("plain");
  const auto& inputs = design.modules.back().inputs;
  const auto has = [&](std::size_t i, unsigned width, bool is_signed) {
    return inputs[i].width == width && inputs[i].is_signed == is_signed;
  };
  EXPECT_TRUE(has(0, 8, true));    // std::int8_t
  EXPECT_TRUE(has(1, 8, false));   // std::uint8_t
  EXPECT_TRUE(has(2, 16, true));   // std::int16_t
  EXPECT_TRUE(has(3, 32, false));  // std::uint32_t
  EXPECT_TRUE(has(4, 64, true));   // std::int64_t
  EXPECT_TRUE(has(5, 1, false));   // bool
}

TEST(Layout, EnumerationsKeepTheirNamesAndTakeTheBitsOfTheLargest) {
  const auto design = design_of("state_machine");
  const auto& module = design.modules.back();
  const auto& wish = module.inputs.back();
  ASSERT_GE(wish.enumeration, 0);
  EXPECT_EQ(wish.width, 3U);
  const auto& enumeration = module.enumerations[wish.enumeration];
  EXPECT_EQ(enumeration.name, "Phase6");
  EXPECT_EQ(enumeration.values.back(), (std::pair<std::string, std::uint64_t>{"kBrake", 6}));
}

TEST(Layout, CommentsBehindMembersAreKept) {
  const auto design = design_of("phase_accumulator");
  EXPECT_EQ(design.modules.back().inputs[3].comment, "s0.W, turns per clock");
  EXPECT_EQ(design.modules.back().inputs[1].comment, "");
}

TEST(Layout, DefaultValuesAreResetValues) {
  const auto design = design_of("state_machine");
  const auto& registers = design.modules.back().registers;
  ASSERT_EQ(registers.size(), 3U);
  EXPECT_EQ(registers[1].leaf.name, "timer_");
  EXPECT_EQ(registers[1].reset, 9);
  EXPECT_EQ(registers[2].reset.getSExtValue(), -1);
}

TEST(Layout, InheritedMembersAreRegistersToo) {
  const auto design = design_of("calls");
  const auto& registers = design.modules.back().registers;
  EXPECT_TRUE(std::any_of(registers.begin(), registers.end(), [](const Register& r) {
    return r.leaf.name == "count_" && r.reset == 3;
  }));
}

TEST(Layout, OnlyArgumentsThatDifferFromTheirDefaultsNameTheModule) {
  EXPECT_EQ(design_of("phase_accumulator").modules.back().cpp_class,
            "steplock::test::PhaseAccumulator<24, 0>");
  EXPECT_EQ(design_of("phase_accumulator_12_3").modules.back().cpp_class,
            "steplock::test::PhaseAccumulator<12, 3>");
}

TEST(Layout, ChildrenStandBeforeParentsAndInstancesBearTheirMembersNames) {
  const auto design = design_of("hierarchy");
  std::vector<std::string> modules;
  for (const auto& module : design.modules) modules.push_back(module.name);
  EXPECT_EQ(modules,
            (std::vector<std::string>{"delay_8", "middle", "phase_accumulator_12", "hierarchy"}));
  std::vector<std::string> chain;
  for (const auto& instance : design.modules[1].instances) chain.push_back(instance.name);
  EXPECT_EQ(chain, (std::vector<std::string>{"chain_[0]", "chain_[1]", "chain_[2]"}));
}

TEST(Layout, NodesNameTheLineOfTheBlockThatTheyCameFrom) {
  const auto design = design_of("phase_accumulator");
  const auto& nodes = design.modules.back().nodes;
  const auto sum = std::find_if(nodes.begin(), nodes.end(),
                                [](const Node& node) { return node.op == Op::kAdd; });
  ASSERT_NE(sum, nodes.end());
  EXPECT_EQ(sum->name, "sum");
  EXPECT_NE(line_of(sum->source).find("const auto sum = phase_"), std::string::npos)
      << line_of(sum->source);
}

TEST(Layout, ProductsKeepTheirNarrowOperands) {
  const auto design = design_of("arithmetic");
  const auto& nodes = design.modules.back().nodes;
  bool found = false;
  for (const auto& node : nodes) {
    if (node.op != Op::kMul || node.width != 32) continue;
    found = nodes[node.in[0]].op == Op::kSext && nodes[nodes[node.in[0]].in[0]].width == 16;
  }
  EXPECT_TRUE(found);
}

// What the generated module shows of block Named.
std::string module_of_named() {
  auto design = design_of("named");
  optimise(design);
  return print_module(design, design.modules.back());
}

TEST(Names, ABoolKeepsItsName) {
  EXPECT_NE(module_of_named().find("wire starts = go_i && !hold_i;"), std::string::npos);
}

TEST(Names, AVariableOfAnotherHeaderKeepsItsNameAndItsLine) {
  const auto text = module_of_named();
  const auto steep = text.find(" steep = ");
  ASSERT_NE(steep, std::string::npos) << text;
  EXPECT_EQ(text.substr(text.find("//", steep), 17), "// named_law.hpp:") << text;
}

TEST(Names, WhatAFunctionReturnsIsNamedAfterIt) {
  EXPECT_NE(module_of_named().find(" limit = "), std::string::npos) << module_of_named();
}

TEST(Names, AParameterOfALambdaNamesNothing) {
  EXPECT_EQ(module_of_named().find("yes"), std::string::npos) << module_of_named();
}

TEST(Names, WhatHasNoneIsNamedAfterWhatItIsFor) {
  const auto text = module_of_named();
  EXPECT_NE(text.find(" count_next_both = "), std::string::npos) << text;
}

}  // namespace
}  // namespace hlsgen::test
