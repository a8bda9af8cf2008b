#include "hls/sinusoidal/sinusoidal_control.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SinusoidalLoop>;
