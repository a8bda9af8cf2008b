#include "hls/six_step/start_sequence.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::StartSequence>;
