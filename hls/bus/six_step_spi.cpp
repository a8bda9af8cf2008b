#include "hls/bus/six_step_spi.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SixStepSpi>;
