// Amano 2003 figure by figure, on the drive of drives/amano2003.toml and on what the paper's other
// runs need: the rotor without its fan, and the winding with fewer turns.
//
// Doc: docs/papers/amano2003.md (printed)   Test: tests/testbench/paper_page_test.cpp
#pragma once

#include <string>

#include "model/design/design.hpp"
#include "model/design/settings.hpp"
#include "testbench/paper/paper_options.hpp"
#include "testbench/paper/paper_page.hpp"
#include "testbench/drive/six_step/summary.hpp"

namespace steplock {

// `drive` as drives/amano2003.toml has it.  Throws std::runtime_error when stopped.
PaperPage amano2003_page(const design::Settings& drive, const PaperOptions&);

namespace amano2003 {

struct Trial {
  design::Settings settings;
  Summary summary;
  Record record;
};
Trial run_trial(const design::Settings&, const PaperOptions&, EngineKind, const std::string& what);
// The same of a drive that the design library refuses.
Trial run_refused(const design::Settings&, const PaperOptions&, EngineKind, const std::string& what);

// The scenario without load step, reversal and stop: to `rpm`, and on for the rest of `seconds`.
design::Settings steady_run(design::Settings, double rpm, double seconds);
// Without the fan's inertia and drag; start and speed control as the design library works them out.
design::Settings without_fan(design::Settings);
// The same copper in `turns` times the turns: flux goes with it, resistance and inductance with its
// square.
design::Settings rewound(design::Settings, double turns);
// A loop whose bandwidth grows with speed, as the design library works it out.
design::Settings per_step_loop(design::Settings);
// The paper's kind of loop, designed again by Eqs. (15)-(17) around a greater mean frequency.
design::Settings redesigned_loop(design::Settings, double f_m_hz);

// Phase margin at this speed, degrees, of a loop that learns of one crossing a turn.
double margin_once_per_turn(const design::Design&, int pole_pairs, double rpm);

// r/min at which the back-EMF of this winding takes the whole bus.
double no_load_rpm(const design::Settings&);

PaperSection start_sequence(const design::Settings&, const PaperOptions&);   // Fig. 5
PaperSection loop_response(const design::Settings&, const PaperOptions&);    // Fig. 6
PaperSection own_detector(const design::Settings&, const PaperOptions&);     // one crossing a turn
PaperSection locked_state(const design::Settings&, const PaperOptions&);     // Fig. 7
PaperSection steady_state(const design::Settings&, const PaperOptions&);     // Fig. 8
PaperSection current_control(const design::Settings&, const PaperOptions&);  // Fig. 9
PaperSection varied_load(const design::Settings&, const PaperOptions&);      // Fig. 10
PaperSection high_speed(const design::Settings&, const PaperOptions&);       // Figs. 11 and 12
PaperSection against_hall(const design::Settings&, const PaperOptions&);     // Fig. 13
PaperSection light_rotor(const design::Settings&, const PaperOptions&);      // both loop forms

}  // namespace amano2003
}  // namespace steplock
