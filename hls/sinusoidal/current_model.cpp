#include "hls/sinusoidal/current_model.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::CurrentModelLoop>;
