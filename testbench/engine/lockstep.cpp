#include "testbench/engine/lockstep.hpp"

#include <fmt/format.h>

namespace steplock {

std::string to_text(const Lockstep& l) {
  return fmt::format("{} clocks, every output: {}", l.clocks,
                     l.equal() ? "equal"
                               : fmt::format("DIFFERENT on {}, first {} at clock {}",
                                             l.differing_clocks, l.first_port, l.first_clock));
}

}  // namespace steplock
