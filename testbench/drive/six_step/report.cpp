#include "testbench/drive/six_step/report.hpp"

#include <fmt/format.h>

#include "testbench/drive/six_step/csv.hpp"
#include "testbench/drive/six_step/figures.hpp"
#include "testbench/drive/six_step/recorder.hpp"

namespace steplock {

PageContent page_content(const design::Settings& s, const Summary& sum, const Record& record) {
  PageContent page{.drive = s.drive,
                   .what = fmt::format("Sensorless six-step drive in co-simulation: engine {}, rotor at {:g} "
                                       "electrical degrees, {:g} s at {:g} MHz.",
                                       sum.engine, sum.angle_deg, sum.simulated_s, s.control.clock_hz / 1e6),
                   .failures = sum.failures(),
                   .advice = sum.advice,
                   .cards = {},
                   .changes = {},
                   .float_errors = sum.float_errors,
                   .numbers = to_json(sum)};
  page.cards = {
      {sum.lock_time_s ? fmt::format("{:.3f} s", *sum.lock_time_s) : "never", "first lock"},
      {sum.start_time_s ? fmt::format("{:.3f} s", *sum.start_time_s) : "never", "from run to set speed"},
      {fmt::format("{:.1f} rpm", sum.steady.mean_rpm), fmt::format("mean speed, set {:g}", sum.set_speed_rpm)},
      {fmt::format("{:+.3f} %", sum.steady.error_percent), "error of the mean speed"},
      {fmt::format("{:.1f} rpm", sum.ripple.speed_rpm.rms), "speed ripple, rms"},
      {fmt::format("{:.3g} N m", sum.ripple.torque_nm.rms), "torque ripple, rms"},
      {fmt::format("{:.2f}°", sum.commutation_error_rms_deg), "commutation error, rms"},
      {fmt::format("{:.2f} A", sum.peak_current_a), "peak phase current"},
      {sum.loaded_power ? fmt::format("{:.1f} %", 100 * sum.loaded_power->efficiency()) : "-", "efficiency under the load step"},
      {fmt::format("{}", sum.step_outs), "steps slipped"},
      {fmt::format("{:.1f} M/s", sum.clocks_per_cpu_second / 1e6), "clocks simulated"}};
  for (const StateChange& c : record.changes) {
    page.changes.push_back({c.time, name_of(c.state), c.reason == Reason::kNone ? "" : name_of(c.reason)});
  }
  return page;
}

ReportFiles write_report(const std::filesystem::path& directory, const design::Settings& s, const Summary& summary,
                         const Record& record, bool traced) {
  const int pole_pairs = s.motor.pole_pairs;
  return write_report(directory, {.page = page_content(s, summary, record),
                                  .samples = {{"run.csv", samples_csv(record.overview, pole_pairs)},
                                              {"lock.csv", samples_csv(record.lock, pole_pairs)},
                                              {"steady.csv", samples_csv(record.steady, pole_pairs)}},
                                  .figures = run_figures(s, summary, record),
                                  .wave = traced ? &SixStepRecording::wave() : nullptr});
}

}  // namespace steplock
