// Passes: each keeps what a netlist does, and does what its header says.

#include "generator/backend.hpp"
#include "generator/interpret.hpp"
#include "generator/passes/constant_registers.hpp"
#include "generator/passes/fold_constants.hpp"
#include "generator/passes/narrow_widths.hpp"
#include "generator/passes/remove_dead.hpp"
#include "generator/passes/share_common.hpp"
#include "generator/passes/simplify_compares.hpp"
#include "generator/passes/simplify_counters.hpp"
#include "generator/passes/simplify_muxes.hpp"
#include "generator/passes/simplify_wiring.hpp"
#include "generator/passes/spell_enumerators.hpp"
#include "tests/generator/random_netlist.hpp"

#include <gtest/gtest.h>

namespace hlsgen {
namespace {

using test::Build;
using test::RandomNetlist;

Design alone(Module m) {
  Design d;
  d.modules.push_back(std::move(m));
  return d;
}

// The first clock on which the two differ, or -1.
int first_difference(const Module& a, const Module& b, unsigned seed, int clocks) {
  RandomNetlist stimulus(seed);
  const Design da = alone(a), db = alone(b);
  Interpreter left(da), right(db);
  for (int clock = 0; clock < clocks; ++clock) {
    std::vector<llvm::APInt> in;
    for (const Leaf& leaf : a.inputs) in.push_back(stimulus.any_value(leaf.width));
    if (left.clock(in) != right.clock(in)) return clock;
  }
  return -1;
}

struct NamedPass {
  const char* name;
  bool (*run)(Module&);
};
constexpr NamedPass kPasses[] = {
    {"fold_constants", fold_constants},         {"simplify_wiring", simplify_wiring},
    {"share_common", share_common},             {"remove_dead", remove_dead},
    {"narrow_widths", narrow_widths},           {"simplify_muxes", simplify_muxes},
    {"simplify_compares", simplify_compares},   {"constant_registers", constant_registers},
    {"simplify_counters", simplify_counters},   {"spell_enumerators", spell_enumerators}};

TEST(Passes, EachAloneKeepsRandomNetlistsEqual) {
  for (const NamedPass& pass : kPasses) {
    for (unsigned seed = 0; seed < 500; ++seed) {
      const Module before = RandomNetlist(seed).make("random", 30);
      Design after = alone(before);
      pass.run(after.modules[0]);
      ASSERT_NO_THROW(check(after)) << pass.name << " seed " << seed;
      ASSERT_EQ(first_difference(before, after.modules[0], seed, 60), -1)
          << pass.name << " seed " << seed;
    }
  }
}

TEST(Passes, AllTogetherKeepRandomNetlistsEqualAndPrintable) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    const Module before = RandomNetlist(seed).make("random", 10 + seed % 60);
    Design after = alone(before);
    optimise(after);
    ASSERT_NO_THROW(check(after)) << "seed " << seed;
    ASSERT_EQ(first_difference(before, after.modules[0], seed, 60), -1) << "seed " << seed;
    ASSERT_LE(after.modules[0].nodes.size(), before.nodes.size() + 20) << "seed " << seed;
    ASSERT_FALSE(print_module(after, after.modules[0]).empty());
  }
}

// The comparison above must be able to fail.
TEST(Passes, AWrongConstantIsNoticed) {
  Build b("sum");
  const NodeId one = b.constant(8, 1);
  b.output("y", b.op(Op::kAdd, b.input("x", 8), one));
  Module wrong = b.m;
  wrong.nodes[one].value = llvm::APInt(8, 2);
  EXPECT_NE(first_difference(b.m, wrong, 1, 60), -1);
}

TEST(Passes, OptimisingTwiceChangesNothing) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Design d = alone(RandomNetlist(seed).make("random", 40));
    optimise(d);
    const std::string once = print_module(d, d.modules[0]);
    optimise(d);
    ASSERT_EQ(print_module(d, d.modules[0]), once) << "seed " << seed;
  }
}

// What a small netlist prints as, once optimised: the value of its output y.
std::string optimised(Build b) {
  Design d = alone(std::move(b.m));
  optimise(d);
  check(d);
  const std::string text = print_module(d, d.modules[0]);
  const std::size_t at = text.find("assign y_o =");
  return text.substr(at + 12, text.find(';', at) - at - 12);
}

TEST(Fold, ConstantsMeet) {
  Build b("m");
  const NodeId x = b.input("x", 8);
  b.output("y", b.op(Op::kAdd, b.op(Op::kAdd, x, b.constant(8, 3)), b.constant(8, 4)));
  EXPECT_EQ(optimised(std::move(b)), " x_i + 8'd7");
}

