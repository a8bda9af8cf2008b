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
               gamma(found.slowest[kVoltage], 50, found.swing_percent[kVoltage]),
               found.slowest[kVoltage] > 0 && found.slowest[kVoltage] <= 100 ? Verdict::kReached : Verdict::kByNumbers},
              {"voltage model: accuracy", "%", 1, "", found.error_percent[kVoltage],
               "of the mean, from there to 1200 r/min, torque 0 to 100 %; a lock cannot drift",
               found.error_percent[kVoltage] <= 1 ? Verdict::kReached : Verdict::kByNumbers},
              {"current model: minimum speed", "r/min", 35, "", found.slowest[kCurrent],
               gamma(found.slowest[kCurrent], 10, found.swing_percent[kCurrent]),
               found.slowest[kCurrent] > 0 && found.slowest[kCurrent] <= 35 ? Verdict::kReached : Verdict::kByNumbers},
              {"current model: accuracy", "%", 0.4, "", found.error_percent[kCurrent],
               "of the mean, from there to 1500 r/min, torque -100 to 100 %; a lock cannot drift",
               found.error_percent[kCurrent] <= 0.4 ? Verdict::kReached : Verdict::kByNumbers},
              {"salient rotor's initial position: worst error", "deg", {}, "close agreement",
               found.position_deg,
               fmt::format("{}from 64 places, below",
                           found.position_deg > 3 ? "**missed** (3 degrees); " : "")},
              {"loop rate of these runs", "kHz", 5, "", drive.control.pwm_hz / 1e3, "the paper's", Verdict::kInput},
              {"loop rate, fastest measured", "kHz", 5, "", found.loop_khz,
               fmt::format("{}below; at {:g} MHz a sample of {} clocks allows {:.1f} kHz",
                           found.loop_khz < 50 ? "**missed** (20 and 50 kHz); " : "", mhz, kSample,
                           1e3 * mhz / kSample),
               found.loop_khz >= 5 ? Verdict::kReached : Verdict::kByNumbers},
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
                                  "paper's ADCs, and half a step of noise. Speeds and angles "
                                  "are the plant's. The paper's figures are traces; "
                                  "numbers are from its text.",
                                  name_of(options.engine)),
      .departures = {
          {"frame of the current model", "(14) steps the current in the turning frame", "steps it in the stationary one, and turns the difference once"},
          {"Eqs. (19), (20)", "without the sign of the speed; a factor T too many", "with the sign; without the factor"},
          {"voltage drop of the switches", "not compensated", "the diode's drop is taken with the dead time"},
          {"low speed", "gamma current held at zero", "0.8 A where it is said, which the paper did not try"},
          {"salient motor", "2.2 kW; its constants are not printed",
           "another one of 2.2 kW, whose constants are: [ipm_2k2.toml](../../drives/ipm_2k2.toml)"}}};
  Found found;
  const std::vector<std::function<PaperSection()>> figures = {
      [&] { return voltage_model(drive, options, found); },
      [&] { return current_model(drive, options, found); },
      [&] { return causes_of_the_swing(drive, options); },
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
