#include "hls/bridge/pwm_generator.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::PwmGenerator>;
