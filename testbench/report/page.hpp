// A run as one self-contained HTML page: verdict, figures, numbers, what the drive did when, and where
// the motor's numbers come from.  No script, no font, no link: it can be mailed.
//
// Doc: docs/report.md   Test: tests/testbench/report_test.cpp
#pragma once

#include <string>
#include <vector>

#include "testbench/run/summary.hpp"

namespace steplock {

struct PageFigure {
  std::string caption, svg;
};

std::string report_page(const design::Settings&, const Summary&, const Record&,
                        const std::vector<PageFigure>&);

// Title and body in the frame and style that all pages share.
std::string html_page(const std::string& title, const std::string& body);

// The text as HTML shows it.
std::string escaped(const std::string&);

}  // namespace steplock
