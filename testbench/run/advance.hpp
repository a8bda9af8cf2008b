// Clocks of an engine, as many at once as it can take.
//
// Every engine has tick(), one clock, and watch(), what the bench sees of it.  It may have
//
//     uint64_t run(uint64_t most);    ticks up to the first that changes watch(); how many they were
//
// or, if it is fast only where nothing happens,
//
//     uint64_t quiet() const;         clocks for which tick() would do nothing under these inputs
//     void skip(uint64_t clocks);     at most that many
//
// Test: tests/testbench/engine_test.cpp
#pragma once

#include <algorithm>
#include <cstdint>

namespace steplock {

// From 1 to `most` clocks; if watch() changes, then in the last of them.
template <class Engine>
std::uint64_t advance(Engine& engine, std::uint64_t most) {
  if constexpr (requires { engine.run(most); }) {
    return engine.run(most);
  } else {
    if constexpr (requires { engine.skip(engine.quiet()); }) {
      if (const std::uint64_t quiet = engine.quiet(); quiet > 0) {
        const std::uint64_t skipped = std::min(quiet, most);
        engine.skip(skipped);
        return skipped;
      }
    }
    engine.tick();
    return 1;
  }
}

}  // namespace steplock
