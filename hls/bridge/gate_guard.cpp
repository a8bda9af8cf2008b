#include "hls/bridge/gate_guard.hpp"

#include "hls/numeric/block.hpp"

template struct steplock::Synthesize<steplock::GateGuard<>>;
