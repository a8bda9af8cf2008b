#include "testbench/drive_file/gate_events.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock {
namespace {

const std::string kHeader = "time_s,uh,ul,vh,vl,wh,wl,load_nm\n";

std::vector<plant::GateEvent> read(const std::string& text) {
  std::istringstream in(text);
  return read_gate_events(in, "g.csv");
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const BadInput& e) {
    return e.what();
  }
  return "accepted";
}

TEST(GateEvents, EveryColumnLandsInItsPlace) {
  const auto events = read(kHeader + "0,1,0,0,1,0,0,0\n1e-3, 0, 1, 1, 0, 0, 1, 0.25\r\n");
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].gates, (plant::Gates{.uh = true, .vl = true}));
  EXPECT_EQ(events[1].gates, (plant::Gates{.ul = true, .vh = true, .wl = true}));
  EXPECT_EQ(events[1].time, 1e-3);
  EXPECT_EQ(events[1].load_torque, 0.25);
}

TEST(GateEvents, BadLinesAreRefusedWithTheirNumber) {
  EXPECT_EQ(refusal(""), "g.csv:1: the file is empty; the first line must be "
                         "time_s,uh,ul,vh,vl,wh,wl,load_nm");
  EXPECT_EQ(refusal("t,u\n"), "g.csv:1: the first line must be time_s,uh,ul,vh,vl,wh,wl,load_nm");
  EXPECT_EQ(refusal(kHeader), "g.csv:1: no events; add at least one line below the header");
  EXPECT_EQ(refusal(kHeader + "0,1,0\n"),
            "g.csv:2: 3 columns; write 8: time_s,uh,ul,vh,vl,wh,wl,load_nm");
  EXPECT_EQ(refusal(kHeader + "0,1,0,0,1,0,2,0\n"), "g.csv:2: wl is \"2\"; write 0 or 1");
  EXPECT_EQ(refusal(kHeader + "zero,1,0,0,1,0,0,0\n"), "g.csv:2: time_s is \"zero\"; write a number");
  EXPECT_EQ(refusal(kHeader + "nan,1,0,0,1,0,0,0\n"), "g.csv:2: time_s is \"nan\"; write a number");
  EXPECT_EQ(refusal(kHeader + "-1,1,0,0,1,0,0,0\n"),
            "g.csv:2: time_s is -1; start at 0 or later");
  EXPECT_EQ(refusal(kHeader + "2,0,0,0,0,0,0,0\n1,0,0,0,0,0,0,0\n"),
            "g.csv:3: time_s falls from 2 to 1; sort the events");
  EXPECT_EQ(refusal(kHeader + "0,0,0,0,0,0,0,-1\n"),
            "g.csv:2: load_nm is -1; an opposing torque is not negative");
}

}  // namespace
}  // namespace steplock