TEST(Fold, MultiplyingByAPowerOfTwoIsWiring) {
  Build b("m");
  b.output("y", b.op(Op::kMul, b.input("x", 8), b.constant(8, 8)));
  EXPECT_EQ(optimised(std::move(b)), " {x_i[4:0], 3'd0}");
}

TEST(Narrow, SumThatIsCutIsComputedCut) {
  Build b("m");
  const NodeId x = b.input("x", 8), z = b.input("z", 8);
  b.output("y", b.slice(b.op(Op::kAdd, b.zext(x, 32), b.zext(z, 32)), 7, 0));
  EXPECT_EQ(optimised(std::move(b)), " x_i + z_i");
}

TEST(Narrow, ComparisonForgetsItsExtensions) {
  Build b("m");
  const NodeId x = b.input("x", 8), z = b.input("z", 8);
  b.output("y", b.op(Op::kSlt, b.zext(x, 32), b.zext(z, 32)));
  EXPECT_EQ(optimised(std::move(b)), " x_i < z_i");
}

TEST(Narrow, MaskIsWiring) {
  Build b("m");
  b.output("y", b.op(Op::kAnd, b.input("x", 8), b.constant(8, 0x1c)));
  EXPECT_EQ(optimised(std::move(b)), " {3'd0, x_i[4:2], 2'd0}");
}

TEST(Narrow, ProductIsAsWideAsItsFactorsAsk) {
  Build b("m");
  const NodeId x = b.input("x", 16), k = b.input("k", 10);
  b.output("y", b.op(Op::kMul, b.sext(x, 64), b.sext(k, 64)));
  Design d = alone(std::move(b.m));
  optimise(d);
  EXPECT_NE(print_module(d, d.modules[0]).find("wire [25:0] x_times_k = $signed(x_i) * $signed(k_i)"),
            std::string::npos);
}

TEST(Mux, OneBitChoicesAreLogic) {
  Build b("m");
  const NodeId c = b.input("c", 1), x = b.input("x", 1);
  b.output("y", b.mux(c, b.constant(1, 1), x));
  EXPECT_EQ(optimised(std::move(b)), " c_i || x_i");
}

TEST(Mux, TwoSumsBecomeOneBehindAChoiceOfOperands) {
  Build b("m");
  const NodeId c = b.input("c", 1), x = b.input("x", 8), p = b.input("p", 8), q = b.input("q", 8);
  b.output("y", b.mux(c, b.op(Op::kAdd, x, p), b.op(Op::kAdd, q, x)));
  EXPECT_EQ(optimised(std::move(b)), " x_i + (c_i ? p_i : q_i)");
}

TEST(Mux, ConditionIsKnownInsideOfItsArms) {
  Build b("m");
  const NodeId c = b.input("c", 1), d = b.input("d", 1), x = b.input("x", 8), p = b.input("p", 8),
               q = b.input("q", 8);
  b.output("y", b.mux(c, x, b.mux(b.op(Op::kAnd, b.inv(c), d), p, q)));
  EXPECT_EQ(optimised(std::move(b)), "\n      c_i ? x_i :\n      d_i ? p_i :\n      q_i");
}

TEST(Compare, DifferenceOfZeroIsEquality) {
  Build b("m");
  const NodeId x = b.input("x", 8), z = b.input("z", 8);
  b.output("y", b.op(Op::kEq, b.op(Op::kSub, x, z), b.constant(8, 0)));
  EXPECT_EQ(optimised(std::move(b)), " x_i == z_i");
}

TEST(Compare, SignIsABit) {
  Build b("m");
  b.output("y", b.op(Op::kSlt, b.input("x", 8), b.constant(8, 0)));
  EXPECT_EQ(optimised(std::move(b)), " x_i[7]");
}

// x < c, or c < x
std::string below(Op op, unsigned width, std::uint64_t c) {
  Build b("m");
  b.output("y", b.op(op, b.input("x", width), b.constant(width, c)));
  return optimised(std::move(b));
}
std::string above(Op op, unsigned width, std::uint64_t c) {
  Build b("m");
  b.output("y", b.op(op, b.constant(width, c), b.input("x", width)));
  return optimised(std::move(b));
}

// Yosys before August 2026 takes a signed value that fits a look-up table for an unsigned one there.
TEST(Compare, SignedOnesWithNegativeConstantsOfUpToSixBitsAreUnsignedOnes) {
  EXPECT_EQ(below(Op::kSlt, 3, 0b110), " x_i[2] && !x_i[1]");
  EXPECT_EQ(above(Op::kSlt, 6, 0b110110), " !x_i[5] || x_i[4:0] > 5'd22");
  EXPECT_EQ(below(Op::kSlt, 7, 0b1110111), " $signed(x_i) < -7'sd9");
}

