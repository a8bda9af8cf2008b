#include "hls/sinusoidal/sinusoidal_standalone.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SinusoidalStandalone>;
