// Sector decoder of the reference, against the signs of three sinusoids.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/reference/sector_decoder.hpp"

namespace steplock::reference {
namespace {

std::array<bool, 3> signs(double degrees) {
  std::array<bool, 3> code;
  for (int k = 0; k < 3; ++k) {
    code[k] = std::sin((degrees - 120 * k) * std::numbers::pi / 180) > 0;
  }
  return code;
}

TEST(ReferenceSectorDecoder, SectorIsSixtyDegreesOfTheBackEmf) {
  for (int degrees = 3; degrees < 360; degrees += 6) {
    EXPECT_EQ(SectorDecoder::sector_of(signs(degrees)), degrees / 60);
  }
  EXPECT_EQ(SectorDecoder::sector_of({false, false, false}), -1);
  EXPECT_EQ(SectorDecoder::sector_of({true, true, true}), -1);
}

TEST(ReferenceSectorDecoder, TellsTheDirection) {
  SectorDecoder decoder(0);
  decoder.update(0, signs(30));
  EXPECT_EQ(decoder.direction(), 0);  // the first one says nothing
  decoder.update(1, signs(90));
  EXPECT_EQ(decoder.direction(), 1);
  decoder.update(2, signs(30));  // one step back: chatter?
  EXPECT_EQ(decoder.direction(), 0);
  EXPECT_FALSE(decoder.settled());
  EXPECT_EQ(decoder.sector(), 0);
  decoder.update(3, signs(-30));  // a second one: no
  EXPECT_EQ(decoder.direction(), -1);
  decoder.update(4, signs(150));  // opposite: no direction
  EXPECT_TRUE(decoder.settled());
  EXPECT_EQ(decoder.direction(), 0);
}

TEST(ReferenceSectorDecoder, AnEdgeThatChattersForLongHasOneDirection) {
  SectorDecoder decoder(0);
  decoder.update(0, signs(30));
  int changes = 0;
  for (int k = 0; k < 9; ++k) {
    decoder.update(1 + k, signs(k % 2 ? 30 : 90));
    changes += decoder.direction();
  }
  EXPECT_EQ(changes, 1);
}

TEST(ReferenceSectorDecoder, WaitsUntilTheCodeHoldsStill) {
  SectorDecoder decoder(1e-5);
  decoder.update(0, signs(30));
  decoder.update(decoder.next(), signs(30));
  ASSERT_EQ(decoder.sector(), 0);
  double t = 1;
  for (int k = 0; k < 6; ++k, t += 5e-6) decoder.update(t, signs(k % 2 ? 30 : 90));  // chatter
  EXPECT_EQ(decoder.sector(), 0);
  decoder.update(t, signs(90));
  EXPECT_NEAR(decoder.next(), t + 1e-5, 1e-12);
  decoder.update(decoder.next(), signs(90));
  EXPECT_EQ(decoder.sector(), 1);
  EXPECT_EQ(decoder.direction(), 1);
}

}  // namespace
}  // namespace steplock::reference
