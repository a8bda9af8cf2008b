#include "hls/bus/six_step_axes.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SixStepAxes<>>;
