// Figs. 9 and 10 of Matsui 1996, the initial position of a salient rotor; and how it runs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/design/sinusoidal/design.hpp"
#include "testbench/paper/matsui1996.hpp"
#include "testbench/drive/sinusoidal/fixed_engine.hpp"

namespace steplock::matsui1996 {
namespace {

using design::Estimator;
using design::StartBy;
using sinusoidal::State;

constexpr int kPlaces = 64;
constexpr int kFewPlaces = 8;
constexpr double kLongEnough = 0.03;  // s, calibration and all pulses

// Fig. 9(b), (c): a winding's current at the end of a pulse along it, of a rotor that stands.
double peak(const design::Settings& s, double pole_deg, int winding, double seconds) {
  plant::Plant plant(plant_parameters(s), initial_state(s, pole_deg - 180));
  const auto high = [&](int leg) { return leg == winding; };
  plant.set_gates({.uh = high(0), .ul = !high(0), .vh = high(1), .vl = !high(1), .wh = high(2),
                   .wl = !high(2)});
  plant.advance_to(seconds);
  return plant.state().current[static_cast<std::size_t>(winding)];
}

struct Distribution {
  std::array<Curve, 3> curves;
  double mean = 0, swing = 0;       // A: I_o, Delta I_o
  double along = 0, against = 0;    // A, of winding u with the N pole there, and opposite
};

Distribution distribution(const design::Settings& s, double seconds) {
  Distribution d{.curves = {Curve{"I_U", palette::kU, {}}, Curve{"I_V", palette::kV, {}},
                            Curve{"I_W", palette::kW, {}}}};
  double cosine = 0, sine = 0;
  for (int n = 0; n < kPlaces; ++n) {
    const double pole = n * 360.0 / kPlaces, twice = 2 * pole * std::numbers::pi / 180;
    for (int winding = 0; winding < 3; ++winding) {
      const double i = peak(s, pole, winding, seconds);
      d.curves[static_cast<std::size_t>(winding)].points.push_back({pole, i});
      if (winding > 0) continue;
      d.mean += i / kPlaces;
      cosine += 2 * i * std::cos(twice) / kPlaces;
      sine += 2 * i * std::sin(twice) / kPlaces;
      if (n == 0) d.along = i;
      if (2 * n == kPlaces) d.against = i;
    }
  }
  d.swing = std::hypot(cosine, sine);
  return d;
}

struct Search {
  Curve estimated, error;
  double worst = 0, turned = 0, seconds = 0;
  int none = 0, flipped = 0;
};

Search search(const design::Settings& salient, EngineKind engine, const char* colour,
           const PaperOptions& options) {
  Search f{.estimated = {name_of(engine), colour, {}}, .error = {name_of(engine), colour, {}}};
  f.estimated.dots = f.error.dots = true;
  for (int n = 0; n < kPlaces; ++n) {
    const std::string what = fmt::format("Fig. 10, engine {}", name_of(engine));
    if (options.progress && !options.progress(what, double(n) / kPlaces)) throw Stopped();
    const double angle = n * 360.0 / kPlaces;
    const Start s = start_from(salient, engine, StartBy::kPilot, angle, kLongEnough);
    if (!s.result.position_error_deg) {
      ++f.none;
      continue;
    }
    const double off = *s.result.position_error_deg, actual = std::fmod(angle + 180, 360);
    if (std::abs(off) > 90) ++f.flipped;
    f.worst = std::max(f.worst, std::abs(off));
    f.estimated.points.push_back({actual, actual + off});
    f.error.points.push_back({actual, off});
    for (const auto& c : s.record.changes) {
      if (c.state != State::kStarting) continue;
      f.turned = std::max(f.turned, std::abs(std::remainder(c.angle_deg - actual, 360)));
      f.seconds = std::max(f.seconds, c.time);
    }
  }
  return f;
}

// From a few places: how often `reason` was given, and nothing else.
Claim refused(const design::Settings& believed, const design::Settings& real,
              sinusoidal::Reason reason, const std::string& name) {
  int said = 0;
  for (int n = 0; n < kFewPlaces; ++n) {
    sinusoidal::BenchOf<sinusoidal::FixedEngine> bench(
        believed, real, timeline(steady(believed, Estimator::kCurrent, 600)), 360.0 / kFewPlaces * n + 10);
    bench.run_until(kLongEnough);
    const sinusoidal::Record record = bench.take();
    const auto is = [](State state) { return [=](const auto& c) { return c.state == state; }; };
    const auto end = std::ranges::find_if(record.changes, is(State::kRetryDelay));
    said += end != record.changes.end() && end->reason == reason &&
            std::ranges::none_of(record.changes, is(State::kStarting));
  }
  return {name, "", {}, "not shown", double(said), fmt::format("of {} places; engine fixed", kFewPlaces)};
}

Figure pulses(const design::Settings& salient, EngineKind engine) {
  constexpr double kAngle = 77;  // degrees, of the rotor; its N pole is opposite
  const Start s = start_from(salient, engine, StartBy::kPilot, kAngle, kLongEnough);
  std::array<Curve, 3> currents = {Curve{"I_U", palette::kU, {}}, Curve{"I_V", palette::kV, {}},
                                   Curve{"I_W", palette::kW, {}}};
  for (const auto& x : s.record.overview) {
    for (std::size_t k = 0; k < 3; ++k) {
      currents[k].points.push_back({1e3 * x.time, x.plant.current[k]});
    }
  }
  for (Curve& c : currents) c.points = outlined(c.points, 1200);
  return {.name = "fig9a",
          .title = "Fig. 9(a): currents of the pilot pulses",
          .axis = "time, ms",
          .caption = fmt::format("Engine {}, the N pole at {} degrees: {} rounds of six short pulses, the search for "
                                 "their angle, two long pulses, the start.",
                                 name_of(engine), std::fmod(kAngle + 180, 360),
                                 design::sinusoidal::design_drive(salient).parameters.pilot.repeats),
          .panels = {{.label = "current, A", .curves = {currents.begin(), currents.end()}}}};
}

}  // namespace

PaperSection initial_position(const design::Settings& salient, const PaperOptions& options,
                              matsui1996::Found& found) {
  const auto d = design::sinusoidal::design_drive(salient);
  const auto& pilot = d.parameters.pilot;
  const Distribution shorts = distribution(salient, pilot.short_s);
  const Distribution longs = distribution(salient, pilot.long_s);
  const Search drive = search(salient, options.engine, palette::kW, options);
  const Search exact = search(salient, EngineKind::kFloat, palette::kQuiet, options);
  found.position_deg = drive.worst;
  design::Settings unsaturated = salient, round = salient;
  unsaturated.motor.saturation = 0;
  round.motor.inductance_d_h = round.motor.inductance_q_h = salient.motor.inductance_h;
  const Claim no_polarity = refused(salient, unsaturated, sinusoidal::Reason::kNoPolarity,
                                    "iron that does not saturate: no polarity");
  const Claim no_saliency =
      refused(salient, round, sinusoidal::Reason::kNoSaliency, "a round rotor: no saliency");

  const std::string engine = name_of(options.engine);
  PaperSection s{
      .title = "Figs. 9 and 10: initial position from pilot pulses",
      .text = fmt::format(
          "The 2.2 kW salient motor of [ipm_2k2.toml](../../drives/ipm_2k2.toml) at standstill, "
          "12-bit ADCs with noise, engine `{}` and the reference in doubles. The paper "
          "pulses each winding once; here each pulse is also given reversed, which cancels what "
          "iron adds, and the position comes by halving instead of (24)'s quotient "
          "([pilot_pulses](../blocks/pilot_pulses.md)). Aim: 3 degrees, polarity always right. "
          "Another motor than the paper's, so that amperes do not compare.",
          engine),
      .claims = {
          {fmt::format("worst error from {} places, engine {}", kPlaces, engine), "deg", {},
           "close agreement", drive.worst,
           fmt::format("{}float {:.4g} deg: there every peak counts in both parts of the sum",
                       drive.worst > 3 ? "**missed**; " : "", exact.worst)},
          {"wrong polarity", "", {}, "none", double(drive.flipped),
           fmt::format("float {}", exact.flipped)},
          {"no position found", "", {}, "none", double(drive.none),
           fmt::format("float {}", exact.none)},
          {"turned by the pulses, worst", "deg", {}, "not shown", drive.turned,
           fmt::format("electrical; the design's bound is {:.2g}",
                       pilot.turned * 180 / std::numbers::pi)},
          {"found after", "ms", {}, "not shown", 1e3 * drive.seconds,
           "from the command on, with 16 samples for the ADCs' offsets"},
          no_polarity,
          no_saliency,
          {"short pulse: Delta I_o / I_o", "%", {}, "Fig. 9(b)", 100 * shorts.swing / shorts.mean,
           fmt::format("(21) gives {:.1f} %; the rest is iron", 100 * d.saliency)},
          {"long pulse: I_U at 0 over 180 degrees", "", {}, "Fig. 9(c)",
           longs.along / longs.against, "iron along the magnet"}},
      .figures = {pulses(salient, options.engine)}};
  for (const auto& [name, title, of] :
       {std::tuple{"fig9b", "Fig. 9(b): peaks of short pulses", &shorts},
        {"fig9c", "Fig. 9(c): peaks of long pulses", &longs}}) {
    s.figures.push_back({.name = name,
                         .title = title,
                         .axis = "rotor position, deg",
                         .caption = "The plant alone, one winding against the two others.",
                         .panels = {{.label = "current, A",
                                     .curves = {of->curves.begin(), of->curves.end()}}}});
  }
  s.figures.push_back(
      {.name = "fig10",
       .title = "Fig. 10: actual and estimated rotor position at standstill",
       .axis = "actual position, deg",
       .caption = fmt::format("{} places, electrical degrees.", kPlaces),
       .panels = {{.label = "estimated, deg",
                   .curves = {exact.estimated, drive.estimated},
                   .weight = 1.6},
                  {.label = "error, deg", .curves = {exact.error, drive.error}}}});
  if (drive.worst > 3 || drive.flipped + drive.none > 0)
    s.failures.push_back("3 degrees and the right polarity from everywhere");
  for (const Claim& refusal : {no_polarity, no_saliency}) {
    if (refusal.ours != kFewPlaces) s.failures.push_back("refused from everywhere: " + refusal.quantity);
  }
  return s;
}

PaperSection salient_running(const design::Settings& salient, const PaperOptions& options) {
  PaperSection s{
      .title = "The salient motor running",
      .text =
          "The observer knows one inductance. With L = L_q what is left of the voltage is the "
          "derivative of a flux K_E + (L_d - L_q) i_gamma along gamma, as constant as i_gamma is: "
          "with i_gamma at zero the estimators are those of a round rotor. What the paper says of "
          "a salient motor is its start alone. Each run starts by pilot pulses; engine `fixed`, and "
          "`float` for what another inductance would do.",
  };
  const auto told = [](const std::vector<Point>& points) {
    double delta = 0;
    for (const Point& p : points) delta = std::max(delta, std::abs(p.delta_deg));
    return all_held(points) ? fmt::format("delta theta {:.2g} deg", delta) : "**missed**: lost";
  };
  for (const auto& [estimator, name] :
       {std::pair{Estimator::kCurrent, "current model"}, {Estimator::kVoltage, "voltage model"}}) {
    for (const double rpm : {150.0, 1200.0}) {
      const Case c{.estimator = estimator, .rpm = rpm, .i_gamma = 0.6, .torques = {0, 1, -1}};
      const std::string what = fmt::format("salient, {}, {:g} r/min", name, rpm);
      const auto points = measure(salient, salient, c, options, what);
      s.claims.push_back(
          {fmt::format("{}, {:g} r/min, torque 0, 100, -100 %: worst error", name, rpm), "%", {},
           "not shown", worst_error(points), told(points) + ", i_gamma 0.6 A"});
      if (!all_held(points)) s.failures.push_back(what);
    }
  }
  for (const auto& [inductance, name] :
       {std::pair{*salient.motor.inductance_q_h, "L_q"},
        {salient.motor.inductance_h, "the mean of both"},
        {*salient.motor.inductance_d_h, "L_d"}}) {
    design::Settings believed = salient;
    believed.motor.inductance_q_h = inductance;
    const Case c{.engine = EngineKind::kFloat, .rpm = 600, .torques = {1}};
    const auto points = measure(believed, salient, c, options, "salient, L");
    s.claims.push_back({fmt::format("observer with {}, 600 r/min, rated torque: error", name), "%",
                        {}, "not shown", worst_error(points), told(points) + ", float"});
  }
  return s;
}

}  // namespace steplock::matsui1996
