// A block, to the generator: a class with one clock of behaviour and no more.
//
//     struct In { ... };             ports in,  one per number        (a default value each)
//     struct Out { ... };            ports out, one per number
//     Out tick(const In&);           one clock: outputs from inputs and present state, next state
//     private members with defaults  registers, reset to their default values; or blocks: instances
//
// A parent's tick calls the tick of every member block exactly once, whatever happens.
//
// A source that shall become SystemVerilog names its top and says nothing else:
//
//     template struct steplock::Synthesize<steplock::VcoCounter<>>;
//
// The line makes the compiler emit both functions below; the generator follows them to everything
// else.  Native builds pay nothing for it.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

namespace steplock {

template <class Block>
struct Synthesize {
  // Not `return Block{}`, which would clear the members that have no default value of their own.
  static Block reset() {
    Block block;
    return block;
  }
  static typename Block::Out tick(Block& block, const typename Block::In& in) {
    return block.tick(in);
  }
};

}  // namespace steplock
