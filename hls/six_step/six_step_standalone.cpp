#include "hls/six_step/six_step_standalone.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SixStepStandalone>;
