#include "hls/sinusoidal/spi_adc.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SpiAdc>;
