#include "hls/bus/six_step_csr.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SixStepCsr>;
