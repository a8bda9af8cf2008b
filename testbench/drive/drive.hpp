// The two drives as one: what differs between them for whoever runs, records and reports, each as a set of facts
// with the same names.  A command is written once, as a template over them:
//
//     with_drive(file.settings, [&](auto drive) { using Drive = decltype(drive); ... Drive::run(...) ... });
//
//     Record, Summary          what a run leaves, and what it amounts to
//     check(file, engine)      throws BadInput where an engine cannot play this file
//     run, summarise, report   as run_drive.hpp, summary.hpp and report.hpp say
//     shadow                   fixed against float on the same pins
//     wave()                   the signals of its wave
//     record_into(options, r)  where a drawn run of a sweep puts its record
//     range                    up to which speed it is measured, and how
//     simulate, disturb        one drawn run, and a sweep of disturbed ones; meets: which disturbances
//
// Rightly different, and so not here: the blocks, the references, the design rules, the verdicts and the papers.
//
// Doc: docs/report.md   Test: tests/testbench/drive_test.cpp
#pragma once

#include "testbench/drive/sinusoidal.hpp"
#include "testbench/drive/six_step.hpp"

namespace steplock {

template <class Use>
decltype(auto) with_drive(const design::Settings& s, Use&& use) {
  if (s.drive.kind == design::DriveKind::kSinusoidal) return use(SinusoidalDrive{});
  return use(SixStepDrive{});
}

}  // namespace steplock
