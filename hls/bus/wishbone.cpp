#include "hls/bus/wishbone.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::Wishbone>;
