// What follows from conditions, and whether a value that nobody wrote reaches an output.

#include "generator/dataflow/conditions.hpp"

#include <gtest/gtest.h>

#include "generator/dataflow/reach.hpp"
#include "tests/generator/build.hpp"

namespace hlsgen {
namespace {

using test::Build;

TEST(Conditions, ADisjunctionThatFailsDeniesBoth) {
  Build b("m");
  const NodeId x = b.input("x", 1), y = b.input("y", 1);
  const NodeId either = b.op(Op::kOr, x, y);
  Conditions conditions(b.m);
  EXPECT_TRUE(conditions.assume(either, false));
  EXPECT_FALSE(conditions.assume(x, true));
}

TEST(Conditions, WhatIsLeftOfAConjunctionFollows) {
  Build b("m");
  const NodeId x = b.input("x", 1), y = b.input("y", 1);
  const NodeId both = b.op(Op::kAnd, x, y);
  Conditions conditions(b.m);
  EXPECT_TRUE(conditions.assume(both, false));
  EXPECT_TRUE(conditions.assume(x, true));
  EXPECT_FALSE(conditions.assume(y, true));
}

TEST(Conditions, ANumberIsOneConstantAtMost) {
  Build b("m");
  const NodeId x = b.input("x", 4);
  const NodeId two = b.op(Op::kEq, x, b.constant(4, 2)), three = b.op(Op::kEq, x, b.constant(4, 3));
  Conditions conditions(b.m);
  EXPECT_TRUE(conditions.assume(two, false));
  EXPECT_TRUE(conditions.assume(three, true));
  conditions.back_to(0);
  EXPECT_TRUE(conditions.assume(two, true));
  EXPECT_FALSE(conditions.assume(three, true));
}

TEST(Conditions, GoingBackForgets) {
  Build b("m");
  const NodeId x = b.input("x", 1);
  Conditions conditions(b.m);
  EXPECT_TRUE(conditions.assume(x, true));
  conditions.back_to(0);
  EXPECT_TRUE(conditions.assume(x, false));
}

// first ? a : (second && !first) ? b : second ? mark : c: nobody gets to the mark.
Build with_mark(bool is_guarded) {
  Build b("m");
  const NodeId first = b.input("first", 1), second = b.input("second", 1);
  const NodeId a = b.input("a", 8), c = b.input("c", 8);
  Node beyond;  // the four inputs
  beyond.op = Op::kInput;
  beyond.width = 8;
  beyond.index = 4;
  const NodeId mark = b.add(beyond);
  const NodeId rest = b.mux(is_guarded ? second : first, mark, c);
  const NodeId later = b.op(Op::kAnd, second, b.inv(first));
  b.output("y", b.mux(is_guarded ? first : second, a, b.mux(later, a, rest)));
  return b;
}

TEST(Reach, AMarkBehindAContradictionIsNotReached) {
  const Build b = with_mark(true);
  EXPECT_FALSE(Reach(b.m).find().has_value());
}

TEST(Reach, AMarkThatSomeConditionsLeadToIsReached) {
  const Build b = with_mark(false);
  EXPECT_EQ(Reach(b.m).find(), 0U);
}

}  // namespace
}  // namespace hlsgen
