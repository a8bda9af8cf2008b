// One run of a sweep: drawn by its seed, simulated until its outcome is clear.
//
// The words are those of the drive file, the plant is the drawn one.  simulate() with the RTL beside
// the blocks tells whether every output agreed on every clock.
//
// Doc: docs/sweep.md   Test: tests/testbench/sweep_test.cpp
#pragma once

#include <functional>

#include "hls/six_step/config.hpp"
#include "model/design/parameters.hpp"
#include "testbench/drive/six_step/run.hpp"
#include "testbench/drive/sinusoidal/recorder.hpp"
#include "testbench/sweep/aftermath.hpp"
#include "testbench/sweep/conditions.hpp"
#include "testbench/sweep/disturbance.hpp"
#include "testbench/sweep/hardship.hpp"
#include "testbench/sweep/witness.hpp"

namespace steplock {

struct DrawnRun {
  RunSeed seed;
  design::Settings file;
  Conditions conditions;
  Hardship hardship;                // if the seed says so
  design::Settings settings;        // of the plant: the drawn ones
  design::Parameters parameters;    // of a six-step drive: the file's
  SixStepConfig config;                      // of a six-step drive: the file's
  double limit_s = 0;               // the start is over then, whatever became of it
  Disturbance disturbance;          // if the seed says so; its aftermath has limit_s anew
};

DrawnRun drawn_run(const design::Settings& file, RunSeed);

struct DrawnResult {
  Findings findings;            // of the start
  AfterFindings after;          // of the disturbance
  bool stopped = false;         // by go_on(): the findings mean nothing
  bool rtl_agrees = true;       // if it was beside
  std::string rtl_difference;   // where, if not
};

struct SimulateOptions {
  EngineKind engine = EngineKind::kFixed;
  bool rtl_beside = false;                    // kFixed only
  TraceWriter* trace = nullptr;
  Record* record = nullptr;                   // filled if given
  sinusoidal::Record* sinusoidal_record = nullptr;  // the same for the other kind of drive
  double record_s = 0;                        // length of the record, if known
  std::function<bool()> go_on = {};           // asked now and then
  // A negative control of rtl_beside, of a sinusoidal drive: one wrong bit in this clock.
  std::uint64_t spoil_clock = ~std::uint64_t{0};
};

DrawnResult simulate(const DrawnRun&, const SimulateOptions& = {});

}  // namespace steplock
