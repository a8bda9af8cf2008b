#include "hls/sinusoidal/sigma_delta.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SigmaDelta<>>;
