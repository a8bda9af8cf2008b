#include "hls/sinusoidal/current_sense.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::CurrentSense>;
