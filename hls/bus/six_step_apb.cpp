#include "hls/bus/six_step_apb.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SixStepApb>;
