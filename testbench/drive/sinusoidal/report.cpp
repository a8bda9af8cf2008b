// The files of a run: summary, samples, figures, page, wave.
#include "testbench/report/report.hpp"

#include <fmt/format.h>

#include <iterator>

#include "testbench/drive/sinusoidal/run.hpp"

namespace steplock::sinusoidal {

std::string samples_csv(const std::vector<Sample>& samples) {
  std::string text =
      "time_s,speed_rpm,drive_speed_rpm,reference_rpm,iu_a,iv_a,iw_a,i_gamma_a,i_delta_a,i_wanted_a,bus_v,"
      "torque_nm,load_nm,north_deg,delta_theta_deg,state,reason,id_a,iq_a\n";
  for (const Sample& s : samples) {
    const plant::State& p = s.plant;
    const RotorCurrent i = rotor_current(p);
    fmt::format_to(std::back_inserter(text),
                   "{:.9f},{:.6g},{:.6g},{:.6g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},"
                   "{:.3f},{:.4g},{},{},{:.5g},{:.5g}\n",
                   s.time, rpm(p.speed), s.drive.speed_rpm, s.drive.reference_rpm, p.current[0],
                   p.current[1], p.current[2], s.drive.i_gamma, s.drive.i_delta, s.drive.i_wanted,
                   p.bus_voltage, p.torque, s.load_nm, north_pole_deg(p), s.delta_theta_deg,
                   name_of(s.watch.state()), name_of(s.watch.reason()), i.d, i.q);
  }
  return text;
}

PageContent page_content(const design::Settings& s, const Result& r, const Record& record) {
  PageContent page{.drive = s.drive,
                   .what = fmt::format("Sensorless sinusoidal drive in co-simulation: engine {}, {} model, start by {}, "
                                       "rotor at {:g} electrical degrees, {:g} s at {:g} MHz.",
                                       r.engine, r.estimator, r.start_by, r.angle_deg, r.simulated_s,
                                       s.control.clock_hz / 1e6),
                   .failures = r.failures(),
                   .advice = r.advice,
                   .cards = {},
                   .changes = {},
                   .float_errors = r.float_errors,
                   .numbers = to_json(r)};
  page.cards = {{r.lock_time_s ? fmt::format("{:.3f} s", *r.lock_time_s) : "never", "first lock"},
                {fmt::format("{:.1f}°", r.backward_deg), "turned backward, electrical"},
                {fmt::format("{:.1f} rpm", r.mean_rpm), fmt::format("mean speed, set {:g}", r.set_speed_rpm)},
                {fmt::format("{:+.3f} %", r.speed_error_percent), "error of the mean speed"},
                {fmt::format("{:.1f} rpm", r.ripple.speed_rpm.rms), "speed ripple, rms"},
                {fmt::format("{:.3g} N m", r.ripple.torque_nm.rms), "torque ripple, rms"},
                {fmt::format("{:.2f}°", r.delta_theta_rms_deg), "error of the estimated angle, rms"},
                {fmt::format("{:.2f} A", r.peak_current_a), "peak phase current"},
                {r.load_dip_percent ? fmt::format("{:.1f} %", *r.load_dip_percent) : "-", "dip under the load step"},
                {r.loaded_power ? fmt::format("{:.1f} %", 100 * r.loaded_power->efficiency()) : "-", "efficiency under the load step"},
                {r.cpu_s > 0 ? fmt::format("{:.1f} M/s", static_cast<double>(r.clocks) / r.cpu_s / 1e6) : "-",
                 "clocks simulated"}};
  for (const StateChange& c : record.changes) {
    page.changes.push_back({c.time, name_of(c.state), c.reason == Reason::kNone ? "" : name_of(c.reason)});
  }
  return page;
}

ReportFiles write_report(const std::filesystem::path& directory, const design::Settings& s, const Result& result,
                         const Record& record, bool traced) {
  return steplock::write_report(directory, {.page = page_content(s, result, record),
                                            .samples = {{"run.csv", samples_csv(record.overview)},
                                                        {"lock.csv", samples_csv(record.lock)},
                                                        {"steady.csv", samples_csv(record.steady)}},
                                            .figures = figures(s, record),
                                            .wave = traced ? &Recording::wave() : nullptr});
}

}  // namespace steplock::sinusoidal
