// Matsui 1996 figure by figure, on the drives of drives/matsui1996.toml and drives/ipm_2k2.toml.
//
// Speeds are the plant's, over whole electrical turns; delta theta is the true angle of the N pole
// less theta_c.  Torque is a shaft's that pulls either way, so that -100 % is regeneration.
//
// Doc: docs/papers/matsui1996.md (printed)   Test: tests/testbench/paper_matsui_test.cpp
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "testbench/paper/paper_options.hpp"
#include "testbench/paper/paper_page.hpp"
#include "testbench/drive/sinusoidal/run.hpp"

namespace steplock {

// `drive` as drives/matsui1996.toml has it, `salient` as drives/ipm_2k2.toml.  Throws Stopped.
PaperPage matsui1996_page(const design::Settings& drive, const design::Settings& salient,
                          const PaperOptions&);

namespace matsui1996 {

// A drive that runs with any engine, designed for `believed` on a plant of `real`.
class Rig {
 public:
  virtual ~Rig() = default;
  virtual void run_until(double seconds) = 0;
  virtual double time() const = 0;
  virtual void set_speed(double rpm) = 0;
  virtual void set_torque(double nm) = 0;  // against turning forward
  virtual plant::State state() = 0;
  virtual sinusoidal::View view() = 0;
  virtual bool locked() = 0;
  virtual double delta_deg() = 0;
  virtual sinusoidal::Totals totals() = 0;
  virtual sinusoidal::Record take() = 0;
};
std::unique_ptr<Rig> make_rig(EngineKind, const design::Settings& believed,
                              const design::Settings& real, double angle_deg);

// The scenario without its events, at set speed `rpm`.
design::Settings steady(design::Settings, design::Estimator, double rpm, double i_gamma = 0);
double rated_torque(const design::Settings&);

struct Point {
  double rpm = 0, torque = 0;  // of the rated one
  bool held = false;           // locked to the end, within 20 %
  double error_percent = 0;    // of the mean speed
  double delta_deg = 0;        // mean
  double least_rpm = 0, greatest_rpm = 0, rms_rpm = 0;       // true speed in that time; rms about its mean
  double delta_rms_deg = 0, delta_greatest_deg = 0;          // of delta theta, greatest of either sign
  double swing_percent() const { return 100 * (greatest_rpm - least_rpm) / rpm; }  // peak to peak
};

// One start, then each torque in turn: settled, and measured over whole electrical turns.
struct Case {
  EngineKind engine = EngineKind::kFixed;
  design::Estimator estimator = design::Estimator::kCurrent;
  double rpm = 0, i_gamma = 0;
  std::vector<double> torques = {};
  bool slowly = false;  // each torque is raised over a second, not put on at once
};
std::vector<Point> measure(const design::Settings& believed, const design::Settings& real,
                           const Case&, const PaperOptions&, const std::string& what);
// The RTL against engine fixed: the same run, so the same numbers; else a failure.
Claim rtl_point(const design::Settings&, const Case& fixed, const std::string& where,
                const PaperOptions&, std::vector<std::string>& failures);
bool all_held(const std::vector<Point>&);
double worst_error(const std::vector<Point>&);  // percent, without sign
const Point& most_swinging(const std::vector<Point>&);

struct Start {
  sinusoidal::Result result;
  sinusoidal::Record record;
};
Start start_from(design::Settings, EngineKind, design::StartBy, double angle_deg, double seconds);

// What Table III needs of the figures.
struct Found {
  // By design::Estimator: from this speed on, within this of it.
  double slowest[2] = {}, error_percent[2] = {};
  double swing_percent[2] = {};  // of the true speed there, peak to peak
  double position_deg = 0;  // worst, of a salient rotor at standstill
  double loop_khz = 0;      // the fastest with every point within its aim
};

PaperSection voltage_model(const design::Settings&, const PaperOptions&, Found&);     // Fig. 4
PaperSection current_model(const design::Settings&, const PaperOptions&, Found&);     // Fig. 5
PaperSection causes_of_the_swing(const design::Settings&, const PaperOptions&);
PaperSection wrong_parameters(const design::Settings&, const PaperOptions&);          // Fig. 5(b)
PaperSection torque_on_and_off(const design::Settings&, const PaperOptions&);         // Fig. 6
PaperSection starts(const design::Settings&, const PaperOptions&);                    // Fig. 7
PaperSection initial_position(const design::Settings& salient, const PaperOptions&,
                              Found&);                                                // 9, 10
PaperSection salient_running(const design::Settings& salient, const PaperOptions&);
PaperSection loop_rates(const design::Settings&, const PaperOptions&, Found&);
PaperSection comparison(const design::Settings&, const Found&);                       // Table III

}  // namespace matsui1996
}  // namespace steplock
