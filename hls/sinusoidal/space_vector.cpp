#include "hls/sinusoidal/space_vector.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::SpaceVectorLoop>;
