#include "hls/sinusoidal/speed_regulator.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SpeedRegulatorLoop>;
