// What makes a figure of a page one that can be zoomed and read off (zoom.js): Dygraphs, which is in Debian, in the page
// itself, so that it works offline and can be mailed.  Without script, or where Dygraphs is not installed, the figure's SVG
// is shown.
//
// Doc: docs/report.md   Test: tests/testbench/report_test.cpp, tests/testbench/zoom.sh
#pragma once

#include <filesystem>
#include <string>

#include "testbench/report/figure.hpp"

namespace steplock {

inline constexpr const char* kDygraphs = "/usr/share/javascript/dygraphs";  // of libjs-dygraphs

// For the page's head: library, style and zoom.js.  Empty if the library is not in that folder.
std::string zoom_head(const std::filesystem::path& library = kDygraphs);
inline constexpr const char* kNoZoom = "the page's figures cannot be zoomed; install libjs-dygraphs";  // to be said then
// For the figure's element, behind its SVG.  Empty if its axis is logarithmic.
std::string zoom_body(const Figure&);

}  // namespace steplock
