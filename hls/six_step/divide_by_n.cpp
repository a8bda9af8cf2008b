#include "hls/six_step/divide_by_n.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::DivideByN>;
