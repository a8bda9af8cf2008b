// Programs: a sample on one datapath with its numbers in a memory gives what the sample gives.

#include "generator/machine/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "generator/backend.hpp"
#include "generator/interpret.hpp"
#include "generator/machine/clamps.hpp"
#include "generator/machine/fuse.hpp"
#include "generator/machine/lower.hpp"
#include "generator/machine/memory.hpp"
#include "generator/passes/known_bits.hpp"
#include "tests/generator/random_netlist.hpp"

namespace hlsgen {
namespace {

using test::Build;
using test::RandomNetlist;
using Values = std::vector<llvm::APInt>;

Leaf bit(const std::string& name) { return {name, 1, false, -1, ""}; }

Budget budget_of(unsigned width, unsigned second_width) {
  Budget budget;
  budget.width = width;
  budget.second_width = second_width;
  return budget;
}

Scheduled compiled(const Module& sample, const Budget& budget, std::vector<bool> early = {}) {
  Frame frame{bit("start"), bit("done"), bit("busy"), bit("missed"), {}, early};
  for (const Output& o : sample.outputs) frame.output_resets.emplace_back(o.leaf.width, 0);
  return schedule(sample, budget, frame);
}

Design alone(Module m) {
  Design d;
  d.modules.push_back(std::move(m));
  return d;
}
Design whole(const Scheduled& scheduled) {
  Design d;
  d.modules = scheduled.memories;
  d.modules.push_back(scheduled.module);
  return d;
}

Values any_inputs(const Module& m, RandomNetlist& any) {
  Values in;
  for (const Leaf& leaf : m.inputs) in.push_back(any.any_value(leaf.width));
  return in;
}

// The first sample in which the program differs from its block, or -1: its outputs stand from done to
// done, early ones from that clock on, starts come while it is busy as well, and every 13th sample is cut
// off by a reset.
int first_difference(const Module& sample, const Scheduled& scheduled, unsigned seed, int samples,
                     const std::vector<bool>& early = {}) {
  RandomNetlist any(seed);
  const Design plain = alone(sample);
  Design program = whole(scheduled);
  optimise(program);
  check(program);
  Interpreter expected(plain), actual(program);
  Values none;
  for (const Output& o : sample.outputs) none.emplace_back(o.leaf.width, 0);
  Values shown = none;
  bool done = false, missed = false;
  for (int i = 0; i < samples; ++i) {
    const Values in = any_inputs(sample, any);
    const unsigned cut = i % 13 == 12 ? any.below(scheduled.report.clocks) : scheduled.report.clocks;
    const Values coming = expected.clock(in);
    for (unsigned clock = 0; clock < cut; ++clock) {
      Values given = in;
      const bool start = clock == 0 || any.below(3) == 0;
      given.emplace_back(1, start ? 1 : 0);
      const Values got = actual.clock(given);
      for (std::size_t o = 0; o < early.size(); ++o)
        if (early[o] && clock == scheduled.report.early) shown[o] = coming[o];
      Values wanted = shown;
      for (const bool flag : {done, clock != 0, missed}) wanted.emplace_back(1, flag ? 1 : 0);
      if (got != wanted) return i;
      done = clock + 1 == scheduled.report.clocks;
      missed = start && clock != 0;
    }
    if (cut < scheduled.report.clocks) {
      expected.reset();
      actual.reset();
      shown = none;
      done = missed = false;
    } else {
      shown = coming;
    }
  }
  return -1;
}

TEST(Machine, RandomNetlistsEqualTheirSamples) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Module sample = RandomNetlist(seed).make("random", 10 + seed % 60);
    RandomNetlist any(seed + 1000);
    const auto scheduled = compiled(sample, budget_of(4 + any.below(14), 4 + any.below(14)));
    ASSERT_EQ(first_difference(sample, scheduled, seed, 30), -1) << "seed " << seed;
    ASSERT_GE(scheduled.report.clocks, scheduled.report.bound) << "seed " << seed;
  }
}

