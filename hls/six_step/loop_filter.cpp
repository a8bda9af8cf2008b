#include "hls/six_step/loop_filter.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::LoopFilter>;
