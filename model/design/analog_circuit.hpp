// The analog circuit between bridge and FPGA, from a drive file: dividers, their filter, the
// reference, shunt and threshold, in values that can be bought.
//
//     divider     k = R_low / (R_high + R_low); at 5/4 of the bus voltage a comparator sees 2.5 V
//     filter      tau = (R_high || R_low) C: a step of the bus has decayed to the hysteresis within
//                 the blanking, and the lag at the set speed is one electrical degree at most
//     mismatch    2 tolerance (1 - k) V_bus, at the terminals: divider against reference, worst case
//     shunt       100 mV at the current limit, at most
//     threshold   supply * R_bottom / (R_top + R_bottom) = R_shunt * limit
//     edges       R_edge C_edge is a fifth of the limit's blanking
//
// Doc: docs/integration.md   Test: tests/model/design/analog_circuit_test.cpp
#pragma once

#include <string>

#include "model/design/settings.hpp"

namespace steplock::design {

// Of the series E6, E12, E24 or E96 (6, 12, 24, 96 values per decade).
double preferred_at_least(double value, int series);
double preferred_at_most(double value, int series);
double preferred_nearest(double value, int series);

struct Circuit {
  double supply = 3.3;             // V, of comparators and FPGA
  double r_high = 0, r_low = 10e3;  // ohm
  double ratio = 0;                // k
  double largest_input = 0;        // V, at 5/4 of the bus voltage
  double c_filter = 0;             // F, at each comparator; three times that at the star
  double tau = 0;                  // s
  double lag_deg = 0;              // electrical, at the set speed
  double mismatch = 0;             // V at the terminals, with resistors of 0.1 %
  double r_shunt = 0;              // ohm
  double shunt_power = 0;          // W, at the rated current
  double r_top = 0, r_bottom = 1e3;
  double threshold = 0;            // V
  double limit = 0;                // A, with these values
  double r_edge = 100, c_edge = 0;
};

Circuit circuit_of(const Settings&);

// A table of Markdown.
std::string circuit_text(const Settings&, const Circuit&);

}  // namespace steplock::design
