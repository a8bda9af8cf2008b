// What a value is called by how it is made, on small netlists made by hand.

#include "generator/print/spoken_names.hpp"

#include <gtest/gtest.h>

#include "generator/names.hpp"
#include "tests/generator/build.hpp"

namespace hlsgen {
namespace {

using test::Build;

class Spoken : public ::testing::Test {
 protected:
  std::string of(NodeId id) { return names([&](const SpokenNames& all) { return all.of(id); }); }
  std::string member(NodeId id, int set) {
    sets.assign(b.m.nodes.size(), -1);
    sets[id] = set;
    return names([&](const SpokenNames& all) { return all.member(id); });
  }

  template <class Ask>
  std::string names(const Ask& ask) {
    sets.resize(b.m.nodes.size(), -1);
    Plan plan{std::vector<unsigned>(b.m.nodes.size(), 1), std::vector<bool>(b.m.nodes.size(), false),
              std::vector<int>(b.m.nodes.size(), -1), {}};
    for (const NodeId wire : wires) plan.wire[wire] = true;
    plan.enumeration[state] = 0;
    return ask(SpokenNames(b.m, plan, sets, [this](NodeId id) {
      const Node& n = b.m.nodes[id];
      return n.op == Op::kInput ? flat_name(b.m.inputs[n.index].name) : n.op == Op::kRegister ? b.m.registers[n.index].leaf.name : n.name;
    }));
  }

  Build b{"spoken"};
  NodeId run = b.input("run", 1), held = b.input("held", 1), over = b.input("over", 1);
  NodeId last = b.input("last", 4), duty = b.input("duty", 4), state = b.input("state", 2);
  std::vector<NodeId> wires;
  std::vector<int> sets;

