#include "hls/six_step/phase_detector.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::PhaseDetector>;