TEST(Compare, ReachingAPowerOfTwoNeedsNoCarry) {
  EXPECT_EQ(below(Op::kUlt, 8, 4), " x_i[7:2] == 6'd0");
  EXPECT_EQ(above(Op::kUlt, 8, 3), " x_i[7:2] != 6'd0");
}

TEST(Compare, SaturationLooksAtTheUpperBitsAlone) {
  Build b("m");
  const NodeId x = b.input("x", 10, true);
  const NodeId most = b.constant(10, 127), least = b.constant(10, 0x380);
  const NodeId low = b.slice(x, 7, 0);
  const NodeId capped = b.mux(b.op(Op::kSlt, x, most), low, b.constant(8, 127));
  b.output("y", b.mux(b.op(Op::kSlt, x, least), b.constant(8, 0x80), capped));
  const std::string text = optimised(std::move(b));
  EXPECT_EQ(text.find('<'), std::string::npos) << text;
  EXPECT_NE(text.find("x_i[8:7] != 2'd3"), std::string::npos) << text;
}

TEST(Counters, ConditionBecomesTheClockEnable) {
  Build b("m");
  const NodeId c = b.input("c", 1), r = b.reg("r", 8, 0);
  b.next(r, b.op(Op::kAdd, r, b.extend(Op::kSext, c, 8)));
  b.output("y", r);
  Design d = alone(std::move(b.m));
  optimise(d);
  const std::string text = print_module(d, d.modules[0]);
  EXPECT_NE(text.find("if (c_i)"), std::string::npos) << text;
}

TEST(Counters, ConditionOfAnAddendBecomesTheClockEnable) {
  for (const bool then : {true, false}) {
    Build b("m");
    const NodeId c = b.input("c", 1), x = b.input("x", 8), r = b.reg("r", 8, 0), zero = b.constant(8, 0);
    b.next(r, b.op(Op::kAdd, then ? b.mux(c, x, zero) : b.mux(c, zero, x), r));
    b.output("y", r);
    Design d = alone(std::move(b.m));
    optimise(d);
    const std::string text = print_module(d, d.modules[0]);
    EXPECT_NE(text.find(then ? "if (c_i)" : "if (!c_i)"), std::string::npos) << text;
    EXPECT_EQ(text.find('?'), std::string::npos) << text;
  }
}

// A sum that somebody else reads has to be there whether the register takes it or not.
TEST(Counters, SumThatIsReadKeepsItsAddend) {
  Build b("m");
  const NodeId c = b.input("c", 1), x = b.input("x", 8), r = b.reg("r", 8, 0);
  const NodeId sum = b.op(Op::kAdd, r, b.mux(c, x, b.constant(8, 0)));
  b.next(r, sum);
  b.output("y", sum);
  Design d = alone(std::move(b.m));
  optimise(d);
  const std::string text = print_module(d, d.modules[0]);
  EXPECT_EQ(text.find("if (c_i)"), std::string::npos) << text;
}

TEST(Enumerators, KeepTheirNamesWherePackedIntoFewerBits) {
  Build b("m");
  b.m.enumerations.push_back({"State", 3, {{"kIdle", 0}, {"kRun", 1}, {"kStop", 3}}});
  const NodeId c = b.input("c", 1), d = b.input("d", 1);
  const NodeId stop = b.constant(2, 3), run = b.constant(2, 1), idle = b.constant(3, 0);
  const NodeId packed = b.zext(b.mux(c, stop, run), 3);
  b.output("y", b.mux(d, packed, idle), 0);
  EXPECT_EQ(optimised(std::move(b)),
            " d_i ? (c_i ? State_kStop : State_kRun) : State_kIdle");
}

TEST(Registers, OnesThatNeverLeaveResetAreConstant) {
  Build b("m");
  const NodeId c = b.input("c", 1), x = b.input("x", 8);
  const NodeId r = b.reg("r", 8, 5), s = b.reg("s", 8, 5);
  b.next(r, b.mux(c, s, r));
  b.next(s, r);
  b.output("y", b.op(Op::kAdd, x, r));
  EXPECT_EQ(optimised(std::move(b)), " x_i + 8'd5");
}

TEST(Dead, RegisterThatOnlyFeedsItselfIsGone) {
  Build b("m");
  const NodeId r = b.reg("r", 8);
  b.next(r, b.op(Op::kAdd, r, b.constant(8, 1)));
  b.output("y", b.input("x", 8));
  Design d = alone(std::move(b.m));
  optimise(d);
  EXPECT_TRUE(d.modules[0].registers.empty());
}

}  // namespace
}  // namespace hlsgen
