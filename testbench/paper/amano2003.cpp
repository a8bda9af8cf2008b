#include "testbench/paper/amano2003.hpp"

#include <fmt/format.h>

namespace steplock {

PaperPage amano2003_page(const design::Settings& file, const PaperOptions& options) {
  using namespace amano2003;
  design::Settings drive = file;
  drive.start.method = design::Method::kRamp;  // the paper's
  PaperPage page{
      .name = "amano2003",
      .title = "Amano et al. 2003, side by side",
      .introduction = fmt::format(
          "Printed by `steplock paper amano2003` with engine `{}`; the test `pages_are_current_amano2003` fails when this "
          "page is stale. Motor and fan: [amano2003.toml](../../drives/amano2003.toml), which says how the "
          "paper's inconsistent units are read. Speeds and lost steps are judged from the plant's true "
          "angle.", name_of(options.engine))};
  const auto sections = {start_sequence, loop_response, locked_state, steady_state, current_control,
                         varied_load,    high_speed,    against_hall, light_rotor};
  options.check_sections(1, static_cast<int>(sections.size()));
  int number = 0;
  for (const auto& section : sections) {
    if (options.wants(++number)) page.sections.push_back(section(drive, options));
  }
  return page;
}

}  // namespace steplock
