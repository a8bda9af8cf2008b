// The sinusoidal drive's words as the blocks take them, from the same words as the design library gives them
// (testbench/drive/six_step/config.hpp).
//
// Test: tests/testbench/sinusoidal_engines_test.cpp
#pragma once

#include "hls/sinusoidal/spi_adc.hpp"
#include "hls/sinusoidal/config.hpp"
#include "model/design/sinusoidal/config.hpp"

namespace steplock::sinusoidal {

SinusoidalConfig hls_config(const design::Config&);

// Those of a drive's settings.  Throws std::invalid_argument where they do not fit: one line each.
SinusoidalConfig config_of(const design::Settings&);

// Of an AD7928 whose inputs 0, 1 and 2 are u, v and the dc voltage, at the drive's clock: SCLK as fast as
// 20 MHz allows, 300 ns to acquire an input.  Throws likewise where a sample of sinusoidal_standalone, from the
// period's begin over that ADC to the end of the arithmetic, takes longer than a period.
SpiAdcConfig adc_config_of(const design::Settings&);

}  // namespace steplock::sinusoidal
