#include "hls/six_step/speed_control.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SpeedControl>;
