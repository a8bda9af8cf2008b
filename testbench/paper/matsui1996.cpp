#include "testbench/paper/matsui1996.hpp"

#include <fmt/format.h>

#include "hls/sinusoidal/sinusoidal_top.hpp"

namespace steplock {
namespace matsui1996 {

PaperSection comparison(const design::Settings& drive, const Found& found) {
  constexpr int kVoltage = int(design::Estimator::kVoltage),
                kCurrent = int(design::Estimator::kCurrent);
  constexpr int kLatency = 2 + SinusoidalLoop::kEarly, kSample = 2 + SinusoidalLoop::kClocks;
  const double mhz = drive.control.clock_hz / 1e6;
  const auto gamma = [](double slowest, double aim, double swing) {
    return fmt::format("{}by its mean, with 0.8 A of gamma current; the speed swings by {:.2g} % there, peak to peak. Without that "
                       "current, dead time at no load is the limit, below",
                       slowest > 0 && slowest <= aim ? "" : fmt::format("**missed** ({:g} r/min); ", aim), swing);
  };
  return {.title = "Table III: the two estimators",
          .text =
              "The paper's columns (their caption is exchanged with Table II's in print) and ours, "
              "from the figures below. "
              "What falls short of the aim is marked **missed**.",
          .claims = {
              {"voltage model: minimum speed", "r/min", 100, "", found.slowest[kVoltage],
               gamma(found.slowest[kVoltage], 50, found.swing_percent[kVoltage])},
              {"voltage model: accuracy", "%", 1, "", found.error_percent[kVoltage],
               "of the mean, from there to 1200 r/min, torque 0 to 100 %; a lock cannot drift"},
              {"current model: minimum speed", "r/min", 35, "", found.slowest[kCurrent],
               gamma(found.slowest[kCurrent], 10, found.swing_percent[kCurrent])},
              {"current model: accuracy", "%", 0.4, "", found.error_percent[kCurrent],
               "of the mean, from there to 1500 r/min, torque -100 to 100 %; a lock cannot drift"},
              {"salient rotor's initial position: worst error", "deg", {}, "close agreement",
               found.position_deg,
               fmt::format("{}from 64 places, below",
                           found.position_deg > 3 ? "**missed** (3 degrees); " : "")},
              {"loop rate of these runs", "kHz", 5, "", drive.control.pwm_hz / 1e3, "the paper's"},
              {"loop rate, fastest measured", "kHz", 5, "", found.loop_khz,
               fmt::format("{}below; at {:g} MHz a sample of {} clocks allows {:.1f} kHz",
                           found.loop_khz < 50 ? "**missed** (20 and 50 kHz); " : "", mhz, kSample,
                           1e3 * mhz / kSample)},
              {"sample to new on-times", "us", {}, "not printed", kLatency / mhz, "aim 10 us"}}};
}

}  // namespace matsui1996

PaperPage matsui1996_page(const design::Settings& drive, const design::Settings& salient,
                          const PaperOptions& options) {
  using namespace matsui1996;
  PaperPage page{
      .name = "matsui1996",
      .title = "Matsui 1996, side by side",
      .introduction = fmt::format("Printed by `steplock paper matsui1996` with engine `{}` for a "
                                  "point of each estimator, `fixed` for the others, and "
                                  "`float` where it says so; the test `pages_are_current_matsui1996` fails "
                                  "when this page is stale. Motor: "
                                  "[matsui1996.toml](../../drives/matsui1996.toml), which says how "
                                  "the paper's units are read. Sampled every 200 us with the "
                                  "paper's converters, and half a step of noise. Speeds and angles "
                                  "are the plant's. The paper's figures are traces; "
                                  "numbers are from its text.",
                                  name_of(options.engine))};
  Found found;
  const std::vector<std::function<PaperSection()>> figures = {
      [&] { return voltage_model(drive, options, found); },
      [&] { return current_model(drive, options, found); },
      [&] { return loop_rates(drive, options, found); },
      [&] { return wrong_parameters(drive, options); },
      [&] { return torque_on_and_off(drive, options); },
      [&] { return starts(drive, options); },
      [&] { return initial_position(salient, options, found); },
      [&] { return salient_running(salient, options); }};
  options.check_sections(2, static_cast<int>(figures.size()) + 1);  // the first one is of all the others
  int number = 1;
  for (const auto& figure : figures) {
    if (options.wants(++number)) page.sections.push_back(figure());
  }
  if (options.sections.empty()) page.sections.insert(page.sections.begin(), comparison(drive, found));
  return page;
}

}  // namespace steplock
