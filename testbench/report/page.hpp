// A run as one self-contained HTML page: verdict, figures, numbers, what the drive did when, and where
// the motor's numbers come from.  It loads nothing, so it can be mailed.
//
// Doc: docs/report.md   Test: tests/testbench/report_test.cpp
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/design/settings.hpp"
#include "testbench/run/float_errors.hpp"

namespace steplock {

struct PageFigure {
  std::string caption, svg;
  std::string zoom = {};  // zoom_body(): what makes it one that can be zoomed
};

// What the page of a run of either drive shows.  Text is plain; the page escapes it.
struct PageContent {
  struct Change {
    double time;
    std::string state, reason;  // the reason is empty if there is none
  };
  design::DriveSection drive;
  std::string what;                                        // a sentence under the name
  std::vector<std::string> failures;
  std::vector<std::string> advice;  // what to change, whether it failed or not
  std::vector<std::pair<std::string, std::string>> cards;  // a figure and what it is
  std::vector<Change> changes;
  std::optional<FloatErrors> float_errors;
  nlohmann::ordered_json numbers;                          // all of them
};

std::string report_page(const PageContent&, const std::vector<PageFigure>&);

// Each with its caption below it.
std::string figures_html(const std::vector<PageFigure>&);
// A value of a summary as a table shows it.
std::string number_text(const nlohmann::ordered_json&);

// Title and body in the frame and style that all pages share; more for the head, such as zoom_head().
std::string html_page(const std::string& title, const std::string& body, const std::string& head = {});

// The text as HTML shows it.
std::string escaped(const std::string&);

}  // namespace steplock
