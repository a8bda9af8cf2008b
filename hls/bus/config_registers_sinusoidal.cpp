#include "hls/bus/config_registers.hpp"
#include "hls/bus/sinusoidal_registers.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::ConfigRegisters<steplock::Sinusoidal>>;
