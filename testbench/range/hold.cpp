#include "testbench/range/hold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/design/bounds.hpp"
#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "testbench/drive/six_step/recorder.hpp"
#include "testbench/drive_file/csv_cells.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/run/cosimulation.hpp"
#include "testbench/run/drive_loop.hpp"
#include "testbench/run/units.hpp"
#include "testbench/sweep_page/share.hpp"

namespace steplock {
namespace {

constexpr double kKept = 1, kKeptTurns = 60, kKeptMost = 20;  // s, electrical, s
constexpr double kLook = 2e-3;                                // s: less than any retry takes
constexpr std::size_t kFirst = 10;                            // rows that a test repeats

double frequency(const design::Settings& s) { return s.scenario.speed_rpm * s.motor.pole_pairs / 60; }
double kept_s(const design::Settings& s) { return std::min(std::max(kKept, kKeptTurns / frequency(s)), kKeptMost); }

double quantile(std::vector<double> x, double q) {
  if (x.empty()) return 0;
  std::ranges::sort(x);
  return x[std::min(x.size() - 1, static_cast<std::size_t>(q * static_cast<double>(x.size())))];
}

std::string row_of(const HeldMotor& m) {
  const design::Settings& s = m.settings;
  return fmt::format("| {} | {:.3g} | {:.3g} | {:.3g} | {:.3g} | {} | {} |\n", m.name, s.inverter.bus_v, s.motor.rated_current_a,
                     60 * frequency(s), 1e7 * design::motor_constants(s).inertia,
                     m.hold.lock_s ? fmt::format("{:.4f}", *m.hold.lock_s) : "never", m.hold.held ? "yes" : "no");
}

constexpr const char* kHead =
    "| motor | bus, V | rated, A | electrical r/min | inertia, g cm² | locked after, s | held |\n|---|---:|---:|---:|---:|---:|---|\n";

}  // namespace

Hold start_and_hold(const design::Settings& s) {
  const double clock_hz = s.control.clock_hz;
  FixedEngine engine(hls_config(design::quantise(design::design_drive(s).parameters, clock_hz).config), clock_hz);
  const auto clock = [&](double t) { return static_cast<std::uint64_t>(t * clock_hz); };
  const double kept = kept_s(s), run_s = s.scenario.run_s, end = run_s + 2 * design::start_bounds(s).lock_s + kept;
  Timeline events;
  events.events = {{0, {}, 0, "off"}, {clock(run_s), {.run = true}, 0, "run"}};
  events.clocks = clock(end);
  events.steady_end_s = end;
  plant::Plant plant(plant_parameters(s), initial_state(s, s.scenario.start_angle_deg));
  RecorderSettings settings = recorder_settings(s, events);
  settings.duration_s = end;
  Recorder recorder(settings);
  Cosimulation simulation(engine, plant, events, recorder, clock_hz);

  Hold h;
  bool locked = false;
  std::uint64_t slips = 0;
  while (simulation.clock() < events.clocks && !h.held) {
    simulation.run_until(std::min(events.clocks, simulation.clock() + clock(kLook)));
    const double now = static_cast<double>(simulation.clock()) / clock_hz;
    const Watch watch = engine.watch();
    if (watch.reason() != Reason::kNone) h.reason = name_of(watch.reason());
    if (watch.locked() && !locked) {
      h.lock_s = now - run_s;
      slips = recorder.step_outs();
    }
    h.lost_locks += locked && !watch.locked();
    locked = watch.locked();
    h.held = locked && recorder.step_outs() == slips && now - run_s >= *h.lock_s + kept;
    if (watch.state() == State::kFault) break;
  }
  h.rpm = rpm(plant.state().speed);
  return h;
}

std::string to_line(const Hold& h) {
  return fmt::format("{},{},{},{},{}", int(h.held), h.lock_s ? fmt::format("{}", *h.lock_s) : "", h.lost_locks, h.rpm, h.reason);
}

Hold hold_of(const std::string& line) {
  const auto cells = csv_cells(line);
  const auto text = [&](std::size_t k) { return std::string(cells.at(k)); };
  Hold h{.held = text(0) == "1", .lock_s = {}, .lost_locks = std::stoi(text(2)), .rpm = std::stod(text(3)), .reason = text(4)};
  if (!text(1).empty()) h.lock_s = std::stod(text(1));
  return h;
}

std::string decades_page(const std::vector<HeldMotor>& all, const std::string& printed_by, std::uint64_t seed) {
  std::vector<double> locks;
  std::vector<const HeldMotor*> failed, again;
  for (const HeldMotor& m : all) {
    if (m.hold.held) locks.push_back(*m.hold.lock_s);
    if (!m.hold.held) failed.push_back(&m);
    if (m.hold.held && (m.hold.lost_locks > 0 || !m.hold.reason.empty())) again.push_back(&m);
  }
  const double n = static_cast<double>(all.size());
  std::string t = fmt::format(
      "# Motors of any size\n\nPrinted by `{}`; the test `the_page_of_decades_is_current` repeats its first motors and fails when they\n"
      "are not the page's.\n\n"
      "`steplock motors --decades --count {} --seed {}` writes the motors: 2 to 800 V, 0.1 to 1,000 A, 100 to 1,000,000 electrical r/min and\n"
      "0.1 g cm² to 10 kg m², each drawn by ratio, and what nobody could build left out ([how](../testbench/drive_file/decades_motor.hpp)). A file\n"
      "has the motor, bus, limit, comparators, chopping and set speed; all else are defaults. The seed follows from the digest of\n"
      "[starts](starts.md).\n\n"
      "Each is started once from rest, from a drawn angle, by the engine `fixed`. *Held* is a lock without a step slipped for {:g} s and {:g}\n"
      "electrical turns of the set speed, {:g} s at most, while the drive accelerates. It has twice the time that [a lock may\n"
      "take](design.md#bounds-of-a-start).\n\n"
      "| motors | held | at least | of them after a failed attempt | locked after, s: median | 99 % | longest |\n"
      "|---:|---:|---:|---:|---:|---:|---:|\n"
      "| {} | {:.2f} % | {:.2f} % | {} | {:.3g} | {:.3g} | {:.3g} |\n\n"
      "*At least* is an exact binomial bound with 95 % confidence.\n\n",
      printed_by, all.size(), seed, kKept, kKeptTurns, kKeptMost, all.size(), 100 * double(locks.size()) / n,
      100 * share_at_least(locks.size(), all.size()), again.size(), quantile(locks, 0.5), quantile(locks, 0.99), quantile(locks, 1));
  t += "| electrical r/min at set speed | motors | held | locked after, s: median | longest |\n|---|---:|---:|---:|---:|\n";
  for (double from = 100; from < 1e6; from *= 10) {
    std::size_t motors = 0;
    std::vector<double> here;
    for (const HeldMotor& m : all) {
      const double e = 60 * frequency(m.settings);
      if (e < from || e >= 10 * from) continue;
      ++motors;
      if (m.hold.held) here.push_back(*m.hold.lock_s);
    }
    t += fmt::format("| {:g} to {:g} | {} | {} | {:.3g} | {:.3g} |\n", from, 10 * from, motors, here.size(), quantile(here, 0.5),
                     quantile(here, 1));
  }
  if (!failed.empty()) t += "\n## Not held\n\n" + std::string(kHead);
  for (const HeldMotor* m : failed) t += row_of(*m);
  for (const HeldMotor* m : failed) {
    t += fmt::format("\n{}: {:.4g} of {:.4g} r/min at the end, {} locks lost{}.\n", m->name, m->hold.rpm, m->settings.scenario.speed_rpm,
                     m->hold.lost_locks, m->hold.reason.empty() ? "" : ", " + m->hold.reason);
  }
  t += "\n## The first ones\n\n" + std::string(kHead);
  for (std::size_t k = 0; k < std::min(kFirst, all.size()); ++k) t += row_of(all[k]);
  return t;
}

}  // namespace steplock
