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
          "angle.", name_of(options.engine)),
      .departures = {
          {"phase detector", "compares the divided VCO with the back-EMF of one winding: once a turn (Figs. 2, 3, N = 6)",
           "compares all three windings, at each of the six steps of a turn (`loop.detector = \"every_step\"`); the "
           "paper's, with its filter, is unstable at hand-over: [run below](#the-papers-own-detector-one-crossing-a-turn)"},
          {"inertias", "printed in kg cm^2", "read in kg m^2"},
          {"winding of Figs. 8, 11 and 12", "that of Table 1, by which its speeds cannot be reached", "fewer turns, as each section says"},
          {"dry friction, the fan's drag, the limit's current", "not printed", "assumed, as the drive file says"},
          {"start", "reset, acceleration, speed control",
           "the same here (`start.method = \"ramp\"`), after a look for a turning rotor and one position pattern more; the default of other "
           "drives follows the rotor"},
          {"speed control", "its law is not printed", "PI"},
          {"off-time of the current limit (Fig. 9)", "its length, and which gates are off in it, are not printed",
           "all gates, for a quarter of `control.limit_off_time_s`, once the drive runs"},
          {"Hall sensors of Fig. 13", "their placement is not printed", "several, and the nearest"}}};
  const auto sections = {start_sequence, loop_response, locked_state, steady_state, current_control,
                         varied_load,    high_speed,    against_hall, own_detector, light_rotor};
  options.check_sections(1, static_cast<int>(sections.size()));
  int number = 0;
  for (const auto& section : sections) {
    if (options.wants(++number)) page.sections.push_back(section(drive, options));
  }
  return page;
}

}  // namespace steplock
