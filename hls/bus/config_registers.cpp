#include "hls/bus/config_registers.hpp"
#include "hls/bus/six_step_registers.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::ConfigRegisters<>>;
