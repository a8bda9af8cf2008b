#include "hls/bus/axi_lite.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::AxiLite>;
