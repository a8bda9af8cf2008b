#include "hls/six_step/six_step_bare.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SixStepBare>;
