// Reference and laws update by update: they agree to the last places that words drop, and one percent of a coefficient shows.
#include "testbench/compare/law_errors.hpp"

#include <gtest/gtest.h>

#include "testbench/compare/coefficients.hpp"
#include "testbench/compare/corner_inputs.hpp"
#include "testbench/drive_file/drive_file.hpp"

namespace steplock {
namespace {

// A loop per step and one per second.
class LawErrors : public testing::TestWithParam<const char*> {
 protected:
  static const Told& told() {
    static const Told of[] = {tell("bly172s"), tell("amano2003")};
    return of[std::string(GetParam()) == "amano2003"];
  }

 private:
  static Told tell(const std::string& drive) {
    const auto s = load_drive_file(STEPLOCK_DRIVES "/" + drive + ".toml").settings;
    return told_of(s, s.scenario.start_angle_deg);
  }
};

TEST_P(LawErrors, AreWithinWhatWordsDrop) {
  for (const LawInputs* inputs : {&told().run, &told().corners}) {
    for (const LawError& e : law_errors(*inputs, told().parameters, told().clock_hz)) {
      EXPECT_TRUE(e.within()) << e.signal << ": " << e.worst << ", at most " << e.bound << ", at " << e.at_s << " s";
      EXPECT_GT(e.updates, 10u) << e.signal;
    }
  }
}

// What is held against the reference is what the blocks did, until an input changed while one was at work.
TEST_P(LawErrors, AreThoseOfTheBlocks) {
  for (const LawError& e : law_errors(told().run, told().parameters, told().clock_hz)) {
    EXPECT_EQ(e.unlike, 0u) << e.signal;
  }
}

TEST_P(LawErrors, ShowWhatIsAskedForOfEachCoefficient) {
  for (const Sensitivity& s : sensitivities(told())) EXPECT_TRUE(s.noticed()) << s.name << ": " << s.least << ", asked " << s.asked;
}

// The controls of the table: a block that answers one place more now and then, and one whose words are others, are noticed.
TEST_P(LawErrors, ThatABlockMakesAreNoticed) {
  LawInputs wrong = told().run;
  wrong.detector.back().error = wrap<PhaseError>(wrong.detector.back().error + 1);
  EXPECT_FALSE(law_errors(wrong, told().parameters, told().clock_hz)[0].within());
  wrong = told().run;
  for (auto& u : wrong.speed) u.in.config.ki = UInt<16>::of(u.in.config.ki.raw() * 51 / 50);
  for (auto& u : wrong.loop) u.in.kp = UInt<16>::of(u.in.kp.raw() * 51 / 50);
  const auto found = law_errors(wrong, told().parameters, told().clock_hz);
  EXPECT_FALSE(found[1].within());
  EXPECT_FALSE(found[2].within());
  EXPECT_GT(found[1].unlike, 0u);
  EXPECT_GT(found[2].unlike, 0u);
}

INSTANTIATE_TEST_SUITE_P(Drives, LawErrors, testing::Values("bly172s", "amano2003"), [](const auto& info) { return info.param; });

}  // namespace
}  // namespace steplock
