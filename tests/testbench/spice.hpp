// The bridge and the motor of a drive as a netlist for ngspice: another simulator's answer to the same gates.
//
// Nothing of model/plant computes here; only its parameters and its gate events are read. Diodes are a drop in volts and the
// exponential of Shockley's law, steep enough to stand for a corner: over the currents of a run its voltage moves by less than
// kDiodeDoubt. Switches and terminals leak through kLeak.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/plant/replay.hpp"

namespace steplock::spice {

constexpr double kEdge = 1e-9;   // s, of a gate
constexpr double kLeak = 1e7;    // ohm
constexpr double kEmission = 0.005, kSaturation = 1e-9;  // of the diodes: n, and A
constexpr double kThermal = 0.02585;                    // V, at 300 K
constexpr double kTypical = 1;                          // A, where a diode has its drop
constexpr double kDiodeDoubt = kEmission * kThermal * 10;  // V, over a current that changes e^10 times

struct Flaws {  // negative controls: what is put into the netlist wrongly
  double inductance = 1, resistance = 1, flux = 1, drop_v = 0, edge_s = 0;
};

// Back-EMF shape k at the electrical angle 4 v(th) - 120 k degrees.
inline std::string shape(const plant::Motor& m, int k) {
  const std::string x = fmt::format("({}*v(th)-{:.16g})", m.pole_pairs, 2 * std::numbers::pi / 3 * k);
  if (m.shape.kind == plant::BackEmfShape::Kind::kSinusoidal) return fmt::format("sin({})", x);
  if (m.shape.kind != plant::BackEmfShape::Kind::kTrapezoidal || m.shape.flat_top_deg < 60) {
    throw std::invalid_argument("spice: a sinusoid or a trapezoid with a flat top of 60 degrees at least, please");
  }
  // A flank is asin(sin x) over its own half-width; the sine is cut off first, where asin has no slope.
  const double half = (180 - m.shape.flat_top_deg) / 2 * std::numbers::pi / 180;
  const double cut = (1 + std::sin(half)) / 2;
  const std::string flank = fmt::format("max(-1,min(1,asin(max({0:.16g},min({1:.16g},sin({2}))))/{3:.16g}))", -cut, cut, x, half);
  // Rounded: the cubic through 0 that meets the tops without a corner.
  return m.shape.rounded_flanks ? fmt::format("({0}*(1.5-0.5*{0}*{0}))", flank) : flank;
}

inline std::string netlist(const plant::Parameters& p, const plant::InitialState& start, std::span<const plant::GateEvent> events,
                           double dt, double duration, const std::string& out, const Flaws& flaws = {}) {
  if (!p.bus.sinks || p.bus.resistance <= 0 || p.motor.inductance_d > 0 || p.motor.cogging_torque > 0) {
    throw std::invalid_argument("spice: a bus with a resistance that takes current back, and a round rotor without cogging, please");
  }
  static constexpr const char* kPhase[] = {"u", "v", "w"};
  const plant::Motor& m = p.motor;
  const double drop = p.bridge.diode_drop + flaws.drop_v - kEmission * kThermal * std::log(kTypical / kSaturation);
  const double flux = m.flux * flaws.flux;
  std::string n = "* bridge and motor, written by tests/testbench/spice.hpp\n";
  n += fmt::format(".model sw sw(ron={:.9g} roff={:g} vt=0.5 vh=0.01)\n", p.bridge.on_resistance, kLeak);
  n += fmt::format(".model d d(is={:g} n={:g} rs={:.9g})\n", kSaturation, kEmission, p.bridge.diode_resistance);
  n += fmt::format("Vsrc src 0 dc {:.9g}\nRbus src bus {:.9g}\nCbus bus 0 {:.9g} ic={:.9g}\n", p.bus.voltage, p.bus.resistance,
                   p.bus.capacitance, start.bus_voltage < 0 ? p.bus.voltage : start.bus_voltage);
  std::string torque;
  for (int k = 0; k < 3; ++k) {
    const std::string f = kPhase[k];
    for (const bool high : {true, false}) {
      bool was = false;
      std::string edges = "0 0";
      for (const plant::GateEvent& e : events) {
        const bool gates[] = {e.gates.uh, e.gates.ul, e.gates.vh, e.gates.vl, e.gates.wh, e.gates.wl};
        const bool now = gates[2 * k + (high ? 0 : 1)];
        if (now != was) {
          const double at = e.time + flaws.edge_s;
          edges += fmt::format(" {:.12g} {} {:.12g} {}", at, int(was), at + kEdge, int(now));
        }
        was = now;
      }
      const std::string g = std::string("g") + (high ? "h" : "l") + f;
      n += fmt::format("V{0} {0} 0 pwl({1})\n", g, edges);
      n += high ? fmt::format("Sh{0} bus t{0} {1} 0 sw\nDh{0} t{0} xh{0} d\nVh{0} xh{0} bus {2:.9g}\n", f, g, drop)
                : fmt::format("Sl{0} t{0} 0 {1} 0 sw\nDl{0} 0 xl{0} d\nVl{0} xl{0} t{0} {2:.9g}\n", f, g, drop);
    }
    n += fmt::format("Rt{0} t{0} 0 {1:g}\nVi{0} t{0} a{0} 0\nRa{0} a{0} b{0} {2:.9g}\nL{0} b{0} c{0} {3:.9g} ic={4:.9g}\n", f, kLeak,
                     m.resistance * flaws.resistance, (m.inductance - m.mutual) * flaws.inductance, start.current[k]);
    n += fmt::format("Be{0} c{0} n v={1:.12g}*v(w)*{2}\n", f, flux * m.pole_pairs, shape(m, k));
    torque += fmt::format("{}{}*i(Vi{})", k ? "+" : "", shape(m, k), f);
  }
  // The shaft: a volt is a radian, or a radian a second; dry friction is that of a rotor that turns one way.
  const int way = start.speed < 0 ? -1 : 1;
  n += fmt::format("Cth th 0 1 ic={:.12g}\nBth 0 th i=v(w)\nCw w 0 {:.9g} ic={:.12g}\n", start.angle, m.inertia + p.load.inertia,
                   start.speed);
  n += fmt::format("Bte te 0 v={:.12g}*({})\n", flux * m.pole_pairs, torque);
  n += fmt::format("Bw 0 w i=v(te)-{:.9g}-{:.9g}*v(w)-{:.9g}*v(w)*abs(v(w))\n",
                   way * (m.coulomb_friction + p.load.opposing_torque), m.viscous_friction, m.fan_friction);
  n += ".options method=gear reltol=1e-6 abstol=1e-9 vntol=1e-6 itl4=200\n.control\nset numdgt=12\n";
  n += fmt::format("tran {:.6g} {:.9g} 0 {:.6g} uic\nlinearize\n", dt, duration, dt / 2);
  n += fmt::format("wrdata {} i(viu) i(viv) i(viw) v(tu) v(tv) v(tw) v(w) v(th) v(n) v(bus) v(te)\nquit\n.endc\n.end\n", out);
  return n;
}

// Samples on ngspice's own grid. Throws where it is missing or gives up.
inline std::vector<plant::Sample> run(const plant::Parameters& p, const plant::InitialState& start,
                                      std::span<const plant::GateEvent> events, double dt, double duration,
                                      const std::filesystem::path& folder, const Flaws& flaws = {}) {
  const auto file = folder / "bridge.cir", out = folder / "bridge.txt", log = folder / "ngspice.log";
  std::filesystem::remove(out);
  std::ofstream(file) << netlist(p, start, events, dt, duration, out.string(), flaws);
  if (std::system(fmt::format("ngspice -b '{}' >'{}' 2>&1", file.string(), log.string()).c_str()) != 0 || !std::filesystem::exists(out)) {
    throw std::runtime_error("ngspice did not finish; see " + log.string());
  }
  std::ifstream in(out);
  std::vector<plant::Sample> samples;
  for (std::string line; std::getline(in, line);) {
    std::istringstream row(line);
    plant::Sample s{};
    for (double* value : {&s.iu, &s.iv, &s.iw, &s.vu, &s.vv, &s.vw, &s.speed_rad_s, &s.angle_rad, &s.neutral_v, &s.bus_v, &s.torque_nm}) {
      row >> s.time >> *value;
    }
    if (row) samples.push_back(s);
  }
  return samples;
}

}  // namespace steplock::spice
