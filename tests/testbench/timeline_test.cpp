#include "testbench/run/timeline.hpp"

#include <gtest/gtest.h>

#include "model/design/design.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

TEST(Timeline, EventsStandAtTheirClocksInOrder) {
  const design::Settings s = short_drive();
  const Timeline t = timeline(s);
  ASSERT_EQ(t.events.size(), 6u);
  const char* const names[] = {"gates off", "run", "load step", "load off", "reverse", "stop"};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(t.events[i].what, names[i]);
  EXPECT_EQ(t.events[1].clock, 12000u);
  EXPECT_EQ(t.events[2].clock, 4800000u);
  EXPECT_EQ(t.clocks, 16800000u);  // 1.4 s of 12 MHz
  EXPECT_DOUBLE_EQ(t.steady_end_s, 0.4);
}

TEST(Timeline, CommandsAndLoadHoldUntilTheyAreChanged) {
  const Timeline t = timeline(short_drive());
  EXPECT_FALSE(t.events[0].command.run);
  EXPECT_TRUE(t.events[1].command.run);
  EXPECT_DOUBLE_EQ(t.events[2].load_nm, design::load_step_torque(short_drive()));
  EXPECT_EQ(t.events[3].load_nm, 0);
  EXPECT_FALSE(t.events[3].command.reverse);
  EXPECT_TRUE(t.events[4].command.reverse);
  EXPECT_TRUE(t.events[4].command.run);
  EXPECT_FALSE(t.events[5].command.run);
}

TEST(Timeline, ACoupledMassStaysCoupled) {
  design::Settings s = short_drive();
  s.scenario.inertia_step_s = 0.4;
  const Timeline t = timeline(s);
  ASSERT_EQ(t.events.size(), 7u);
  EXPECT_EQ(t.events[3].what, "inertia step");
  EXPECT_EQ(t.events[2].inertia_kgm2, 0);
  EXPECT_DOUBLE_EQ(t.events[3].inertia_kgm2, 3 * (s.motor.inertia_kgm2 + s.load.inertia_kgm2));
  EXPECT_EQ(t.events[6].inertia_kgm2, t.events[3].inertia_kgm2);
  s.scenario.inertia_step_kgm2 = 1e-5;
  EXPECT_DOUBLE_EQ(timeline(s).events[3].inertia_kgm2, 1e-5);
}

}  // namespace
}  // namespace steplock
