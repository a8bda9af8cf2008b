#include "testbench/report/page.hpp"

#include <fmt/format.h>

#include <cmath>

#include "testbench/report/zoom.hpp"

namespace steplock {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light; }
body { font: 15px/1.55 system-ui, "Segoe UI", Helvetica, Arial, sans-serif; color: #22313f;
       background: #f5f7fa; margin: 0; }
main { max-width: 1000px; margin: 0 auto; padding: 32px 20px 64px; }
h1 { font-size: 26px; margin: 0; } h2 { font-size: 18px; margin: 40px 0 12px; }
.sub { color: #616e7c; margin: 4px 0 20px; }
.verdict { display: inline-block; border-radius: 999px; padding: 3px 14px; font-weight: 600;
           font-size: 14px; vertical-align: 4px; margin-left: 12px; }
.well { background: #d5f5e3; color: #14532d; } .failed { background: #fadbd8; color: #7b241c; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(200px, 1fr)); gap: 12px; }
.card, figure, .box { background: #fff; border: 1px solid #e4e7eb; border-radius: 10px; }
.card { padding: 12px 14px; } .card b { display: block; font-size: 21px; font-weight: 600; }
.card span { color: #616e7c; font-size: 13px; }
figure { margin: 16px 0; padding: 12px; } figure svg { width: 100%; height: auto; display: block; }
figcaption { color: #52606d; font-size: 14px; padding: 6px 8px 2px; }
.box { padding: 4px 16px; overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
td, th { text-align: left; padding: 6px 10px 6px 0; border-bottom: 1px solid #eef1f4; }
tr:last-child td { border-bottom: 0; } th { color: #616e7c; font-weight: 500; }
td:first-child { white-space: nowrap; } li { margin: 2px 0; }
)";

std::string row(const std::string& a, const std::string& b) {
  return fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", a, b);
}

std::string all_numbers(const nlohmann::ordered_json& json) {
  std::string rows;
  for (const auto& [name, value] : json.items()) {
    if (name == "fixed_against_float") continue;  // has a table of its own
    if (value.is_object()) {
      for (const auto& [inner, v] : value.items()) rows += row(name + "." + inner, number_text(v));
    } else {
      rows += row(name, escaped(number_text(value)));
    }
  }
  return rows;
}

std::string float_errors(const FloatErrors& e) {
  std::string t = fmt::format(
      "<h2>Fixed point against floating point</h2>\n<p>On the same pins, {} {} from "
      "{:.3f} to {:.3f} s.</p>\n<div class=\"box\"><table>\n<tr><th>signal</th><th>mean</th>"
      "<th>rms</th><th>budget</th><th>worst</th><th>budget</th><th></th></tr>\n",
      e.count, e.compared, e.from_s, e.to_s);
  for (const SignalError& s : e.signals) {
    t += fmt::format("<tr><td>{}, {}</td><td>{:.2e}</td><td>{:.2e}</td><td>{:.2e}</td>"
                     "<td>{:.2e}</td><td>{:.2e}</td><td>{}</td></tr>\n",
                     s.budget.name, s.budget.unit, s.mean, s.rms, s.budget.rms_allowed(),
                     s.greatest, s.budget.bound, s.within() ? "within" : "BEYOND");
  }
  return t + "</table></div>\n";
}

}  // namespace

std::string html_page(const std::string& title, const std::string& body, const std::string& head) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{} - Steplock</title>\n<style>{}</style>\n{}</head>\n<body>\n<main>\n{}"
      "</main>\n</body>\n</html>\n",
      title, kStyle, head, body);
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

std::string number_text(const nlohmann::ordered_json& v) {
  if (v.is_null()) return "-";
  if (v.is_string()) return v.get<std::string>();
  if (v.is_number_float()) return fmt::format("{:.6g}", v.get<double>());
  return v.dump();
}

std::string figures_html(const std::vector<PageFigure>& figures) {
  std::string all;
  for (const PageFigure& f : figures) {
    all += fmt::format("<figure>\n{}\n{}<figcaption>{}</figcaption>\n</figure>\n", f.svg, f.zoom, escaped(f.caption));
  }
  return all;
}

std::string report_page(const PageContent& content, const std::vector<PageFigure>& figures) {
  const bool well = content.failures.empty();
  std::string page = fmt::format("<h1>{}<span class=\"verdict {}\">{}</span></h1>\n<p class=\"sub\">{}</p>\n",
                                 escaped(content.drive.name), well ? "well" : "failed", well ? "passed" : "failed",
                                 escaped(content.what));
  const auto list = [&](const std::vector<std::string>& lines) {
    page += "<ul>\n";
    for (const std::string& line : lines) page += fmt::format("<li>{}</li>\n", escaped(line));
    page += "</ul>\n";
  };
  std::vector<std::string> said = content.failures;
  for (const std::string& line : content.advice) said.push_back("advice: " + line);
  if (!said.empty()) list(said);

  page += "<div class=\"cards\">\n";
  for (const auto& [figure, name] : content.cards) {
    page += fmt::format("<div class=\"card\"><b>{}</b><span>{}</span></div>\n", escaped(figure), escaped(name));
  }
  page += "</div>\n<h2>What happened</h2>\n";
  page += figures_html(figures);

  page += "<h2>The drive's states</h2>\n<div class=\"box\"><table>\n"
          "<tr><th>time</th><th>state</th><th>reason</th></tr>\n";
  for (const PageContent::Change& c : content.changes) {
    page += fmt::format("<tr><td>{:.6f} s</td><td>{}</td><td>{}</td></tr>\n", c.time, c.state, c.reason);
  }
  page += "</table></div>\n";
  if (content.float_errors) page += float_errors(*content.float_errors);
  page += "<h2>All numbers</h2>\n<div class=\"box\"><table>\n" + all_numbers(content.numbers) + "</table></div>\n";

  page += fmt::format("<h2>Where the motor's numbers come from</h2>\n<div class=\"box\"><p>{}</p>\n",
                      escaped(content.drive.source));
  if (!content.drive.notes.empty()) page += fmt::format("<p>{}</p>\n", escaped(content.drive.notes));
  if (!content.drive.assumed.empty()) {
    page += "<p>Assumed, because nobody publishes it:</p>\n";
    list(content.drive.assumed);
  }
  return html_page(escaped(content.drive.name), page + "</div>\n", zoom_head());
}

}  // namespace steplock
