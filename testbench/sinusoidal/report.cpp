// The files of a run: summary, samples, figures.
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "testbench/sinusoidal/run.hpp"

namespace steplock::sinusoidal {
namespace {

template <class F>
std::vector<Point> points(const std::vector<Sample>& samples, F&& y, double from = 0, double to = 1e9) {
  std::vector<Point> all;
  for (const Sample& s : samples) {
    if (s.time >= from && s.time <= to) all.push_back({s.time, y(s)});
  }
  return outlined(all);
}

}  // namespace

std::string samples_csv(const std::vector<Sample>& samples) {
  std::string text =
      "time_s,speed_rpm,drive_speed_rpm,reference_rpm,iu_a,iv_a,iw_a,i_gamma_a,i_delta_a,i_wanted_a,bus_v,"
      "torque_nm,load_nm,north_deg,delta_theta_deg,state,reason\n";
  for (const Sample& s : samples) {
    const plant::State& p = s.plant;
    fmt::format_to(std::back_inserter(text),
                   "{:.9f},{:.6g},{:.6g},{:.6g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},{:.5g},"
                   "{:.3f},{:.4g},{},{}\n",
                   s.time, rpm(p.speed), s.drive.speed_rpm, s.drive.reference_rpm, p.current[0],
                   p.current[1], p.current[2], s.drive.i_gamma, s.drive.i_delta, s.drive.i_wanted,
                   p.bus_voltage, p.torque, s.load_nm, north_pole_deg(p), s.delta_theta_deg,
                   name_of(s.watch.state()), name_of(s.watch.reason()));
  }
  return text;
}

std::vector<Figure> figures(const design::Settings& s, const Record& record) {
  const auto& samples = record.overview;
  Figure run{.name = "run", .title = s.drive.name, .axis = "time, s",
             .caption = "The whole scenario: speed, torque-making current, load, and the estimate's error."};
  run.panels = {
      {.label = "speed, rpm",
       .curves = {{"drive's own", palette::kDrive, points(samples, [](const Sample& x) { return x.drive.speed_rpm; })},
                  {"rotor", palette::kTrue, points(samples, [](const Sample& x) { return rpm(x.plant.speed); })}},
       .weight = 1.3},
      {.label = "current, A",
       .curves = {{"i_delta", palette::kW, points(samples, [](const Sample& x) { return x.drive.i_delta; })},
                  {"i_gamma", palette::kU, points(samples, [](const Sample& x) { return x.drive.i_gamma; })}}},
      {.label = "torque, N m",
       .curves = {{"motor", palette::kV, points(samples, [](const Sample& x) { return x.plant.torque; })},
                  {"load", palette::kQuiet, points(samples, [](const Sample& x) { return x.load_nm; })}}},
      {.label = "delta theta, deg",
       .curves = {{"", palette::kTrue, points(samples, [](const Sample& x) { return x.delta_theta_deg; })}}}};
  for (const Event& e : timeline(s).events) {
    if (e.what != "gates off") run.marks.push_back({static_cast<double>(e.clock) / s.control.clock_hz, e.what});
  }
  Figure start{.name = "start", .title = s.drive.name + ": start", .axis = "time, s",
               .caption = "From standstill to lock: phase currents, speed and angles."};
  double end = 0.3 * s.scenario.duration_s;
  for (const StateChange& c : record.changes) {
    start.marks.push_back({c.time, name_of(c.state)});
    if (c.state == State::kRun) {
      end = c.time * 1.2;
      break;
    }
  }
  const auto early = [&](auto&& y) { return points(samples, y, 0, end); };
  start.panels = {
      {.label = "phase current, A",
       .curves = {{"u", palette::kU, early([](const Sample& x) { return x.plant.current[0]; })},
                  {"v", palette::kV, early([](const Sample& x) { return x.plant.current[1]; })},
                  {"w", palette::kW, early([](const Sample& x) { return x.plant.current[2]; })}}},
      {.label = "speed, rpm",
       .curves = {{"drive's own", palette::kDrive, early([](const Sample& x) { return x.drive.speed_rpm; })},
                  {"rotor", palette::kTrue, early([](const Sample& x) { return rpm(x.plant.speed); })}}},
      {.label = "N pole, deg",
       .curves = {{"rotor", palette::kTrue, early([](const Sample& x) { return north_pole_deg(x.plant); })}}}};
  return {run, start};
}

ReportFiles write_report(const std::filesystem::path& directory, const design::Settings& s,
                         const Result& result, const Record& record) {
  std::filesystem::create_directories(directory);
  ReportFiles files;
  const auto add = [&](const char* name, const std::string& text) {
    write_file(directory / name, text);
    files.paths.push_back(directory / name);
  };
  add("summary.json", to_json(result).dump(2) + "\n");
  add("run.csv", samples_csv(record.overview));
  for (const Figure& figure : figures(s, record)) {
    if (!draw(figure, directory)) {
      files.warnings.push_back("gnuplot does not run, so there are no figures; install gnuplot-nox");
      break;
    }
    files.paths.push_back(directory / (figure.name + ".svg"));
  }
  return files;
}

}  // namespace steplock::sinusoidal
