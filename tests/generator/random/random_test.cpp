// Random programs in four forms, clock by clock: the C++ as g++ compiled it, its netlist before and
// after the passes, and the printed SystemVerilog as Verilator compiled it.
//
// A port is named after its block: p17_y0_o is output y0 of the block with seed 17.

#include <gtest/gtest.h>

#include "generator/backend.hpp"
#include "generator/front_end.hpp"
#include "generator/interpret.hpp"
#include "testbench/stimulus.hpp"
#include "tests/generator/random/group.hpp"

namespace hlsgen::test {
namespace {

using steplock::ports::masked;

const Design& as_read() {
  static const Design design = [] {
    FrontEndOptions options;
    options.compile.source = kGroupSource;
    options.compile.include_directories = {HLSGEN_ROOT};
    return build_design(options).design;
  }();
  return design;
}

const Module& top() { return as_read().modules.back(); }

Words any_inputs(steplock::Stimulus& any) {
  any.next();
  Words in;
  for (const Leaf& leaf : top().inputs) {
    auto word = any.bits(static_cast<int>(leaf.width));
    if (leaf.enumeration >= 0) {
      const auto& values = top().enumerations[leaf.enumeration].values;
      word = values[static_cast<std::size_t>(word) % values.size()].second;
    }
    in.push_back(word);
  }
  return in;
}

std::vector<llvm::APInt> numbers_of(const Words& words) {
  std::vector<llvm::APInt> numbers;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::uint64_t halves[] = {static_cast<std::uint64_t>(words[i]),
                                    static_cast<std::uint64_t>(words[i] >> 64)};
    numbers.push_back(llvm::APInt(128, halves).trunc(top().inputs[i].width));
  }
  return numbers;
}

// The first output in which a netlist differs from the C++, or null.
const std::string* first_difference(const std::vector<llvm::APInt>& netlist, const Words& cpp) {
  for (std::size_t i = 0; i < cpp.size(); ++i) {
    const Leaf& leaf = top().outputs[i].leaf;
    const auto value = netlist[i].zext(128);
    const auto word = steplock::ports::Word{value.extractBitsAsZExtValue(64, 64)} << 64 |
                      value.extractBitsAsZExtValue(64, 0);
    if (word != masked(cpp[i], static_cast<int>(leaf.width))) return &leaf.name;
  }
  return nullptr;
}

// The first clock in which the netlist and the C++ differ, or `clocks`.
int netlist_differs(const Design& design, int clocks, int wrong_clock, std::string& where) {
  Interpreter netlist(design);
  const auto forms = make_forms();
  steplock::Stimulus any(1);
  for (int clock = 0; clock < clocks; ++clock) {
    const Words in = any_inputs(any);
    const char* unused = nullptr;
    Words cpp = forms->clock(in, false, unused);
    if (clock == wrong_clock) cpp.front() ^= 1;
    if (const auto* name = first_difference(netlist.clock(numbers_of(in)), cpp)) {
      where = *name;
      return clock;
    }
  }
  return clocks;
}

// The first clock in which the print and the C++ differ, or `clocks`.
int print_differs(int clocks, int wrong_clock, std::string& where) {
  const auto forms = make_forms();
  steplock::Stimulus any(2);
  for (int clock = 0; clock < clocks; ++clock) {
    const char* differing = nullptr;
    forms->clock(any_inputs(any), clock == wrong_clock, differing);
    if (differing == nullptr) continue;
    where = differing;
    return clock;
  }
  return clocks;
}

constexpr int kNever = -1;

TEST(Random, NetlistsEqualTheirCpp) {
  const int kClocks = 100 * kPace;
  std::string where;
  ASSERT_NO_THROW(check(as_read()));
  EXPECT_EQ(netlist_differs(as_read(), kClocks, kNever, where), kClocks) << where;
  Design optimised = as_read();
  optimise(optimised);
  ASSERT_NO_THROW(check(optimised));
  EXPECT_EQ(netlist_differs(optimised, kClocks, kNever, where), kClocks) << "optimised: " << where;
}

TEST(Random, PrintsEqualTheirCpp) {
  const int clocks = 5'000 * kPace;
  std::string where;
  EXPECT_EQ(print_differs(clocks, kNever, where), clocks) << where;
}

TEST(Random, OneWrongBitIsNoticed) {
  std::string where;
  EXPECT_EQ(netlist_differs(as_read(), 20, 7, where), 7);
  EXPECT_EQ(print_differs(20, 7, where), 7);
}

}  // namespace
}  // namespace hlsgen::test
