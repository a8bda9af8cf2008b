// The measured tables of docs/plant.md, printed by the plant itself.  The test fails if the page
// differs; with STEPLOCK_REPRINT=1 in the environment it rewrites the page's block instead.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/model/plant/six_step.hpp"

namespace steplock::plant {
namespace {

constexpr double kRated = 2 * std::numbers::pi * 50;  // 3000 rpm

template <typename... Args>
std::string row(const char* format, Args... args) {
  char line[256];
  std::snprintf(line, sizeof line, format, args...);
  return line;
}

Parameters servo(BackEmfShape::Kind kind) {
  Parameters p;
  p.motor.shape.kind = kind;
  p.load.inertia = 1;
  p.bus.resistance = 0;
  return p;
}

State after(const Parameters& p, double degrees, double amperes, const Gates& gates,
            double seconds) {
  Plant plant(p,
              {.angle = degrees * kDegree / 4, .speed = kRated, .current = {amperes, -amperes, 0}});
  plant.set_gates(gates);
  plant.advance_to(seconds);
  return plant.state();
}

std::string facts() {
  std::string out = "| fact (24 V, 3000 rpm) | circuit simulator | this plant |\n|---|---|---|\n";
  const auto kTrapezoidal = BackEmfShape::Kind::kTrapezoidal;
  const Gates on = {.uh = true, .vl = true}, off = {.vl = true};
  for (const auto kind : {kTrapezoidal, BackEmfShape::Kind::kSinusoidal}) {
    const State s = after(servo(kind), 45, 1, on, 5e-6);
    out += row("| on-time, %s: (v_float - V_bus/2) / e | %s | %.3f |\n",
               kind == kTrapezoidal ? "trapezoid" : "sine", kind == kTrapezoidal ? "1.0" : "1.5",
               (s.voltage[2] - 12) / s.emf[2]);
  }
  State s = after(servo(kTrapezoidal), 40, 3, off, 5e-6);
  out += row("| off-time with current: star point | near 0 | %.2f V |\n", s.neutral);
  s = after(servo(kTrapezoidal), 75, 5, off, 10e-6);
  out +=
      row("| the same past the crossing: floating terminal, its current | -0.55 V, flows | "
          "%.2f V, %.2f A |\n",
          s.voltage[2], s.current[2]);
  double low = 100, high = 0;
  for (double degrees = 31; degrees <= 86; degrees += 0.25) {
    Plant plant(servo(kTrapezoidal), {.angle = degrees * kDegree / 4, .speed = kRated});
    plant.set_gates(on);
    plant.advance_to(30e-6);
    plant.set_gates(off);
    plant.advance_to(50e-6);
    low = std::min(low, plant.state().neutral);
    high = std::max(high, plant.state().neutral);
  }
  out += row("| off-time without current: star point over the sector | 5.3 V | %.1f to %.1f V |\n",
             low, high);
  for (const auto& [amperes, said] :
       {std::pair{0.76, "10.7 us, 0.8 deg"}, {6.6, "89 us, 6.4 deg"}}) {
    Plant plant(servo(kTrapezoidal),
                {.angle = 90 * kDegree / 4, .speed = kRated, .current = {amperes, -amperes, 0}});
    plant.set_gates({.uh = true, .wl = true});
    while (!plant.state().floating[1]) plant.advance_to(plant.next_event());
    out += row("| demagnetisation at %.2f A | %s | %.1f us, %.2f deg |\n", amperes, said,
               plant.time() * 1e6, plant.state().electrical_angle / kDegree - 90);
  }
  return out;
}

// A start and a second of running under load, at falling tolerances.
std::string accuracy() {
  std::string out =
      "| tolerance | steps per simulated second | speed after 1 s, against 1e-11 | energy residual "
      "over energy supplied |\n|---|---|---|---|\n";
  const auto run = [](double tolerance) {
    Parameters p;
    p.load = {.inertia = 1e-5, .opposing_torque = 0.02};
    p.accuracy.tolerance = tolerance;
    Plant plant(p, {.angle = 0.2});
    SixStep drive(20e3, 0.6);
    drive.run(plant, 1.0);
    return plant;
  };
  const double exact = run(1e-11).state().speed;
  for (const double tolerance : {1e-6, 1e-7, 1e-8, 1e-9}) {
    const Plant plant = run(tolerance);
    const State s = plant.state();
    // One digit: the next would be rounding, and differ from machine to machine.
    out += row("| %.0e%s | %.0fk | %.0e | %.0e |\n", tolerance,
               tolerance == Accuracy{}.tolerance ? " (default)" : "",
               static_cast<double>(plant.steps()) / 1e3, std::abs(s.speed / exact - 1),
               std::abs(s.energy.residual() / s.energy.supplied));
  }
  return out;
}

TEST(Figures, ThePageShowsWhatThePlantMeasures) {
  const std::string path = STEPLOCK_ROOT "/docs/plant.md";
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  std::string page = text.str();
  const std::string begin = "<!-- printed by figures_test -->\n", end = "<!-- end -->";
  const auto from = page.find(begin), to = page.find(end, from);
  ASSERT_TRUE(from != std::string::npos && to != std::string::npos) << path;
  const std::string block = "\n" + facts() + "\n" + accuracy() + "\n";
  const auto start = from + begin.size();
  if (std::getenv("STEPLOCK_REPRINT")) {
    std::ofstream(path) << page.replace(start, to - start, block);
    return;
  }
  EXPECT_EQ(page.substr(start, to - start), block) << "STEPLOCK_REPRINT=1 figures_test mends it";
}

}  // namespace
}  // namespace steplock::plant
