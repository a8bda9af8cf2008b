// The files of a run of a six-step drive: summary, samples, figures, page, wave.
//
// Doc: docs/report.md   Test: tests/testbench/report_test.cpp
#pragma once

#include <filesystem>

#include "testbench/drive/six_step/summary.hpp"
#include "testbench/report/report.hpp"

namespace steplock {

PageContent page_content(const design::Settings&, const Summary&, const Record&);
ReportFiles write_report(const std::filesystem::path& directory, const design::Settings&, const Summary&,
                         const Record&, bool traced);

}  // namespace steplock
