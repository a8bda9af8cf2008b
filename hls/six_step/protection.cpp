#include "hls/six_step/protection.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::Protection>;
