#include "hls/sinusoidal/pilot_pulses.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::PilotPulses>;
