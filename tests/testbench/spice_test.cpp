// The plant against ngspice: short gate patterns of each drive's own motor and bridge, from its file.
//
// The bound of a current is the sum of what the two models do not share (the diodes' corner, the edges of the gates, leakage)
// and of what ngspice itself changes when its step is halved. A value that is wrong by 1 % is beyond it.
#include "tests/testbench/spice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

#include "testbench/run/check.hpp"
#include "tests/testbench/own_folder.hpp"

namespace steplock {
namespace {

using plant::GateEvent, plant::Gates, plant::Sample;

constexpr double kStep = 2e-7;  // s, of ngspice and of the samples
constexpr const char* kDrives[] = {"amano2003", "m2310p_servo", "hoverboard_hub"};

struct Pattern {
  std::string name;
  double speed = 0;      // of the no-load speed
  double angle_deg = 0;  // electrical
  std::vector<GateEvent> events = {};
  double duration = 0;
  bool frictionless = false;  // ngspice's friction knows no standstill
};

constexpr Gates kOff = {}, kUV = {.uh = true, .vl = true}, kUW = {.uh = true, .wl = true}, kV = {.vl = true}, kW = {.wl = true},
                kUlV = {.ul = true, .vl = true}, kShort = {.ul = true, .vl = true, .wl = true},
                kAlign = {.uh = true, .vh = true, .wl = true};

// `on` for `high`, `off` for the rest of each of so many periods; `dead` between two.
void chop(Pattern& p, Gates on, Gates off, double high, double period, int times, double dead = 0, Gates between = {}) {
  for (int n = 0; n < times; ++n) {
    p.events.push_back({p.duration, on});
    if (dead > 0) p.events.push_back({p.duration + high, between});
    p.events.push_back({p.duration + high + dead, off});
    if (dead > 0) p.events.push_back({p.duration + period - dead, between});
    p.duration += period;
  }
}
void then(Pattern& p, Gates gates, double time) {
  p.events.push_back({p.duration, gates});
  p.duration += time;
}

std::vector<Pattern> patterns() {
  std::vector<Pattern> all;
  const auto add = [&all](std::string name, double speed, double angle, const std::function<void(Pattern&)>& fill) {
    all.push_back({.name = std::move(name), .speed = speed, .angle_deg = angle});
    fill(all.back());
  };
  add("commutation", 0.3, 60, [](Pattern& p) { then(p, kUV, 150e-6), then(p, kUW, 150e-6), then(p, kOff, 100e-6); });
  add("high-side chopping", 0.3, 60, [](Pattern& p) { chop(p, kUV, kV, 20e-6, 33e-6, 6), chop(p, kUW, kW, 20e-6, 33e-6, 6); });
  add("complementary chopping with dead time", 0.3, 60, [](Pattern& p) { chop(p, kUV, kUlV, 18e-6, 33e-6, 8, 1e-6, kV); });
  add("regeneration", 0.7, 60, [](Pattern& p) { chop(p, kUV, kUlV, 8e-6, 33e-6, 8, 1e-6, kV); });
  add("a chopped brake, backwards", -0.5, 20, [](Pattern& p) { chop(p, kShort, kOff, 20e-6, 33e-6, 8); });
  add("rectifying above the bus", 1.3, 10, [](Pattern& p) { then(p, kOff, 250e-6); });
  add("reset from rest", 0, 80, [](Pattern& p) { chop(p, kAlign, kW, 15e-6, 33e-6, 10), p.frictionless = true; });
  return all;
}

struct Case {
  plant::Parameters parameters;
  plant::InitialState start;
  std::vector<Sample> ours;
};

Case ours(const std::string& drive, const Pattern& p) {
  const design::Settings s = open_drive_file(STEPLOCK_DRIVES "/" + drive + ".toml").settings;
  Case c{.parameters = plant_parameters(s), .start = initial_state(s, p.angle_deg), .ours = {}};
  c.start.speed = p.speed * s.inverter.bus_v / (std::sqrt(3) * c.parameters.motor.flux * c.parameters.motor.pole_pairs);
  if (p.frictionless) c.parameters.motor.coulomb_friction = c.parameters.motor.static_friction = 0;
  plant::replay(c.parameters, c.start, p.events, kStep, p.duration, [&c](const Sample& x) { c.ours.push_back(x); });
  return c;
}

struct Difference {
  double current = 0, speed = 0, peak = 0;
};

Difference difference(const std::vector<Sample>& a, const std::vector<Sample>& b) {
  Difference d;
  for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n) {
    for (const auto i : {&Sample::iu, &Sample::iv, &Sample::iw}) {
      d.current = std::max(d.current, std::abs(a[n].*i - b[n].*i));
      d.peak = std::max(d.peak, std::abs(a[n].*i));
    }
    d.speed = std::max(d.speed, std::abs(a[n].speed_rad_s - b[n].speed_rad_s));
  }
  return d;
}

std::vector<Sample> every(std::size_t nth, const std::vector<Sample>& samples) {
  std::vector<Sample> some;
  for (std::size_t n = 0; n < samples.size(); n += nth) some.push_back(samples[n]);
  return some;
}

// A, from what the models do not share.
double unshared(const Case& c, const Pattern& p) {
  const auto& m = c.parameters.motor;
  const double l = m.inductance - m.mutual, bus = std::max(c.parameters.bus.voltage, std::abs(c.ours.back().bus_v));
  const double diodes = spice::kDiodeDoubt / l * std::min(p.duration, l / m.resistance);
  return diodes + 2 * spice::kEdge * bus / l + 4 * bus / spice::kLeak;
}

class Spice : public testing::TestWithParam<const char*> {};

TEST_P(Spice, AgreesWithThePlantInCurrentsAndSpeed) {
  for (const Pattern& p : patterns()) {
    const Case c = ours(GetParam(), p);
    const auto run = [&](double step) { return spice::run(c.parameters, c.start, p.events, step, p.duration, own_folder()); };
    const std::vector<Sample> theirs = run(kStep), finer = run(kStep / 2);
    ASSERT_GT(theirs.size(), c.ours.size() - 3) << p.name;
    const std::vector<Sample> halved = every(2, finer);
    const Difference d = difference(c.ours, halved), own = difference(theirs, halved);
    const double bound = unshared(c, p) + own.current;
    EXPECT_LE(d.current, bound) << p.name;
    const double torque = 2 * c.parameters.motor.flux * c.parameters.motor.pole_pairs * bound;
    EXPECT_LE(d.speed, own.speed + torque * p.duration / (c.parameters.motor.inertia + c.parameters.load.inertia)) << p.name;
  }
}

// Which windings carry current: more than leaks through the terminals.
int conducting(const Sample& s) {
  const double least = 4 * s.bus_v / spice::kLeak;
  return (std::abs(s.iu) > least ? 1 : 0) | (std::abs(s.iv) > least ? 2 : 0) | (std::abs(s.iw) > least ? 4 : 0);
}

struct Voltages {
  double apart = 0;
  int compared = 0;
};

// Driven, freewheeling, floating and clamped terminals, and the star point; a microsecond away from what changes them.
Voltages voltages(const Case& c, const Pattern& p, const std::vector<Sample>& theirs) {
  constexpr std::size_t kAround = 5;  // samples
  Voltages all;
  for (std::size_t n = kAround; n + kAround < std::min(c.ours.size(), theirs.size()); ++n) {
    const Sample &a = c.ours[n], &b = theirs[n];
    bool still = true;
    for (std::size_t k = n - kAround; k <= n + kAround; ++k) {
      still = still && conducting(c.ours[k]) == conducting(a) && conducting(theirs[k]) == conducting(a);
    }
    for (const GateEvent& e : p.events) still = still && std::abs(e.time - a.time) > kAround * kStep;
    if (!still) continue;
    ++all.compared;
    for (const auto v : {&Sample::vu, &Sample::vv, &Sample::vw, &Sample::neutral_v}) {
      all.apart = std::max(all.apart, std::abs(a.*v - b.*v));
    }
  }
  return all;
}

TEST_P(Spice, AgreesWithThePlantInVoltages) {
  for (const Pattern& p : patterns()) {
    const Case c = ours(GetParam(), p);
    const auto run = [&](const spice::Flaws& flaws) {
      return voltages(c, p, spice::run(c.parameters, c.start, p.events, kStep, p.duration, own_folder(), flaws));
    };
    // A diode's corner at either end, and the winding's R with the currents' doubt.
    const double bound = 2 * spice::kDiodeDoubt + 2 * c.parameters.motor.resistance * unshared(c, p);
    const Voltages v = run({});
    EXPECT_GT(v.compared, static_cast<int>(c.ours.size() / 5)) << p.name;
    EXPECT_LE(v.apart, bound) << p.name;
    if (p.speed != 0) {
      EXPECT_GT(run({.flux = 1.01}).apart, bound) << p.name << ": a percent of flux is noticed";
    }
  }
}

// When the current of the winding that was left ends: what a back-EMF comparator waits for.
double end_of(const std::vector<Sample>& samples, double Sample::*current, double from) {
  double end = from;
  for (const Sample& s : samples) {
    if (s.time > from && std::abs(s.*current) > 0.01) end = s.time;
  }
  return end;
}

TEST_P(Spice, DemagnetisationEndsAtTheSameTime) {
  const Pattern p = patterns().front();
  const Case c = ours(GetParam(), p);
  const std::vector<Sample> theirs = spice::run(c.parameters, c.start, p.events, kStep, p.duration, own_folder());
  const double from = p.events[1].time, before_off = p.events[2].time;
  const auto until = [&](std::vector<Sample> samples) {
    std::erase_if(samples, [&](const Sample& s) { return s.time >= before_off; });
    return end_of(samples, &Sample::iv, from) - from;
  };
  EXPECT_GT(until(c.ours), 20 * kStep);
  EXPECT_LT(until(c.ours), before_off - from);
  EXPECT_NEAR(until(c.ours), until(theirs), 1.01 * kStep);  // a sample
}

// Negative controls: a percent in the netlist, 50 mV of a diode or 100 ns of a gate are beyond the bound; nothing of it is within.
TEST_P(Spice, NoticesAPercent) {
  const Pattern p = patterns().front();
  const Case c = ours(GetParam(), p);
  const auto apart = [&](const spice::Flaws& flaws) {
    return difference(c.ours, spice::run(c.parameters, c.start, p.events, kStep, p.duration, own_folder(), flaws)).current;
  };
  const double bound = unshared(c, p);
  EXPECT_LT(apart({}), bound);
  EXPECT_GT(apart({.inductance = 1.01}), bound);
  EXPECT_GT(apart({.resistance = 1.01}), bound);
  EXPECT_GT(apart({.flux = 1.01}), bound);
  EXPECT_GT(apart({.drop_v = 0.05}), bound);
  EXPECT_GT(apart({.edge_s = 100e-9}), bound);
}

// Rounded up to 1, 2 or 5: the next digit is ngspice's own.
std::string up(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1., 2., 5.}) {
    if (value <= step * decade) return fmt::format("{:.0e}", step * decade);
  }
  return fmt::format("{:.0e}", 10 * decade);
}

