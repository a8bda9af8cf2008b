// Reads gate events from CSV: the header `time_s,uh,ul,vh,vl,wh,wl,load_nm`, then one event a line.
//
// Times do not fall, gates are 0 or 1, the load torque is opposing and not negative.  Anything else
// is refused as `file:line: what; how to mend`.
//
// Doc: docs/steplock.md   Test: tests/testbench/gate_events_test.cpp
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "model/plant/replay.hpp"

namespace steplock {

std::vector<plant::GateEvent> read_gate_events(std::istream&, const std::string& path);

}  // namespace steplock
