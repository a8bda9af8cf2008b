#include "hls/numeric/one_hot.hpp"

#include <gtest/gtest.h>

namespace steplock {
namespace {

enum class Colour : std::uint8_t { kRed, kGreen, kBlue };
using Colours = OneHot<Colour, 3>;

TEST(OneHot, HoldsTheValueItWasMadeOfAndNoOther) {
  for (const Colour one : {Colour::kRed, Colour::kGreen, Colour::kBlue}) {
    for (const Colour other : {Colour::kRed, Colour::kGreen, Colour::kBlue}) {
      EXPECT_EQ(Colours(one).holds(other), one == other);
    }
    EXPECT_EQ(Colours(one).value(), one);
  }
}

TEST(OneHot, TheSetsOfTwoAreJoined) {
  const Colours warm = Colours(Colour::kRed) | Colours(Colour::kGreen);
  EXPECT_TRUE(warm.holds(Colour::kRed));
  EXPECT_TRUE(warm.holds(Colour::kGreen));
  EXPECT_FALSE(warm.holds(Colour::kBlue));
  EXPECT_TRUE(warm.holds_one_of(Colour::kBlue, Colour::kGreen));
  EXPECT_FALSE(Colours(Colour::kRed).holds_one_of(Colour::kBlue, Colour::kGreen));
}

TEST(OneHot, NothingIsLeftOfASetOnAFalseCondition) {
  const Colours red = Colour::kRed;
  EXPECT_EQ(red.when(true), red);
  EXPECT_EQ(red.when(false), Colours());
  EXPECT_FALSE(red.when(false).holds_one_of(Colour::kRed, Colour::kGreen, Colour::kBlue));
}

TEST(OneHot, TheSuccessorOfTheLastIsTheFirst) {
  EXPECT_EQ(Colours(Colour::kRed).next(), Colours(Colour::kGreen));
  EXPECT_EQ(Colours(Colour::kBlue).next(), Colours(Colour::kRed));
}

}  // namespace
}  // namespace steplock