// The table of docs/plant.md; with STEPLOCK_REPRINT=1 in the environment it is written anew.
TEST(SpicePage, ShowsHowFarApartTheTwoAre) {
  std::string block = "\n| gates | greatest current, A | apart, of that | allowed |\n|---|---:|---:|---:|\n";
  for (const Pattern& p : patterns()) {
    double peak = 0, apart = 0, allowed = 0;
    for (const char* drive : kDrives) {
      const Case c = ours(drive, p);
      const Difference d = difference(c.ours, every(4, spice::run(c.parameters, c.start, p.events, kStep / 4, p.duration, own_folder())));
      peak = std::max(peak, d.peak);
      apart = std::max(apart, d.current / d.peak);
      allowed = std::max(allowed, unshared(c, p) / d.peak);
    }
    block += fmt::format("| {} | {:.1f} | {} | {} |\n", p.name, peak, up(apart), up(allowed));
  }
  block += "\n";
  const std::string path = STEPLOCK_DOCS "/plant.md";
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  std::string page = text.str();
  const std::string begin = "<!-- printed by spice_test -->\n";
  const auto from = page.find(begin), to = page.find("<!-- end -->", from);
  ASSERT_TRUE(from != std::string::npos && to != std::string::npos) << path;
  const auto start = from + begin.size();
  if (std::getenv("STEPLOCK_REPRINT")) {
    std::ofstream(path) << page.replace(start, to - start, block);
    return;
  }
  EXPECT_EQ(page.substr(start, to - start), block) << "STEPLOCK_REPRINT=1 spice_test mends it";
}

INSTANTIATE_TEST_SUITE_P(Drives, Spice, testing::ValuesIn(kDrives), [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace steplock
