#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "testbench/command/command.hpp"
#include "testbench/report/overlay.hpp"
#include "testbench/report/report.hpp"
#include "testbench/report/zoom.hpp"

namespace steplock {
namespace {

struct Arguments {
  std::string a, b, out;
};

int lay_over(const Arguments& arguments) {
  const RunFolder a(arguments.a), b(arguments.b);
  const std::filesystem::path out = arguments.out.empty() ? "out/overlay" : arguments.out;
  const std::vector<Figure> figures = overlay_figures(a, b);
  draw_all(figures, out);
  write_file(out / "overlay.html", overlay_page(a, b, figures, out));
  if (zoom_head().empty()) fmt::print(stderr, "steplock: {}\n", kNoZoom);
  fmt::print("wrote {}\n", (out / "overlay.html").string());
  return kWell;
}

}  // namespace

void add_report_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("report", "Lay two runs over each other: figures with a curve each, and their numbers side by side.");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("A", arguments->a, "folder of a run (--out of steplock run)")->required();
  command->add_option("B", arguments->b, "folder of another one")->required();
  command->add_option("--out", arguments->out, "folder of the page (default out/overlay)");
  command->footer("Example: steplock report out/m2310p_servo-rtl out/m2310p_servo-float");
  command->callback([arguments, &exit_code] { exit_code = lay_over(*arguments); });
}

}  // namespace steplock
