// A top of its own: the other tests need not read these headers.

#include "hls/numeric/block.hpp"
#include "tests/generator/frontend/blocks/library.hpp"

template struct steplock::Synthesize<steplock::test::LetterCounter>;
