#include "testbench/engine/lockstep.hpp"

#include <fmt/format.h>

namespace steplock {

std::string to_text(const Lockstep& l) {
  return fmt::format("{} clocks, every output: {}", l.clocks,
                     l.equal() ? "equal"
                               : fmt::format("DIFFERENT on {}, first {} at clock {}",
                                             l.differing_clocks, l.first_port, l.first_clock));
}

nlohmann::ordered_json to_json(const Lockstep& l) {
  return {{"equal", l.equal()},
          {"clocks", l.clocks},
          {"differing_clocks", l.differing_clocks},
          {"first_clock", l.first_clock},
          {"first_port", l.first_port}};
}

}  // namespace steplock
