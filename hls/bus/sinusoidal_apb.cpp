#include "hls/bus/sinusoidal_apb.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SinusoidalApb>;
