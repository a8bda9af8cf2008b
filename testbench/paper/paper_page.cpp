#include "testbench/paper/paper_page.hpp"

#include <fmt/format.h>

#include <cmath>

#include "testbench/report/report.hpp"

namespace steplock {
namespace {

// Four digits say what two drives have in common, more would be noise; large numbers keep their ones.
std::string number(double x) {
  if (std::abs(x) >= 1e4) return fmt::format("{:.0f}", x);
  return fmt::format("{:.4g}", std::abs(x) < 1e-12 ? 0 : x);
}

std::string with_unit(const std::string& value, const std::string& unit) {
  return unit.empty() ? value : value + " " + unit;
}

std::string verdict(const Claim& c) {
  switch (c.verdict) {
    case Verdict::kInput: return "input";
    case Verdict::kFitted: return "fitted";
    case Verdict::kReached: return "reached";
    case Verdict::kByNumbers: break;
  }
  if (!c.paper) return "";
  return std::abs(c.ours - *c.paper) <= std::abs(*c.paper) / 20 ? "reproduced" : "**not reproduced**";
}

std::string row(const Claim& c) {
  const std::string paper = c.paper ? with_unit(number(*c.paper), c.unit) : c.shown;
  std::string difference = "";
  if (c.paper && *c.paper != 0) {
    difference = fmt::format("{:+.1f} %", 100 * (c.ours - *c.paper) / std::abs(*c.paper));
  }
  return fmt::format("| {} | {} | {} | {} | {} | {} |\n", c.quantity, paper, with_unit(number(c.ours), c.unit), difference,
                     verdict(c), c.reason);
}

}  // namespace

std::string to_markdown(const PaperPage& page) {
  std::string text = fmt::format("# {}\n\n{}\n", page.title, page.introduction);
  if (!page.departures.empty()) {
    text += "\nWhere the drive of this page is another one than the paper's:\n\n| what | the paper | here |\n|---|---|---|\n";
    for (const Departure& d : page.departures) text += fmt::format("| {} | {} | {} |\n", d.what, d.paper, d.here);
  }
  text += "\n*Reproduced* is a number within a twentieth of the paper's. An *input* was given to the run, and says nothing; *fitted* is what comes out since "
          "something that the paper does not print was chosen so; *reached* is a limit that is kept.\n";
  for (const PaperSection& s : page.sections) {
    text += fmt::format("\n## {}\n\n{}\n", s.title, s.text);
    if (!s.claims.empty()) {
      text += "\n| quantity | paper | here | difference | verdict | why |\n|---|---|---|---:|---|---|\n";
      for (const Claim& c : s.claims) text += row(c);
    }
    for (const std::string& f : s.failures) text += fmt::format("\n**Does not hold:** {}\n", f);
    for (const Figure& f : s.figures) {
      text += fmt::format("\n![{}]({}/{}.svg)\n\n*{}*\n", f.title, page.name, f.name, f.caption);
    }
  }
  return text;
}

std::vector<std::filesystem::path> write_paper(const PaperPage& page,
                                               const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> written;
  for (const PaperSection& s : page.sections) {
    draw_all(s.figures, directory / page.name);
    for (const Figure& f : s.figures) {
      written.push_back(directory / page.name / (f.name + ".svg"));
    }
  }
  written.push_back(directory / (page.name + ".md"));
  write_file(written.back(), to_markdown(page));
  return written;
}

}  // namespace steplock
