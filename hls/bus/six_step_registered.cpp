#include "hls/bus/six_step_registered.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SixStepRegistered>;
