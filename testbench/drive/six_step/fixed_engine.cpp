// What runs the blocks is compiled here, once: inlined to the last block, since two thirds of the time are calls and copies
// otherwise, it takes the compiler ten seconds.
#include "testbench/drive/six_step/fixed_engine.hpp"

namespace steplock {

[[gnu::flatten]] void FixedEngine::tick() {
  out_ = top_.tick(in_);
  ticked_ = true;
}

[[gnu::flatten]] std::uint64_t FixedEngine::run(std::uint64_t most) {
  if (ticked_) return top_.advance(in_, out_, most);
  tick();
  return 1;
}

[[gnu::flatten]] std::uint64_t FixedEngine::tick_and_foresee(std::uint64_t most) {
  if (ticked_) return top_.tick_and_foresee(in_, out_, most);
  tick();
  return 0;
}

std::uint64_t FixedEngine::quiet() const { return ticked_ ? top_.quiet(in_, out_) : 0; }

void FixedEngine::skip_quiet(std::uint64_t clocks) { out_.step_phase = top_.skip(in_, out_, clocks); }

void FixedEngine::skip(std::uint64_t clocks) {
  if (clocks > 1) top_.skip(in_, out_, clocks - 1);
  tick();
}

}  // namespace steplock
