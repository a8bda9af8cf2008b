// The tops of design_test; each test names the one it wants.

#include "hls/numeric/block.hpp"
#include "tests/generator/frontend/blocks/accumulator.hpp"
#include "tests/generator/frontend/blocks/arrays.hpp"
#include "tests/generator/frontend/blocks/calls.hpp"
#include "tests/generator/frontend/blocks/control.hpp"
#include "tests/generator/frontend/blocks/hierarchy.hpp"
#include "tests/generator/frontend/blocks/memory.hpp"
#include "tests/generator/frontend/blocks/named.hpp"
#include "tests/generator/frontend/blocks/numbers.hpp"
#include "tests/generator/frontend/blocks/parameters.hpp"
#include "tests/generator/frontend/blocks/regressions.hpp"
#include "tests/generator/frontend/blocks/scheduled.hpp"

namespace steplock {

template struct Synthesize<test::PhaseAccumulator<>>;
template struct Synthesize<test::PhaseAccumulator<12, 3>>;
template struct Synthesize<test::StateMachine>;
template struct Synthesize<test::SectorCounter>;
template struct Synthesize<test::Loops<11>>;
template struct Synthesize<test::History>;
template struct Synthesize<test::Tables>;
template struct Synthesize<test::Arithmetic>;
template struct Synthesize<test::Wide>;
template struct Synthesize<test::Plain>;
template struct Synthesize<test::Calls>;
template struct Synthesize<test::Hierarchy>;
template struct Synthesize<test::EarlyReturns>;
template struct Synthesize<test::SwitchBehindSwitch>;
template struct Synthesize<test::Closure>;
template struct Synthesize<test::ContinueInWhile>;
template struct Synthesize<test::Rewritten>;
template struct Synthesize<test::LimitedIndex>;
template struct Synthesize<test::TablesOfOneName>;
template struct Synthesize<test::HeldFilter>;
template struct Synthesize<test::HeldCascade>;
template struct Synthesize<test::Named>;
template struct Synthesize<test::Notebook>;
template struct Synthesize<test::Elephant>;
template struct Synthesize<test::PartedCounters>;
template struct Synthesize<test::OwnParameter<3>>;

}  // namespace steplock
