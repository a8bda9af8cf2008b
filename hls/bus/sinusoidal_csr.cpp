#include "hls/bus/sinusoidal_csr.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SinusoidalCsr>;
