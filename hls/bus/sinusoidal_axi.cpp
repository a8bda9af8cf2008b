#include "hls/bus/sinusoidal_axi.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SinusoidalAxi>;
