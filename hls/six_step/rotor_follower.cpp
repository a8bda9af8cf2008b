#include "hls/six_step/rotor_follower.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::RotorFollower>;
