#include "hls/sinusoidal/estimator.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::EstimatorLoop>;
