#include "hls/six_step/start_counters.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::StartCounters>;
