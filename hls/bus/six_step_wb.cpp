#include "hls/bus/six_step_wb.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SixStepWb>;
