#include "testbench/paper/paper_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/paper/amano2003.hpp"

namespace steplock {
namespace {

using testing::HasSubstr;

PaperPage page_with(const Claim& claim) {
  return {.name = "p", .title = "P", .introduction = "i",
          .sections = {{.title = "Fig. 1", .text = "t", .claims = {claim}}}};
}

TEST(PaperPage, ShowsThePapersNumberOursAndTheDifference) {
  EXPECT_THAT(to_markdown(page_with({"speed", "r/min", 200, "", 210, "why not"})),
              HasSubstr("| speed | 200 r/min | 210 r/min | +5.0 % | reproduced | why not |"));
}

TEST(PaperPage, PrintsLargeNumbersInFull) {
  EXPECT_THAT(to_markdown(page_with({"speed", "r/min", 21000, "", 20987.4, ""})),
              HasSubstr("| speed | 21000 r/min | 20987 r/min | -0.1 % | reproduced |  |"));
}

TEST(PaperPage, SaysInWordsWhereThePaperHasNoNumber) {
  EXPECT_THAT(to_markdown(page_with({"current", "A", {}, "smaller", 2.5, ""})),
              HasSubstr("| current | smaller | 2.5 A |  |  |  |"));
}

// A twentieth is the bound; what was given to a run, or chosen so that it comes out, is said to be.
TEST(PaperPage, SaysWhatBecameOfEachNumber) {
  EXPECT_THAT(to_markdown(page_with({"t", "s", 1, "", 1.06, ""})), HasSubstr("| +6.0 % | **not reproduced** |"));
  EXPECT_THAT(to_markdown(page_with({"lost", "", 0, "", 0, ""})), HasSubstr("| 0 | 0 |  | reproduced |"));
  EXPECT_THAT(to_markdown(page_with({"lost", "", 0, "", 1, ""})), HasSubstr("| 0 | 1 |  | **not reproduced** |"));
  EXPECT_THAT(to_markdown(page_with({"t", "s", 1, "", 1, "", Verdict::kInput})), HasSubstr("| input |"));
  EXPECT_THAT(to_markdown(page_with({"t", "s", 1, "", 1, "", Verdict::kFitted})), HasSubstr("| fitted |"));
  EXPECT_THAT(to_markdown(page_with({"t", "s", 1, "", 0.5, "", Verdict::kReached})), HasSubstr("| reached |"));
}

TEST(PaperPage, NamesWhereItsDriveIsAnotherOneThanThePapers) {
  PaperPage page = page_with({"speed", "", 1, "", 1, ""});
  page.departures = {{"detector", "one winding", "three"}};
  EXPECT_THAT(to_markdown(page), HasSubstr("| detector | one winding | three |"));
}

TEST(PaperPage, ShowsWhatDoesNotHold) {
  PaperPage page = page_with({"speed", "", 1, "", 1, ""});
  EXPECT_THAT(to_markdown(page), testing::Not(HasSubstr("Does not hold")));
  page.sections[0].failures.push_back("the lock");
  EXPECT_THAT(to_markdown(page), HasSubstr("**Does not hold:** the lock"));
}

TEST(Amano2003, ARewoundWindingKeepsItsCopper) {
  const auto s = load_drive_file(STEPLOCK_DRIVES "/amano2003.toml").settings;
  const auto half = amano2003::rewound(s, 0.5);
  EXPECT_DOUBLE_EQ(half.motor.flux_vs, s.motor.flux_vs / 2);
  // The same torque takes twice the current: the same loss, and the same stored energy.
  EXPECT_DOUBLE_EQ(half.motor.resistance_ohm * 4, s.motor.resistance_ohm);
  EXPECT_DOUBLE_EQ(half.motor.inductance_h * 4, s.motor.inductance_h);
}

TEST(Amano2003, AnUnsoundRunIsRefusedByName) {
  auto s = load_drive_file(STEPLOCK_DRIVES "/amano2003.toml").settings;
  try {
    amano2003::run_trial(amano2003::steady_run(s, 9000, 1), {}, EngineKind::kFixed, "Fig. 0");
    FAIL() << "9000 r/min are beyond 12 V";
  } catch (const std::runtime_error& e) {
    EXPECT_THAT(e.what(), HasSubstr("Fig. 0: scenario.speed_rpm is 9000"));
  }
}

}  // namespace
}  // namespace steplock
