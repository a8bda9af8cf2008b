#include "hls/sinusoidal/current_control.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::CurrentLoop>;
