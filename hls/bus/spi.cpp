#include "hls/bus/spi.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::Spi>;
