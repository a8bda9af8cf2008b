#include "hls/bus/sinusoidal_spi.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SinusoidalSpi>;
