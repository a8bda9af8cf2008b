// What an oscilloscope's user reads off a phase current: amplitude, rise and fall of its pulses,
// ripple; the PWM's own ripple averaged out over one PWM period.
//
// Test: tests/testbench/waveform_test.cpp
#pragma once

#include <vector>

#include "testbench/report/figure.hpp"
#include "testbench/drive/six_step/record.hpp"

namespace steplock {

struct Waveform {
  double amplitude = 0;     // A, greatest of the averaged current, either sign
  double rms = 0;           // A, of the current itself
  double rise_s = 0;        // of its pulses, from a tenth to nine tenths of their mean height
  double fall_s = 0;        // and back at their end
  double torque_mean = 0;   // N m
  double torque_ripple = 0; // (greatest - least) / mean of the averaged torque
};

// The curve averaged over `width` around each of its points; linear between points.
std::vector<Point> averaged(const std::vector<Point>&, double width);

// Of phase 0, 1 or 2 over all samples, which should span whole electrical turns.
Waveform waveform(const std::vector<Sample>&, double pwm_s, int phase);

}  // namespace steplock
