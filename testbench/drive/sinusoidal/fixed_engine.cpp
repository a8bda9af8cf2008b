// What runs the blocks is compiled here, once, inlined to the last block (testbench/drive/six_step/fixed_engine.cpp).
#include "testbench/drive/sinusoidal/fixed_engine.hpp"

namespace steplock::sinusoidal {

[[gnu::flatten]] void FixedEngine::tick() {
  out_ = top_.tick(inputs_.in);
  inputs_.in.codes.valid = false;
}

[[gnu::flatten]] std::uint64_t FixedEngine::run(std::uint64_t most) {
  const std::uint64_t clocks = top_.advance(inputs_.in, out_, most);
  inputs_.in.codes.valid = false;
  return clocks;
}

}  // namespace steplock::sinusoidal
