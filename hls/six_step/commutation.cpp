#include "hls/six_step/commutation.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::Commutation>;
