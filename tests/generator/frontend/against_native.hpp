// The same block twice: as g++ compiled it, and as the front end read it, in lockstep.

#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "generator/backend.hpp"
#include "generator/front_end.hpp"
#include "generator/interpret.hpp"
#include "generator/port_words.hpp"

namespace hlsgen::test {

// Corners as often as the middle.
class Stimulus {
 public:
  explicit Stimulus(std::uint64_t seed) : engine_(seed) {}

  llvm::APInt bits(unsigned width) {
    switch (engine_() % 8) {
      case 0:
        return llvm::APInt(width, 0);
      case 1:
        return llvm::APInt::getAllOnes(width);
      case 2:
        return llvm::APInt::getSignedMinValue(width);
      case 3:
        return llvm::APInt::getSignedMaxValue(width);
      case 4:
        return llvm::APInt(width, engine_() % 8);
      default:
        return llvm::APInt(width, {engine_(), engine_()});
    }
  }

 private:
  std::mt19937_64 engine_;
};

inline Design design_of(const std::string& top, const std::string& source = "blocks.cpp") {
  std::filesystem::current_path(HLSGEN_ROOT);  // files are named relative to it
  FrontEndOptions options;
  options.compile.source = "tests/generator/frontend/" + source;
  options.compile.include_directories = {"."};
  options.top = top;
  return build_design(options).design;
}

inline steplock::ports::Word word_of(const llvm::APInt& value) {
  const auto wide = value.zext(256);
  return steplock::ports::Word{wide.extractBitsAsZExtValue(64, 64)} << 64 |
         wide.extractBitsAsZExtValue(64, 0);
}

inline llvm::APInt random_value(const Module& module, const Leaf& leaf, Stimulus& any) {
  auto value = any.bits(leaf.width);
  if (leaf.enumeration < 0) return value;
  const auto& values = module.enumerations[leaf.enumeration].values;
  return {leaf.width, values[value.getZExtValue() % values.size()].second};
}

template <class Block>
void run_against_native(const Design& design, int clocks) {
  const auto& module = design.modules.back();
  Interpreter netlist(design);
  Block native;
  Stimulus any(1);
  for (int clock = 0; clock < clocks; ++clock) {
    std::vector<llvm::APInt> inputs;
    for (const auto& leaf : module.inputs) inputs.push_back(random_value(module, leaf, any));
    typename Block::In in;
    std::size_t i = 0;
    in.each([&](auto& number) { steplock::ports::set_number(number, word_of(inputs.at(i++))); });
    ASSERT_EQ(i, inputs.size());

    const auto outputs = netlist.clock(inputs);
    auto expected = native.tick(in);
    i = 0;
    expected.each([&](auto& number) {
      const auto& leaf = module.outputs.at(i).leaf;
      EXPECT_TRUE(word_of(outputs[i]) ==
                  steplock::ports::word_of(number, static_cast<int>(leaf.width)))
          << module.name << "." << leaf.name << " in clock " << clock;
      ++i;
    });
    ASSERT_EQ(i, outputs.size());
    ASSERT_FALSE(::testing::Test::HasFailure());
  }
}

// As the front end leaves it, and as the passes make of it.
template <class Block>
void expect_equal_to_native(const std::string& top, int clocks = 20'000,
                            const std::string& source = "blocks.cpp") {
  auto design = design_of(top, source);
  ASSERT_NO_THROW(check(design));
  run_against_native<Block>(design, clocks);
  optimise(design);
  run_against_native<Block>(design, clocks);
}

}  // namespace hlsgen::test
