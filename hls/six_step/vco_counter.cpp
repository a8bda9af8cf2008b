#include "hls/six_step/vco_counter.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::VcoCounter>;
