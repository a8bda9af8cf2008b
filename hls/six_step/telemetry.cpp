#include "hls/six_step/telemetry.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::Telemetry>;