  void SetUp() override { b.m.enumerations.push_back({"State", 2, {{"kIdle", 0}, {"kPullIn", 1}, {"kRun", 2}}}); }
};

TEST_F(Spoken, OfBitsTheirLogic) {
  EXPECT_EQ(of(b.op(Op::kAnd, run, b.inv(held))), "run_and_not_held");
  EXPECT_EQ(of(b.op(Op::kOr, run, held)), "run_or_held");
  EXPECT_EQ(of(b.op(Op::kXor, run, held)), "run_xor_held");
  EXPECT_EQ(of(b.inv(held)), "not_held");
  EXPECT_EQ(of(b.inv(b.op(Op::kOr, run, held))), "neither_run_nor_held");
  EXPECT_EQ(of(b.inv(b.op(Op::kOr, b.inv(run), b.inv(held)))), "run_and_held");
  EXPECT_EQ(of(b.op(Op::kOr, b.op(Op::kAnd, run, held), over)), "run_and_held_or_over");
  EXPECT_EQ(of(b.op(Op::kAnd, b.op(Op::kOr, run, held), over)), "") << "would read as the one before";
  const NodeId request = b.inv(run);
  b.named(request, "request");
  EXPECT_EQ(of(b.op(Op::kOr, request, held)), "not_run_or_held") << "nobody sees that it had a name";
  wires = {request};
  EXPECT_EQ(of(b.op(Op::kOr, request, held)), "request_or_held");
  wires = {};
  EXPECT_EQ(inverted("not_run"), "run");
  EXPECT_EQ(inverted(""), "");
}

TEST_F(Spoken, OfOperatorsOfOneKindAllThatTheyAreMadeOf) {
  const NodeId two = b.op(Op::kOr, run, held);
  const NodeId three = b.op(Op::kOr, two, over);
  EXPECT_EQ(of(three), "run_or_held_or_over");
  EXPECT_EQ(of(b.op(Op::kOr, three, b.inv(run))), "") << "four say less than the expression";
  wires = {two};  // it is read elsewhere, too, and nobody gave it a name
  EXPECT_EQ(of(three), "");
  b.named(two, "asks");
  EXPECT_EQ(of(three), "asks_or_over");
}

TEST_F(Spoken, OfNumbersWhatIsDoneWithThem) {
  EXPECT_EQ(of(b.op(Op::kAdd, last, duty)), "last_plus_duty");
  EXPECT_EQ(of(b.op(Op::kAdd, b.zext(last, 5), b.constant(5, 1))), "last_plus_one");
  EXPECT_EQ(of(b.op(Op::kAdd, last, b.constant(4, 15))), "last_minus_one");
  EXPECT_EQ(of(b.op(Op::kSub, last, duty)), "last_minus_duty");
  EXPECT_EQ(of(b.op(Op::kMul, last, duty)), "last_times_duty");
  EXPECT_EQ(of(b.op(Op::kAdd, b.zext(last, 16), b.constant(16, 1000))), "") << "no word for it";
}

TEST_F(Spoken, OfComparisonsBothSides) {
  EXPECT_EQ(of(b.op(Op::kEq, state, b.constant(2, 1))), "state_is_pull_in");
  EXPECT_EQ(of(b.op(Op::kNe, duty, b.constant(4, 0))), "duty_is_not_zero");
  const NodeId idle = b.op(Op::kEq, state, b.constant(2, 0)), runs = b.op(Op::kEq, state, b.constant(2, 2));
  EXPECT_EQ(of(b.op(Op::kOr, idle, runs)), "state_is_idle_or_run");
  EXPECT_EQ(of(b.op(Op::kOr, idle, b.op(Op::kEq, duty, b.constant(4, 5)))), "state_is_idle_or_duty_is_five");
  EXPECT_EQ(of(b.op(Op::kAdd, state, b.constant(2, 1))), "state_plus_one") << "a number, no state";
  EXPECT_EQ(of(b.op(Op::kUlt, last, duty)), "last_below_duty");
  EXPECT_EQ(of(b.op(Op::kUlt, b.constant(4, 3), duty)), "duty_above_three");
  EXPECT_EQ(of(b.op(Op::kUle, b.constant(4, 3), duty)), "duty_at_least_three");
  EXPECT_EQ(of(b.op(Op::kAnd, b.op(Op::kUle, last, duty), run)), "last_at_most_duty_and_run");
}

TEST_F(Spoken, OfAChoiceItsCondition) {
  const NodeId none = b.constant(4, 0);
  EXPECT_EQ(of(b.mux(run, duty, none)), "duty_if_run");
  EXPECT_EQ(of(b.mux(run, none, duty)), "duty_unless_run");
  EXPECT_EQ(of(b.mux(b.inv(run), duty, last)), "duty_unless_run");
  EXPECT_EQ(of(b.mux(run, b.op(Op::kAdd, duty, last), none)), "") << "what is chosen has no name";
}

TEST_F(Spoken, OfAComparisonThatIsNoWireWhatItCompares) {
  const NodeId idle = b.op(Op::kEq, state, b.constant(2, 0)), runs = b.op(Op::kEq, state, b.constant(2, 2));
  b.named(idle, "was_idle_next");  // a register takes it, but nobody sees it by that name
  EXPECT_EQ(of(b.op(Op::kOr, idle, runs)), "state_is_idle_or_run");
  wires = {idle};
  EXPECT_EQ(of(b.op(Op::kOr, idle, runs)), "was_idle_next_or_state_is_run");
}

TEST_F(Spoken, WhatDecidesAChoice) {
  const auto selector = [this](NodeId id) { return names([&](const SpokenNames& all) { return all.selector(id); }); };
  const NodeId sum = b.op(Op::kAdd, duty, last), none = b.constant(4, 0);
  EXPECT_EQ(selector(b.mux(run, sum, none)), "run");
  EXPECT_EQ(selector(b.mux(b.inv(run), sum, none)), "run");
  EXPECT_EQ(selector(b.mux(b.op(Op::kEq, state, b.constant(2, 1)), sum, none)), "state");
  EXPECT_EQ(selector(b.mux(b.op(Op::kAnd, run, held), sum, none)), "run_and_held");
  EXPECT_EQ(selector(b.mux(b.op(Op::kUlt, sum, none), sum, none)), "");
  EXPECT_EQ(selector(sum), "") << "no choice";
  const NodeId at = b.input("at", 3), bit = b.slice(at, 1, 1);
  sets.assign(b.m.nodes.size(), -1);
  sets[at] = 0;
  EXPECT_EQ(selector(b.mux(bit, sum, none)), "state") << "the enumeration of the set";
}

TEST_F(Spoken, WhatAValueIsToTheOnlyOneThatReadsIt) {
  const auto role = [this](NodeId id, NodeId reader) { return names([&](const SpokenNames& all) { return all.role(id, reader); }); };
  const NodeId bit = b.op(Op::kUlt, b.op(Op::kAdd, last, duty), duty), number = b.op(Op::kAdd, last, duty), none = b.constant(4, 0);
  EXPECT_EQ(role(bit, b.op(Op::kAnd, bit, run)), "_if_run");
  EXPECT_EQ(role(bit, b.op(Op::kAnd, b.inv(run), bit)), "_unless_run");
  EXPECT_EQ(role(bit, b.op(Op::kOr, bit, run)), "_unless_run");
  EXPECT_EQ(role(bit, b.op(Op::kOr, bit, b.inv(run))), "_if_run");
  EXPECT_EQ(role(number, b.mux(run, number, none)), "_if_run");
  EXPECT_EQ(role(number, b.mux(run, none, number)), "_unless_run");
  EXPECT_EQ(role(number, b.mux(b.inv(run), none, number)), "_if_run");
  EXPECT_EQ(role(number, b.op(Op::kAdd, number, duty)), "") << "no condition";
  EXPECT_EQ(role(number, b.op(Op::kAnd, number, duty)), "") << "a mask";
  EXPECT_EQ(role(run, b.mux(run, none, number)), "") << "the condition itself";
}

TEST_F(Spoken, OfABitOfASetItsEnumerator) {
  const NodeId at = b.input("at", 3);
  const NodeId bit = b.slice(at, 1, 1);
  EXPECT_EQ(of(b.op(Op::kAnd, bit, run)), "") << "bits of a number have no names";
  sets.assign(b.m.nodes.size(), -1);
  sets[at] = 0;
  EXPECT_EQ(of(b.op(Op::kAnd, bit, run)), "in_pull_in_and_run");

  const NodeId none = b.constant(3, 0), pull_in = b.constant(3, 2), all = b.constant(3, 7);
  EXPECT_EQ(member(b.mux(run, pull_in, none), 0), "pull_in");
  EXPECT_EQ(member(b.mux(run, none, b.mux(held, pull_in, none)), 0), "pull_in");
  EXPECT_EQ(member(b.mux(run, pull_in, b.constant(3, 4)), 0), "");
  EXPECT_EQ(member(b.mux(run, all, none), 0), "");
  EXPECT_EQ(member(b.mux(run, pull_in, none), -1), "") << "of no set";
}

TEST_F(Spoken, WhatIsLongerThanItSaysHasNone) {
  const NodeId a = b.input("the_one_and_only_reason", 1), c = b.input("the_second_reason", 1), d = b.input("another_reason", 1);
  EXPECT_EQ(of(b.op(Op::kAnd, a, c)), "");
  EXPECT_EQ(of(b.op(Op::kAnd, a, d)), "the_one_and_only_reason_and_another_reason") << "one less than 44 characters";
}

}  // namespace
}  // namespace hlsgen
