// The state machine without its neighbours of blocks.cpp: its module must not tell the difference.

#include "hls/numeric/block.hpp"
#include "tests/generator/frontend/blocks/control.hpp"

template struct steplock::Synthesize<steplock::test::StateMachine>;
