#include "hls/sinusoidal/sinc3.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::Sinc3<>>;
