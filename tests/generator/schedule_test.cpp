// Schedules: a sample spread over clocks gives what the sample gives, under its budget, and no
// later than has to be.

#include "generator/schedule/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "generator/backend.hpp"
#include "generator/interpret.hpp"
#include "generator/passes/known_bits.hpp"
#include "generator/schedule/split_products.hpp"
#include "tests/generator/random_netlist.hpp"

namespace hlsgen {
namespace {

using test::Build;
using test::RandomNetlist;

Leaf bit(const std::string& name) { return {name, 1, false, -1, ""}; }

scheduling::Frame frame_for(const Module& sample) {
  scheduling::Frame frame{bit("start"), bit("done"), bit("busy"), bit("missed"), {}};
  for (const Output& o : sample.outputs) frame.output_resets.emplace_back(o.leaf.width, 0);
  return frame;
}

Scheduled spread(const Module& sample, const Budget& budget) {
  return schedule(sample, budget, frame_for(sample));
}

Design alone(Module m) {
  Design d;
  d.modules.push_back(std::move(m));
  return d;
}

using Values = std::vector<llvm::APInt>;

Values any_inputs(const Module& m, RandomNetlist& any) {
  Values in;
  for (const Leaf& leaf : m.inputs) in.push_back(any.any_value(leaf.width));
  return in;
}

bool ends_with(const Values& outputs, bool done, bool busy, bool missed) {
  const std::size_t n = outputs.size();
  return outputs[n - 3] == done && outputs[n - 2] == busy && outputs[n - 1] == missed;
}

// The first sample in which the schedule differs from its block, or -1.  Starts come while it is
// busy as well, inputs change unless they are to be held, and results stand still from done to
// done.
int first_difference(const Module& sample, const Scheduled& scheduled, unsigned seed, int samples) {
  RandomNetlist any(seed);
  const Design plain = alone(sample), spread_out = alone(scheduled.module);
  Interpreter expected(plain), actual(spread_out);
  Values shown;
  for (const Output& o : sample.outputs) shown.emplace_back(o.leaf.width, 0);
  bool done = false, missed = false;
  for (int i = 0; i < samples; ++i) {
    const Values in = any_inputs(sample, any);
    for (unsigned clock = 0; clock < scheduled.report.clocks; ++clock) {
      Values given = clock == 0 || scheduled.report.budget.held ? in : any_inputs(sample, any);
      const bool start = clock == 0 || any.below(3) == 0;
      given.emplace_back(1, start ? 1 : 0);
      Values got = actual.clock(given);
      if (!ends_with(got, done, clock != 0, missed)) return i;
      got.resize(got.size() - 3);
      if (got != shown) return i;
      done = clock + 1 == scheduled.report.clocks;
      missed = start && clock != 0;
    }
    shown = expected.clock(in);
  }
  return -1;
}

Budget any_budget(unsigned seed) {
  RandomNetlist any(seed + 1000);
  Budget budget;
  budget.multipliers = 1 + any.below(3);
  budget.width = 4 + any.below(14);
  budget.second_width = 4 + any.below(14);
  budget.levels = 3 + any.below(12);
  budget.held = any.below(2) == 0;
  return budget;
}

unsigned count(const Module& m, Op op) {
  return static_cast<unsigned>(
      std::count_if(m.nodes.begin(), m.nodes.end(), [&](const Node& n) { return n.op == op; }));
}

// y = sum of a[i] * b[i], with registers for the sum before.
Module products(unsigned number, unsigned width) {
  Build b("products");
  const NodeId kept = b.reg("kept", 2 * width + 4);
  NodeId sum = kept;
  for (unsigned i = 0; i < number; ++i) {
    const NodeId x = b.input("a" + std::to_string(i), width);
    const NodeId y = b.input("b" + std::to_string(i), width);
    const NodeId p = b.op(Op::kMul, b.sext(x, 2 * width), b.sext(y, 2 * width));
    sum = b.op(Op::kAdd, sum, b.sext(p, 2 * width + 4));
  }
  b.next(kept, sum);
  b.output("y", sum);
  return b.m;
}

TEST(Schedule, RandomNetlistsEqualTheirSamples) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    const Module sample = RandomNetlist(seed).make("random", 10 + seed % 60);
    Scheduled scheduled = spread(sample, any_budget(seed));
    ASSERT_NO_THROW(check(alone(scheduled.module))) << "seed " << seed;
    ASSERT_EQ(first_difference(sample, scheduled, seed, 30), -1) << "seed " << seed;
    ASSERT_GE(scheduled.report.clocks, scheduled.report.bound) << "seed " << seed;
  }
}

