// VCO and divider of the reference: exact instants, both directions.
#include <gtest/gtest.h>

#include "model/reference/oscillator.hpp"

namespace steplock::reference {
namespace {

TEST(ReferenceOscillator, CommutatesOncePerTurn) {
  Oscillator vco;
  vco.set_frequency(0, 250);
  double t = 0;
  for (int k = 1; k <= 13; ++k) {
    t = vco.next();
    vco.update(t, false);
    ASSERT_TRUE(vco.commutated());
    EXPECT_NEAR(t, k / 250.0, 1e-12);
    EXPECT_EQ(vco.step(), k % 6);
  }
}

TEST(ReferenceOscillator, CountsDownInReverse) {
  Oscillator vco;
  vco.set_frequency(0, 100);
  vco.update(vco.next(), true);
  EXPECT_EQ(vco.step(), 5);
}

TEST(ReferenceOscillator, KeepsItsPhaseWhenTheFrequencyChanges) {
  Oscillator vco;
  vco.set_frequency(0, 100);
  vco.set_frequency(0.004, 300);  // at 0.4 turns
  EXPECT_NEAR(vco.phase(0.004), 0.4, 1e-12);
  EXPECT_NEAR(vco.phase(0.005), 0.7, 1e-12);
  EXPECT_NEAR(vco.next(), 0.006, 1e-12);
}

TEST(ReferenceOscillator, StandsStillWithoutFrequency) {
  Oscillator vco;
  vco.load(0, 3, 0.5);
  EXPECT_EQ(vco.next(), kNever);
  EXPECT_EQ(vco.phase(1), 0.5);
  vco.set_frequency(1, 50);
  EXPECT_NEAR(vco.next(), 1.01, 1e-12);
}

}  // namespace
}  // namespace steplock::reference