// Every other output early: no later than the rest, and for many netlists before it.
TEST(Machine, EarlyOutputsComeBeforeTheOthers) {
  unsigned sooner = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Module sample = RandomNetlist(seed).make("random", 20 + seed % 60);
    std::vector<bool> early;
    for (std::size_t o = 0; o < sample.outputs.size(); ++o) early.push_back(o % 2 == 0);
    const auto scheduled = compiled(sample, budget_of(16, 16), early);
    ASSERT_EQ(first_difference(sample, scheduled, seed, 30, early), -1) << "seed " << seed;
    ASSERT_LE(scheduled.report.early, scheduled.report.clocks) << "seed " << seed;
    sooner += scheduled.report.early + 5 < scheduled.report.clocks ? 1 : 0;
  }
  EXPECT_GT(sooner, 20U);
}

// The comparison above must be able to fail, in every fourth clock (all take a minute): its word's bits turned one after the other.
TEST(Machine, AWrongBitInAClockOfTheProgramIsNoticed) {
  const Module sample = RandomNetlist(3).make("random", 40);
  auto scheduled = compiled(sample, budget_of(16, 16));
  ASSERT_EQ(first_difference(sample, scheduled, 3, 30), -1);
  auto& words = scheduled.memories[0].tables[0].entries;
  for (unsigned word = 0; word < scheduled.report.clocks; word += 4) {
    bool noticed = false;  // by one at least: some are of fields that this clock does not use
    for (unsigned place = 0; place < words[word].getBitWidth() && !noticed; ++place) {
      words[word].flipBit(place);
      noticed = first_difference(sample, scheduled, 3, 30) != -1;
      words[word].flipBit(place);
    }
    EXPECT_TRUE(noticed) << "clock " << word;
  }
}

// saturate<Int<8>>(x), as LLVM leaves it.
struct Saturation {
  Build b{"saturation"};
  NodeId x = b.input("x", 20, true);
  NodeId of(NodeId negative, NodeId low_end) {
    const NodeId top = b.slice(x, 19, 7), bits = b.slice(x, 7, 0);
    const NodeId fits_below = b.op(Op::kEq, top, b.constant(13, 0x1fff));
    const NodeId fits_above = b.op(Op::kEq, top, b.constant(13, 0));
    return b.mux(negative, b.mux(fits_below, bits, low_end),
                 b.mux(fits_above, bits, b.constant(8, 127)));
  }
};

std::optional<machine::Clamp> clamp_of(const Module& m, NodeId choice) {
  const auto known = known_bits(m);
  const auto any = [&](NodeId id) { return machine::Range::of(m.nodes[id].width, true); };
  return machine::Clamps(m, known, any).find(choice);
}

TEST(Machine, AChoiceOfEndsIsOneClamp) {
  Saturation s;
  const NodeId found = s.of(s.b.slice(s.x, 19, 19), s.b.constant(8, 0x80));
  const auto clamp = clamp_of(s.b.m, found);
  ASSERT_TRUE(clamp);
  EXPECT_EQ(clamp->of, s.x);
  EXPECT_EQ(clamp->width, 8U);
  EXPECT_TRUE(clamp->is_signed);
  s.b.output("y", found);
  const auto scheduled = compiled(s.b.m, budget_of(16, 16));
  EXPECT_EQ(scheduled.report.instructions, 1U);
  EXPECT_EQ(first_difference(s.b.m, scheduled, 1, 300), -1);
}

TEST(Machine, AnotherEndIsNoClamp) {
  Saturation s;
  const NodeId wrong = s.of(s.b.slice(s.x, 19, 19), s.b.constant(8, 0x81));
  EXPECT_FALSE(clamp_of(s.b.m, wrong));
}

