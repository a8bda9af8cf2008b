#include "hls/bus/sinusoidal_registered.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SinusoidalRegistered>;
