// What phase detector, loop filter and speed control were given in a run of the blocks, update by update, and what they made of it.
//
// Doc: docs/report.md   Test: tests/testbench/law_errors_test.cpp
#pragma once

#include <functional>
#include <vector>

#include "hls/six_step/loop_filter_law.hpp"
#include "hls/six_step/speed_control_law.hpp"
#include "model/design/settings.hpp"

namespace steplock {

struct DetectorInput {
  double time = 0;                // s
  bool crossing = false;          // else the step ended without one
  bool before_seen = false;       // the level before a crossing showed in it; of a run told by the answer, of corners given
  Phase crossing_phase = 0;       // u0.16
  PhaseError error = 0;           // s0.16: the block's answer
  bool begins = false;            // the step before was not watched
};
struct LoopInput {
  double time = 0;
  LoopFilterLaw::In in;
  Frequency before = 0, after = 0;  // u0.32: the block's output
  bool begins = false;              // the loop was open before
};
struct SpeedInput {
  double time = 0;
  SpeedControlLaw::In in;  // kControl, or the duty that the block put out, as kFixed
  Duty after = 0;          // u1.15: the block's answer
  bool disturbed = false;  // an input changed while the block was at work
};
struct LawInputs {
  std::vector<DetectorInput> detector;
  std::vector<LoopInput> loop;
  std::vector<SpeedInput> speed;
};

// Runs the scenario with the blocks.  `shaken`: the host asks for another set speed time and again, so that neither loop ever rests.
LawInputs law_inputs(const design::Settings&, double angle_deg, bool shaken, const std::function<bool(double done)>& progress = {});

}  // namespace steplock
