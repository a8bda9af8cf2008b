// Fig. 7 of Matsui 1996: starts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "testbench/paper/matsui1996.hpp"

namespace steplock::matsui1996 {
namespace {

using design::StartBy;
using sinusoidal::Result;

Figure start_figure(std::string name, std::string title, const Start& s) {
  Curve speed{"rotor", palette::kTrue, {}}, drive{"drive's own", palette::kDrive, {}};
  Curve delta{"delta theta", palette::kU, {}};
  for (const auto& x : s.record.overview) {
    speed.points.push_back({x.time, rpm(x.plant.speed)});
    drive.points.push_back({x.time, x.drive.speed_rpm});
    if (x.drive.estimating) delta.points.push_back({x.time, x.delta_theta_deg});
  }
  for (Curve* c : {&speed, &drive, &delta}) c->points = outlined(c->points, 800);
  return {
      .name = std::move(name),
      .title = std::move(title),
      .axis = "time, s",
      .caption = "Arbitrary start, engine fixed: the loop is closed on the assumed angle at once.",
      .panels = {{.label = "speed, r/min", .curves = {drive, speed}},
                 {.label = "delta theta, deg", .curves = {delta}}}};
}

Claim started(const std::string& name, const std::string& shown, const Start& s) {
  const Result& r = s.result;
  return {name + ": backward, electrical",
          "deg",
          {},
          shown,
          r.backward_deg,
          r.lock_time_s ? fmt::format("locked after {:.2f} s, {} tries failed", *r.lock_time_s,
                                      r.reasons.size())
                        : "**missed**: no lock"};
}

// From 64 places: how many lock, and the farthest backward turn.
Claim from_all_round(const design::Settings& drive, StartBy by, const std::string& name,
                     double seconds, const PaperOptions& options) {
  constexpr int kPlaces = 64;
  int first = 0, later = 0;
  double backward = 0;
  for (int n = 0; n < kPlaces; ++n) {
    if (options.progress && !options.progress("starts, " + name, double(n) / kPlaces))
      throw Stopped();
    const Start s = start_from(drive, EngineKind::kFloat, by, n * 360.0 / kPlaces, seconds);
    if (!s.result.locked) continue;
    ++(s.result.reasons.empty() ? first : later);
    backward = std::max(backward, s.result.backward_deg);
  }
  const int lost = kPlaces - first - later;
  return {fmt::format("{} from {} places: not at set speed after {:g} s", name, kPlaces, seconds),
          "",
          {},
          "",
          double(lost),
          fmt::format("{}{} at the first try, {} after failed ones; backward by at most {:.0f} "
                      "electrical degrees{}; float",
                      lost > 0 ? "**missed**: " : "", first, later, backward,
                      by == StartBy::kPattern
                          ? ", by the pattern itself, which turns the rotor to its place"
                          : "")};
}

}  // namespace

Start start_from(design::Settings s, EngineKind engine, StartBy by, double angle_deg,
                 double seconds) {
  s = steady(s, s.sinusoidal.estimator, s.scenario.speed_rpm, s.sinusoidal.i_gamma_a);
  s.sinusoidal_start.by = by;
  s.scenario.duration_s = seconds;
  const RunOptions options{.engine = engine, .angle_deg = angle_deg};
  Start all{{}, sinusoidal::run(s, options)};
  all.result = sinusoidal::summarise(s, options, all.record);
  return all;
}

PaperSection starts(const design::Settings& drive, const PaperOptions& options) {
  if (options.progress && !options.progress("Fig. 7", 0)) throw Stopped();
  // The assumed axis stands at winding u; theta_e = 180 has the N pole there.
  const Start right = start_from(drive, EngineKind::kFixed, StartBy::kArbitrary, 180, 1.2);
  const Start opposite = start_from(drive, EngineKind::kFixed, StartBy::kArbitrary, 0, 1.6);
  PaperSection s{.title = "Fig. 7: starts from an initial error of 0 and 180 degrees",
                 .text =
                     "Current model, no load, to 1200 r/min. The rotor that stands opposite turns "
                     "backward first, as in the paper.",
                 .claims = {started("from 0 degrees", "smooth", right),
                            started("from 180 degrees", "backward first", opposite),
                            from_all_round(drive, StartBy::kPattern, "pattern", 1.2, options),
                            from_all_round(drive, StartBy::kArbitrary, "arbitrary", 2, options)},
                 .figures = {start_figure("fig7a", "Fig. 7(a): start from 0 degrees", right),
                             start_figure("fig7b", "Fig. 7(b): start from 180 degrees", opposite)}};
  if (!right.result.locked) s.failures.push_back("the start from 0 degrees");
  if (!opposite.result.locked) s.failures.push_back("the start from 180 degrees");
  return s;
}

}  // namespace steplock::matsui1996
