#include "hls/bus/sinusoidal_wb.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SinusoidalWb>;
