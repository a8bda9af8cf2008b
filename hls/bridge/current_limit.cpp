#include "hls/bridge/current_limit.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::CurrentLimit>;
