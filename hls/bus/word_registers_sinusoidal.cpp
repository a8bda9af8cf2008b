#include "hls/bus/word_registers.hpp"
#include "hls/bus/sinusoidal_registers.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::WordRegisters<steplock::Sinusoidal>>;
