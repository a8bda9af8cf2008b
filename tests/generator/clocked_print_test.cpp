// How the readable printer writes what registers do: decisions, cases, wires within branches.

#include "generator/backend.hpp"
#include "generator/print/restrict.hpp"
#include "tests/generator/build.hpp"

#include <gtest/gtest.h>

namespace hlsgen {
namespace {

using test::Build;

std::string printed(Build b) {
  Design d;
  d.modules.push_back(std::move(b.m));
  check(d);
  return print_module(d, d.modules.back());
}
#define EXPECT_PRINTS(text, line) \
  EXPECT_NE((text).find(line), std::string::npos) << "no `" << (line) << "` in\n" << (text)

TEST(Restrictor, FollowsChoicesAndLogicButNotArithmetic) {
  Build b("facts");
  const NodeId c = b.input("c", 1), x = b.input("x", 1), p = b.input("p", 8), q = b.input("q", 8);
  const NodeId choice = b.mux(c, p, q);
  const NodeId both = b.op(Op::kAnd, c, x);
  const NodeId sum = b.op(Op::kAdd, choice, p);
  Restrictor r(b.m);
  Facts facts;
  r.learn(facts, c, true);
  EXPECT_EQ(r.restrict(facts, choice), p);
  EXPECT_EQ(r.restrict(facts, both), x);
  EXPECT_EQ(r.restrict(facts, sum), sum);
}

TEST(Restrictor, LearnsFromAConjunctionWhatItsPartsAre) {
  Build b("parts");
  const NodeId c = b.input("c", 1), x = b.input("x", 1), y = b.input("y", 1);
  const NodeId both = b.op(Op::kAnd, c, b.inv(x));
  const NodeId choice = b.mux(x, c, y);
  Restrictor r(b.m);
  Facts facts;
  r.learn(facts, both, true);
  EXPECT_EQ(r.restrict(facts, choice), y);
}

TEST(Restrictor, KnowsWhichValuesASelectorHasLeft) {
  Build b("range");
  const NodeId s = b.input("s", 2), x = b.input("x", 1);
  const NodeId below = b.op(Op::kUlt, s, b.constant(2, 2));
  const NodeId is_three = b.op(Op::kEq, s, b.constant(2, 3));
  const NodeId is_one = b.op(Op::kEq, s, b.constant(2, 1));
  const NodeId either = b.op(Op::kOr, is_three, x);
  Restrictor r(b.m);
  Facts facts;
  r.learn(facts, below, true);
  EXPECT_EQ(r.restrict(facts, either), x);
  EXPECT_EQ(r.restrict(facts, is_one), is_one);
}

TEST(ClockedPrint, RegistersThatOneConditionHoldsShareItsIf) {
  Build b("pair");
  const NodeId go = b.input("go", 1), x = b.input("x", 8);
  const NodeId p = b.reg("p", 8), q = b.reg("q", 8);
  b.next(p, b.mux(go, x, p));
  b.next(q, b.mux(go, b.op(Op::kAdd, q, x), q));
  b.output("p", p);
  b.output("q", q);
  EXPECT_PRINTS(printed(std::move(b)),
                "    if (go_i) begin\n"
                "      p <= x_i;\n"
                "      q <= q + x_i;\n"
                "    end\n"
                "    if (rst) begin\n");
}

// Four states: idle until `go`, two that share a sum, and one that clears.
Build machine() {
  Build b("machine");
  b.m.enumerations.push_back({"State", 2, {{"kIdle", 0}, {"kAdd", 1}, {"kKeep", 2}, {"kEnd", 3}}});
  const NodeId go = b.input("go", 1), x = b.input("x", 8), y = b.input("y", 8);
  const NodeId s = b.reg("state", 2, 0, 0), a = b.reg("a", 8), k = b.reg("k", 8);
  const auto is = [&](unsigned v) { return b.op(Op::kEq, s, b.constant(2, v)); };
  const NodeId sum = b.named(b.op(Op::kAdd, b.op(Op::kXor, x, a), y), "sum");
  const NodeId idle = is(0), add = is(1), keep = is(2), end = is(3);
  const NodeId first = b.mux(go, b.constant(2, 1), b.constant(2, 0));
  const NodeId after_keep = b.mux(keep, b.constant(2, 3), b.constant(2, 0));
  const NodeId after_add = b.mux(add, b.constant(2, 2), after_keep);
  b.next(s, b.mux(idle, first, after_add));
  const NodeId cleared = b.mux(end, b.constant(8, 0), a);
  b.next(a, b.mux(add, sum, cleared));
  b.next(k, b.mux(keep, sum, k));
  b.output("a", a);
  b.output("k", k);
  return b;
}

TEST(ClockedPrint, StateMachineIsACaseThatSaysWhatEachStateChanges) {
  const std::string text = printed(machine());
  EXPECT_PRINTS(text, "    case (state)\n      State_kIdle: begin\n        if (go_i) begin\n");
  EXPECT_PRINTS(text, "        state <= State_kIdle;\n        a <= 8'd0;\n");
  EXPECT_EQ(text.find("a <= a"), std::string::npos) << text;
  EXPECT_EQ(text.find("k <= k"), std::string::npos) << text;
}

TEST(ClockedPrint, ArmsThatReadOneWireHoldItInACaseOfTheirOwn) {
  const std::string text = printed(machine());
  EXPECT_PRINTS(text,
                "      State_kAdd, State_kKeep: begin\n"
                "        logic [7:0] sum;\n"
                "        sum = (x_i ^ a) + y_i;\n"
                "        case (state)\n"
                "          State_kAdd: begin\n"
                "            state <= State_kKeep;\n"
                "            a <= sum;\n"
                "          end\n"
                "          default: begin  // State_kKeep\n"
                "            state <= State_kEnd;\n"
                "            k <= sum;\n"
                "          end\n"
                "        endcase\n"
                "      end\n");
}

TEST(ClockedPrint, WireThatAnOutputReadsStaysTheModules) {
  Build b("outside");
  const NodeId go = b.input("go", 1), x = b.input("x", 8);
  const NodeId p = b.reg("p", 8);
  const NodeId sum = b.named(b.op(Op::kAdd, p, x), "sum");
  b.next(p, b.mux(go, sum, p));
  b.output("next", sum);
  EXPECT_PRINTS(printed(std::move(b)), "  wire [7:0] sum = p + x_i;");
}

TEST(ClockedPrint, ChoiceOfWordsThatTwoBranchesShareIsMadeOnce) {
  Build b("shared");
  const NodeId c = b.input("c", 1), d = b.input("d", 1), x = b.input("x", 8), y = b.input("y", 8);
  const NodeId r = b.reg("r", 8);
  const NodeId either = b.op(Op::kOr, c, d);
  const NodeId word = b.named(b.mux(either, x, y), "word");
  b.next(r, b.mux(c, word, b.mux(d, b.op(Op::kAdd, r, y), word)));
  b.output("r", r);
  const std::string text = printed(std::move(b));
  EXPECT_PRINTS(text, "wire [7:0] word = (c_i || d_i) ? x_i : y_i;");
}

TEST(ClockedPrint, FlipFlopsOfAnAsynchronousPinAreFoundByTheirShapeAndMarked) {
  Build b("pins");
  const NodeId p = b.input("p", 1), q = b.input("q", 2);
  const NodeId first = b.reg("first", 1), second = b.reg("second", 1);
  const NodeId wide = b.reg("wide", 2), narrow = b.reg("narrow", 1), still = b.reg("still", 2);
  b.next(first, p), b.next(second, first), b.next(wide, q), b.next(still, wide);
  b.next(narrow, b.op(Op::kXor, narrow, p));
  b.output("p", second), b.output("q", still), b.output("n", narrow);
  const std::string text = printed(std::move(b));
  const std::string marks =
      "  (* ASYNC_REG = \"TRUE\", syn_preserve = 1,\n"
      "     altera_attribute = \"-name SYNCHRONIZER_IDENTIFICATION FORCED\" *)\n";
  EXPECT_PRINTS(text, marks + "  logic\n      first,\n      second;\n");
  EXPECT_PRINTS(text, marks + "  logic [1:0] wide;\n  logic narrow;\n" + marks + "  logic [1:0] still;\n");
}

TEST(ClockedPrint, FlipFlopsThatAreMoreThanASynchroniserAreNotMarked) {
  Build b("others");
  const NodeId p = b.input("p", 1), c = b.input("c", 1);
  const NodeId read = b.reg("read", 1), twice = b.reg("twice", 1);  // the first flop has two readers
  const NodeId held = b.reg("held", 1), later = b.reg("later", 1);  // logic stands before the first
  b.next(read, p), b.next(twice, read);
  b.next(held, b.mux(c, p, held)), b.next(later, held);
  b.output("twice", twice), b.output("read", read), b.output("later", later);
  EXPECT_EQ(printed(std::move(b)).find("ASYNC_REG"), std::string::npos);
}

}  // namespace
}  // namespace hlsgen
