#include "hls/sinusoidal/sinusoidal_bare.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SinusoidalBare>;
