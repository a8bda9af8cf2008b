#include "hls/bus/six_step_axi.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SixStepAxi>;
