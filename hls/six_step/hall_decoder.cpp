#include "hls/six_step/hall_decoder.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::HallDecoder>;
