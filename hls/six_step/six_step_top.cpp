#include "hls/six_step/six_step_top.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SixStepTop>;
