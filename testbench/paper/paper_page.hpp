// A paper held against this drive, figure by figure: what it shows, what ours does, the difference
// and its reason; as one page of Markdown with its figures beside it.
//
// Doc: docs/steplock.md   Test: tests/testbench/paper_page_test.cpp
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "testbench/report/figure.hpp"

namespace steplock {

// What became of a number of the paper.
enum class Verdict {
  kByNumbers,  // reproduced if ours is within a twentieth of the paper's, else not; none where the paper has no number
  kInput,      // it was given to the run, so that it says nothing
  kFitted,     // something that the paper does not print was chosen so that it comes out
  kReached     // a limit that ours had to keep, and does
};

// One number of the paper.  Where it prints none, `shown` says in words what can be seen.
struct Claim {
  std::string quantity, unit;
  std::optional<double> paper;
  std::string shown = {};
  double ours = 0;
  std::string reason = {};  // of the difference
  Verdict verdict = Verdict::kByNumbers;
};

// Where the drive of a page is another one than the paper's.
struct Departure {
  std::string what, paper, here;
};

struct PaperSection {
  std::string title;       // "Fig. 7: ..."
  std::string text;        // how ours was made
  std::vector<Claim> claims = {};
  std::vector<Figure> figures = {};
  std::vector<std::string> failures = {};  // what should hold and does not
};

struct PaperPage {
  std::string name;        // of the page and of its folder of figures
  std::string title, introduction;
  std::vector<Departure> departures = {};
  std::vector<PaperSection> sections = {};
};

std::string to_markdown(const PaperPage&);
// Writes <directory>/<name>.md and <directory>/<name>/*.svg; returns what was written.  Throws
// std::runtime_error if gnuplot does not run or a file cannot be written.
std::vector<std::filesystem::path> write_paper(const PaperPage&, const std::filesystem::path& directory);

}  // namespace steplock
