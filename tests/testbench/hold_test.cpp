// A start from rest that holds, one that cannot, and the page of many.
#include "testbench/range/hold.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/design/design.hpp"

namespace steplock {
namespace {

using testing::HasSubstr;

design::Settings joint() { return load_drive_file(STEPLOCK_DRIVES "/data_sheets/cubemars_ri20.toml").settings; }

TEST(Hold, AMotorThatTurnsIsHeld) {
  const Hold h = start_and_hold(joint());
  EXPECT_TRUE(h.held);
  ASSERT_TRUE(h.lock_s);
  EXPECT_LT(*h.lock_s, 0.1);
  EXPECT_EQ(h.lost_locks, 0);
  EXPECT_EQ(h.reason, "");
  EXPECT_NEAR(h.rpm, 5700, 57);  // a second later it is at its set speed
}

TEST(Hold, ARotorThatNothingMovesIsNot) {
  design::Settings s = joint();
  s.load.breakaway_nm = 3 * design::motor_constants(s).k_e * s.sensors.limit_a;
  const Hold h = start_and_hold(s);
  EXPECT_FALSE(h.held);
  EXPECT_FALSE(h.lock_s);
  EXPECT_NE(h.reason, "");
  EXPECT_NEAR(h.rpm, 0, 1);
}

TEST(Hold, ALineKeepsWhatItSays) {
  for (const Hold& h : {Hold{true, 0.125, 0, 5700.5, ""}, Hold{false, std::nullopt, 3, -2, "step_out"}}) {
    const Hold again = hold_of(to_line(h));
    EXPECT_EQ(again.held, h.held);
    EXPECT_EQ(again.lock_s, h.lock_s);
    EXPECT_EQ(again.lost_locks, h.lost_locks);
    EXPECT_EQ(again.rpm, h.rpm);
    EXPECT_EQ(again.reason, h.reason);
  }
}

TEST(Hold, ThePageCountsAndNamesWhatIsNotHeld) {
  std::vector<HeldMotor> all(50, {"good", joint(), {true, 0.1, 0, 5700, ""}});
  all[3] = {"bad", joint(), {false, 0.25, 2, 12, "step_out"}};
  const std::string page = decades_page(all, "tools/decades 50", 7);
  EXPECT_THAT(page, HasSubstr("| 50 | 98.00 % | 90.86 % | 0 | 0.1 | 0.1 | 0.1 |"));  // Clopper and Pearson, 49 of 50
  EXPECT_THAT(page, HasSubstr("| 10000 to 100000 | 50 | 49 | 0.1 | 0.1 |"));
  EXPECT_THAT(page, HasSubstr("bad: 12 of 5700 r/min at the end, 2 locks lost, step_out."));
  EXPECT_THAT(page, HasSubstr("`steplock motors --decades --count 50 --seed 7`"));
}

}  // namespace
}  // namespace steplock
