#include "hls/bus/apb.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::Apb>;