// LLVM asks 5 - 3 x < 0 as 5 < 3 x, and 3 x < 0 as x < 0: conditions on what the number was made of.
TEST(Machine, AClampIsFoundThroughSumsAndProducts) {
  Build b("through");
  const NodeId x = b.input("x", 12, true);
  const NodeId triple = b.op(Op::kMul, b.sext(x, 20), b.constant(20, 3));
  const NodeId y = b.op(Op::kSub, b.constant(20, 5), triple), bits = b.slice(y, 7, 0);
  const NodeId above = b.op(Op::kSlt, b.constant(20, 127), y);
  const auto clamp_with = [&](std::uint64_t end, NodeId falls) {
    const NodeId low =
        b.mux(b.op(Op::kSlt, y, b.constant(20, (1U << 20) - 128)), b.constant(8, 0x80), bits);
    return b.mux(falls, low, b.mux(above, b.constant(8, end), bits));
  };
  const NodeId falls = b.op(Op::kSlt, b.constant(20, 5), triple);
  const NodeId found = clamp_with(127, falls), wrong = clamp_with(126, falls);
  const auto clamp = clamp_of(b.m, found);
  ASSERT_TRUE(clamp);
  EXPECT_EQ(clamp->of, y);
  EXPECT_FALSE(clamp_of(b.m, wrong));
  // Positive x that is taken for negative y is no clamp.
  EXPECT_FALSE(clamp_of(b.m, clamp_with(127, b.slice(x, 11, 11))));
  b.output("y", found);
  const auto scheduled = compiled(b.m, budget_of(16, 16));
  EXPECT_LE(scheduled.report.instructions, 2U);
  EXPECT_EQ(first_difference(b.m, scheduled, 1, 300), -1);
}

// A product with its rounding, shift and clamp: two clocks of reading, one of summing, one of cutting.
TEST(Machine, AProductIsOneInstruction) {
  Build b("product");
  const NodeId x = b.reg("x", 16);
  b.m.registers[0].leaf.is_signed = true;
  const NodeId p = b.op(Op::kMul, b.sext(x, 32), b.sext(b.input("y", 16, true), 32));
  const NodeId sum = b.op(Op::kAdd, b.sext(p, 33), b.constant(33, 1 << 14));
  const NodeId cut = b.slice(sum, 30, 15);
  b.next(x, cut);
  b.output("z", cut);
  const auto scheduled = compiled(b.m, budget_of(16, 16));
  EXPECT_EQ(scheduled.report.instructions, 1U);
  EXPECT_EQ(first_difference(b.m, scheduled, 1, 100), -1);
}

// Registers that exchange their values, and one that holds still.
TEST(Machine, RegistersMayExchange) {
  Build b("exchange");
  const NodeId x = b.reg("x", 9), y = b.reg("y", 9), z = b.reg("z", 9);
  b.next(x, y);
  b.next(y, b.op(Op::kAdd, x, b.input("i", 9)));
  b.next(z, z);
  b.output("sum", b.op(Op::kAdd, b.op(Op::kXor, x, z), y));
  EXPECT_EQ(first_difference(b.m, compiled(b.m, budget_of(16, 16)), 1, 100), -1);
}

TEST(Machine, AMemoryKeepsItsWordsOverAReset) {
  Build b("of");
  Design d = alone(memory_module("words", b.m, {4, llvm::APInt(8, 7)}, true));
  Interpreter memory(d);
  const auto clock = [&](unsigned address, bool write, unsigned to, unsigned data) {
    return memory.clock({llvm::APInt(2, address), llvm::APInt(1, write), llvm::APInt(2, to),
                         llvm::APInt(8, data)})[0].getZExtValue();
  };
  clock(0, true, 2, 99);
  EXPECT_EQ(clock(2, false, 0, 0), 7U);
  memory.reset();
  EXPECT_EQ(clock(0, false, 0, 0), 99U);
  EXPECT_EQ(clock(0, false, 0, 0), 7U);
}

}  // namespace
}  // namespace hlsgen