// The comparison above must be able to fail.
TEST(Schedule, OneWrongBitIsNoticed) {
  const Module sample = RandomNetlist(3).make("random", 40);
  Scheduled scheduled = spread(sample, any_budget(3));
  ASSERT_EQ(first_difference(sample, scheduled, 3, 30), -1);
  Module& m = scheduled.module;
  Node inverse;
  inverse.op = Op::kNot;
  inverse.width = m.outputs[0].leaf.width;
  inverse.in = {m.outputs[0].value};
  m.nodes.push_back(inverse);
  m.outputs[0].value = static_cast<NodeId>(m.nodes.size() - 1);
  EXPECT_NE(first_difference(sample, scheduled, 3, 30), -1);
}

TEST(Schedule, ResetInTheMiddleBeginsAnew) {
  const Module sample = products(4, 16);
  const Scheduled scheduled = spread(sample, {1, 16, 16, 0, 8, false});
  ASSERT_GE(scheduled.report.clocks, 6U);
  const Design design = alone(scheduled.module);
  Interpreter fresh(design), used(design);
  RandomNetlist any(5);
  for (unsigned clock = 0; clock < scheduled.report.clocks + 2; ++clock) {
    Values in = any_inputs(sample, any);
    in.emplace_back(1, 1);
    used.clock(in);
  }
  used.reset();
  for (unsigned clock = 0; clock < 5 * scheduled.report.clocks; ++clock) {
    Values in = any_inputs(sample, any);
    in.emplace_back(1, any.below(2));
    ASSERT_EQ(used.clock(in), fresh.clock(in)) << "clock " << clock;
  }
}

TEST(Schedule, MultipliersStayWithinTheBudget) {
  for (unsigned multipliers = 1; multipliers <= 4; ++multipliers) {
    const auto scheduled = spread(products(8, 16), {multipliers, 16, 16, 0, 12, true});
    EXPECT_EQ(count(scheduled.module, Op::kMul), multipliers);
    EXPECT_EQ(first_difference(products(8, 16), scheduled, 1, 30), -1);
    // Turns, and two clocks from the last factors to their product; then the rest of the sum.
    EXPECT_GE(scheduled.report.clocks, 8 / multipliers + 2);
    EXPECT_LE(scheduled.report.clocks, scheduled.report.bound + 1);
  }
}

TEST(Schedule, FactorsAndProductsAreRegisters) {
  const auto scheduled = spread(products(8, 16), {2, 16, 16, 0, 12, true});
  const Module& m = scheduled.module;
  for (NodeId id = 0; id < m.nodes.size(); ++id) {
    if (m.nodes[id].op != Op::kMul) continue;
    for (const NodeId factor : m.nodes[id].in) {
      ASSERT_EQ(m.nodes[factor].op, Op::kSext);
      EXPECT_EQ(m.nodes[m.nodes[factor].in[0]].op, Op::kRegister);
    }
    EXPECT_TRUE(std::any_of(m.registers.begin(), m.registers.end(),
                            [&](const Register& r) { return r.next == id; }));
  }
}

TEST(Schedule, AWiderProductTakesSeveralTurns) {
  const Module sample = products(3, 24);
  const auto narrow = spread(sample, {1, 16, 16, 0, 12, true});
  const auto wide = spread(sample, {1, 24, 24, 0, 12, true});
  EXPECT_EQ(narrow.report.products, 12U);
  EXPECT_EQ(wide.report.products, 3U);
  EXPECT_EQ(first_difference(sample, narrow, 1, 30), -1);
  EXPECT_EQ(first_difference(sample, wide, 1, 30), -1);
}

