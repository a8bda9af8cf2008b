#include "testbench/range/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "model/design/design.hpp"
#include "testbench/drive/six_step/run.hpp"
#include "testbench/drive_file/sheet_terms.hpp"
#include "testbench/run/units.hpp"

namespace steplock {
namespace {

// What of the run is shown: until the speed has stood for a while; of a start that failed, all of it.
double shown_s(const design::Settings& s, const Summary& sum) {
  return sum.start_time_s ? std::min(s.scenario.run_s + 1.3 * *sum.start_time_s, s.scenario.duration_s) : s.scenario.duration_s;
}

Figure start_figure(const std::string& stem, const design::Settings& s, const Summary& sum, const Record& record) {
  Figure f{.name = "gallery_" + stem, .title = s.drive.name, .axis = "time, s"};
  const double end = shown_s(s, sum);
  std::vector<Sample> samples;
  std::ranges::copy_if(record.overview, std::back_inserter(samples), [&](const Sample& x) { return x.time <= end; });
  if (samples.size() < 4) return f;
  Curve speed{"rotor", palette::kTrue}, set{"set", palette::kQuiet, {}, 1}, current{"phase, rms", palette::kU};
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const Sample &a = samples[k - 1], &b = samples[k];
    speed.points.push_back({b.time, rpm(b.plant.speed)});
    const double square = (b.totals.current_squared - a.totals.current_squared) / (b.time - a.time);
    current.points.push_back({b.time, std::sqrt(std::max(0.0, square))});
  }
  set.points = {{speed.points.front().x, sum.set_speed_rpm}, {speed.points.back().x, sum.set_speed_rpm}};
  constexpr std::size_t kPoints = 400;
  speed.points = outlined(speed.points, kPoints);
  current.points = outlined(current.points, kPoints);
  f.panels = {{.label = "speed, rpm", .curves = {set, speed}, .weight = 1.3}, {.label = "current, A", .curves = {current}}};
  if (sum.lock_time_s) f.marks.push_back({*sum.lock_time_s, "locked"});
  if (sum.start_time_s) f.marks.push_back({s.scenario.run_s + *sum.start_time_s, "at set speed"});
  return f;
}

std::string seconds(const std::optional<double>& t) { return t ? fmt::format("{:.3f}", *t) : "never"; }

std::string row_of_motor(const GalleryEntry& e) {
  const design::Settings& s = e.settings;
  const design::MotorConstants m = design::motor_constants(s);
  return fmt::format("| {} | {:g} | {:.3g} | {:.3g} | {} | {:.3g} | {:.3g} | {:.3g} |\n", s.drive.name, s.inverter.bus_v,
                     2 * s.motor.resistance_ohm, 2e3 * (s.motor.inductance_h - s.motor.mutual_h), s.motor.pole_pairs,
                     kv_of_k_e(k_e_per_flux(s.motor.shape, s.motor.pole_pairs) * s.motor.flux_vs), 1e7 * m.inertia,
                     s.motor.rated_current_a);
}

std::string row_of_run(const GalleryEntry& e) {
  const Summary& sum = e.summary;
  const std::string load = sum.loaded ? fmt::format("{:.1f}; {:+.2f}", sum.load_dip_percent.value_or(0), sum.loaded->error_percent) : "";
  const std::string reverse = sum.reversed ? fmt::format("{:+.2f}", sum.reversed->error_percent) : "";
  const std::vector<std::string> failures = sum.failures();
  return fmt::format("| {} | {:.0f} | {:.0f} | {} | {} | {:.3g} of {:.3g} | {:+.3f} | {} | {} | {} |\n", sum.drive, sum.set_speed_rpm,
                     sum.set_speed_rpm * e.settings.motor.pole_pairs / 60, seconds(sum.lock_time_s), seconds(sum.start_time_s),
                     sum.peak_current_a, sum.current_bound_a, sum.steady.error_percent, load, reverse,
                     failures.empty() ? "yes" : "no: " + failures.front());
}

}  // namespace

GalleryEntry gallery_entry(const DriveFile& file, const std::function<bool(double done)>& progress) {
  const design::Settings& s = file.settings;
  const RunOptions options{.engine = EngineKind::kFixed, .angle_deg = s.scenario.start_angle_deg, .progress = progress};
  const Record record = run_drive(s, options);
  const Summary summary = summarise(s, options, record);
  if (summary.interrupted) throw Stopped();
  return {file.path, s, summary, start_figure(std::filesystem::path(file.path).stem().string(), s, summary, record)};
}

std::string gallery_page(const std::vector<GalleryEntry>& all) {
  std::string t =
      "# Gallery\n\nPrinted by `tools/pages gallery`; the test `pages_are_current_gallery` fails when this page is stale.\n\n"
      "Motors that the drive was not made with. Each file has what the motor's source prints, in the source's own terms\n"
      "([keys](drive_file.md#motor-as-data-sheets-print-it)), the chopping, a scenario, and what had to be assumed. Gains, times, currents\n"
      "and words are worked out by the design library; none of them was tuned. Every file was run once, from standstill, by the engine\n"
      "`fixed`, which equals the RTL on every clock: start, load step, reversal, stop. `steplock gallery FILE...` prints such a page of\n"
      "your own motors; starts of many more, drawn at random, stand in [motors that no file knows](motor_starts.md).\n\n"
      "## The motors\n\n"
      "Resistance and inductance between two terminals, inertia of rotor and load.\n\n"
      "| motor | bus, V | R, Ω | L, mH | pole pairs | KV, r/min per V | inertia, g cm² | rated, A |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const GalleryEntry& e : all) t += row_of_motor(e);
  t += "\n## What they did\n\n"
       "Peak current of any phase beside its [bound](design.md#bounds-of-a-start); the load step is half the rated torque; *passed* means\n"
       "what [`steplock run`](report.md) judges.\n\n"
       "| motor | set speed, r/min | electrical, Hz | locked after, s | at set speed after, s | peak current, A | speed error, % | "
       "load step: dip, %; then error, % | reverse, error % | passed |\n"
       "|---|---:|---:|---:|---:|---:|---:|---:|---:|---|\n";
  for (const GalleryEntry& e : all) t += row_of_run(e);
  for (const GalleryEntry& e : all) {
    t += fmt::format("\n## {}\n\n[{}](../{}): {}.\n", e.settings.drive.name, e.file, e.file, e.settings.drive.source);
    if (!e.settings.drive.assumed.empty()) {
      t += "\nAssumed:\n\n";
      for (const std::string& a : e.settings.drive.assumed) t += "- " + a + "\n";
    }
    if (!e.start.panels.empty()) t += fmt::format("\n![{}: start](figures/{}.svg)\n", e.settings.drive.name, e.start.name);
  }
  return t;
}

}  // namespace steplock
