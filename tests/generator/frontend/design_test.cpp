#include "tests/generator/frontend/against_native.hpp"
#include "tests/generator/frontend/blocks/accumulator.hpp"
#include "tests/generator/frontend/blocks/arrays.hpp"
#include "tests/generator/frontend/blocks/calls.hpp"
#include "tests/generator/frontend/blocks/control.hpp"
#include "tests/generator/frontend/blocks/hierarchy.hpp"
#include "tests/generator/frontend/blocks/named.hpp"
#include "tests/generator/frontend/blocks/library.hpp"
#include "tests/generator/frontend/blocks/numbers.hpp"
#include "tests/generator/frontend/blocks/regressions.hpp"
#include "tests/generator/frontend/blocks/scheduled.hpp"

namespace hlsgen::test {
namespace {

using namespace steplock::test;

TEST(Design, AnAccumulatorEqualsItsCpp) {
  expect_equal_to_native<PhaseAccumulator<>>("phase_accumulator");
}
TEST(Design, TemplateArgumentsReachTheModule) {
  expect_equal_to_native<PhaseAccumulator<12, 3>>("phase_accumulator_12_3");
}
TEST(Design, AStateMachineEqualsItsCpp) { expect_equal_to_native<StateMachine>("state_machine"); }
TEST(Design, ARegisterOfAnEnumerationStaysWithinIt) {
  expect_equal_to_native<SectorCounter>("sector_counter");
}
TEST(Design, LoopsEqualTheirCpp) { expect_equal_to_native<Loops<11>>("loops_11"); }
TEST(Design, ArraysEqualTheirCpp) { expect_equal_to_native<History>("history"); }
TEST(Design, TablesEqualTheirCpp) { expect_equal_to_native<Tables>("tables"); }
TEST(Design, ArithmeticEqualsItsCpp) { expect_equal_to_native<Arithmetic>("arithmetic"); }
TEST(Design, NumbersUpTo128BitsEqualTheirCpp) { expect_equal_to_native<Wide>("wide"); }
TEST(Design, PlainIntegersKeepTheirPromotions) { expect_equal_to_native<Plain>("plain"); }
TEST(Design, HelpersAndReferencesEqualTheirCpp) { expect_equal_to_native<Calls>("calls"); }
TEST(Design, NamesChangeNothing) { expect_equal_to_native<Named>("named"); }
TEST(Design, BlocksWithinBlocksEqualTheirCpp) { expect_equal_to_native<Hierarchy>("hierarchy"); }

// In every clock: starts while busy, ignored or not, and results that stand still.
TEST(Design, AScheduleWithinABlockEqualsItsCpp) { expect_equal_to_native<HeldFilter>("held_filter_25_16_17"); }
TEST(Design, AScheduleOfABlockOfBlocksEqualsItsCpp) { expect_equal_to_native<HeldCascade>("held_cascade_18_18_66"); }

// Once wrong, refused, or without end.
TEST(Regression, EarlyReturnsLeaveNoValueUnwritten) {
  expect_equal_to_native<EarlyReturns>("early_returns");
}
TEST(Regression, ASwitchMayHangOnWhatIsMergedAboveIt) {
  expect_equal_to_native<SwitchBehindSwitch>("switch_behind_switch");
}
TEST(Regression, AClosureMayBeCalledInALoop) { expect_equal_to_native<Closure>("closure"); }
TEST(Regression, AWhileLoopWithContinueHasABound) {
  expect_equal_to_native<ContinueInWhile>("continue_in_while");
}
TEST(Regression, WhatLlvmRewritesIsTaken) { expect_equal_to_native<Rewritten>("rewritten"); }
TEST(Regression, ALimitedIndexProvesByItsBits) {
  expect_equal_to_native<LimitedIndex>("limited_index");
}
TEST(Regression, TablesOfOneNameMayDifferInWidth) {
  expect_equal_to_native<TablesOfOneName>("tables_of_one_name");
}
TEST(Regression, TheStandardLibraryIsRead) {
  expect_equal_to_native<LetterCounter>("letter_counter", 20'000, "library.cpp");
}

}  // namespace
}  // namespace hlsgen::test
