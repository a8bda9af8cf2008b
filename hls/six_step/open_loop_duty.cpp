#include "hls/six_step/open_loop_duty.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::OpenLoopDuty>;
