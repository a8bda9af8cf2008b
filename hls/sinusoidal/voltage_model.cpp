#include "hls/sinusoidal/voltage_model.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::VoltageModelLoop>;