TEST(Schedule, SplitProductsKeepRandomNetlistsEqualAndFit) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Module before = RandomNetlist(seed).make("random", 40);
    Module after = before;
    split_products(after, 5, 4);
    ASSERT_NO_THROW(check(alone(after))) << "seed " << seed;
    const auto known = known_bits(after);
    for (const Node& n : after.nodes) {
      if (n.op != Op::kMul) continue;
      const auto needs = [&](int i) { return std::min(n.width, known[n.in[i]].signed_width()); };
      EXPECT_LE(std::max(needs(0), needs(1)), 5U) << "seed " << seed;
      EXPECT_LE(std::min(needs(0), needs(1)), 4U) << "seed " << seed;
    }
    const Design one = alone(before), two = alone(after);
    Interpreter left(one), right(two);
    RandomNetlist any(seed);
    for (int clock = 0; clock < 60; ++clock) {
      const Values in = any_inputs(before, any);
      ASSERT_EQ(left.clock(in), right.clock(in)) << "seed " << seed;
    }
  }
}

TEST(Schedule, HeldInputsNeedNoRegisters) {
  const Module sample = products(6, 16);
  const auto held = spread(sample, {1, 16, 16, 0, 12, true});
  const auto taken = spread(sample, {1, 16, 16, 0, 12, false});
  EXPECT_EQ(first_difference(sample, taken, 1, 30), -1);
  EXPECT_EQ(held.report.clocks, taken.report.clocks);
  EXPECT_GE(taken.report.kept, held.report.kept + 5 * 32);
}

// Deep logic without a product is cut where the levels end.
TEST(Schedule, FewerLevelsTakeMoreClocks) {
  Build b("chain");
  NodeId sum = b.reg("sum", 32);
  const NodeId first = sum;
  for (int i = 0; i < 6; ++i)
    sum = b.op(Op::kXor, b.op(Op::kAdd, sum, b.input("x" + std::to_string(i), 32)), first);
  b.next(first, sum);
  b.output("y", sum);
  unsigned before = 0;
  for (const unsigned levels : {40U, 14U, 7U}) {
    const auto scheduled = spread(b.m, {1, 16, 16, 0, levels, true});
    EXPECT_EQ(first_difference(b.m, scheduled, 1, 30), -1);
    EXPECT_LE(scheduled.report.levels, levels);
    EXPECT_GT(scheduled.report.clocks, before);
    EXPECT_EQ(scheduled.report.clocks, scheduled.report.bound);
    before = scheduled.report.clocks;
  }
}

// Two reads of a table of 4096 bits: one table, behind a register.
TEST(Schedule, ALargeTableIsShared) {
  Build b("tables");
  std::vector<std::uint64_t> entries;
  for (unsigned i = 0; i < 256; ++i) entries.push_back(i * i & 0xffff);
  const NodeId x = b.table(16, entries, b.input("x", 8));
  Node second = b.m.nodes[x];
  second.in = {b.input("y", 8)};
  const NodeId y = b.add(second);
  b.output("sum", b.op(Op::kAdd, x, y));
  const auto scheduled = spread(b.m, {1, 16, 16, 0, 12, false});
  EXPECT_EQ(count(scheduled.module, Op::kTable), 1U);
  EXPECT_EQ(scheduled.report.entries, 2U);
  EXPECT_EQ(first_difference(b.m, scheduled, 1, 100), -1);
}

TEST(Schedule, ManyMultipliersReachTheBound) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const auto scheduled = spread(RandomNetlist(seed).make("random", 60), {50, 8, 8, 0, 6, true});
    EXPECT_EQ(scheduled.report.clocks, scheduled.report.bound) << "seed " << seed;
  }
}

}  // namespace
}  // namespace hlsgen
