#include "hls/six_step/bemf_comparator.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::BemfComparator>;
