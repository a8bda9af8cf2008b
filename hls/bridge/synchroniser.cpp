#include "hls/bridge/synchroniser.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::Synchroniser>;
