#include "hls/sinusoidal/drive_protection.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::DriveProtection>;
