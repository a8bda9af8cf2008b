#include "hls/sinusoidal/sinusoidal_top.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SinusoidalTop>;
