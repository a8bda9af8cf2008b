#include "hls/sinusoidal/sinusoidal_sequence.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SinusoidalSequence>;
