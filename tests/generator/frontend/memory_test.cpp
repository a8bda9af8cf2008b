// steplock::Memory: class and netlist agree, also over a reset, which the words outlast.

#include <algorithm>

#include "generator/machine/memory.hpp"
#include "tests/generator/frontend/against_native.hpp"
#include "tests/generator/frontend/blocks/memory.hpp"

namespace hlsgen::test {
namespace {

using steplock::test::Elephant;
using steplock::test::Notebook;

TEST(Memory, ABlockWithOneEqualsItsCpp) { expect_equal_to_native<Notebook>("notebook"); }
TEST(Memory, SoDoesOneOfASingleLane) { expect_equal_to_native<Elephant>("elephant"); }

// The first clock in which the two differ, with a reset now and then; `clocks` if none.
template <class Block>
int first_difference_over_resets(const std::string& top, int clocks) {
  auto design = design_of(top);
  optimise(design);
  check(design);
  const auto& module = design.modules.back();
  Interpreter netlist(design);
  Block native;
  Stimulus any(7);
  for (int clock = 0; clock < clocks; ++clock) {
    if (any.bits(8) == 3) {
      netlist.reset();
      native = {};
    }
    std::vector<llvm::APInt> inputs;
    for (const auto& leaf : module.inputs) inputs.push_back(random_value(module, leaf, any));
    typename Block::In in;
    std::size_t i = 0;
    in.each([&](auto& number) { steplock::ports::set_number(number, word_of(inputs.at(i++))); });
    const auto outputs = netlist.clock(inputs);
    const auto expected = native.tick(in);
    if (word_of(outputs[0]) != steplock::ports::word_of(expected.data, 12)) return clock;
  }
  return clocks;
}

TEST(Memory, FlagsHideWhatOutlastsAReset) {
  EXPECT_EQ(first_difference_over_resets<Notebook>("notebook", 50'000), 50'000);
}
TEST(Memory, WithoutThemItShows) {
  EXPECT_LT(first_difference_over_resets<Elephant>("elephant", 50'000), 5'000);
}

TEST(Memory, IsAModuleCalledAfterItsContents) {
  const auto design = design_of("notebook");
  ASSERT_EQ(design.modules.size(), 2U);
  const auto& pages = design.modules[0];
  EXPECT_EQ(pages.name, "pages");
  EXPECT_TRUE(is_memory(pages));
  ASSERT_EQ(pages.tables[0].entries.size(), 16U);
  for (unsigned i = 0; i < 16; ++i) EXPECT_EQ(pages.tables[0].entries[i], i * i * 17);
  const std::string print = print_memory(pages);
  for (const char* line :
       {"  logic [11:0] words [0:15];\n", "    words[15] = 12'hEF1;\n",
        "    if (write_i[1]) words[write_address_i][7:4] <= write_data_i[7:4];\n",
        "    if (read_i) data_o <= words[address_i];\n"}) {
    EXPECT_NE(print.find(line), std::string::npos) << line << print;
  }
}

}  // namespace
}  // namespace hlsgen::test
