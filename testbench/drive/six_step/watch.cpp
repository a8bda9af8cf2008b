#include "testbench/drive/six_step/watch.hpp"

namespace steplock {

const char* name_of(State s) {
  constexpr const char* kNames[] = {"idle",    "detect_spin", "brake",     "pre_align", "align", "accelerate",
                                    "pull_in", "run",     "slow_down", "retry_delay",   "fault"};
  return kNames[static_cast<int>(s)];
}

const char* name_of(Reason r) {
  constexpr const char* kNames[] = {"none",  "fault_pin",  "over_current", "step_out",   "stall",
                                    "wrong_lock", "no_lock", "cannot_stop", "hall_code", "blocked"};
  return kNames[static_cast<int>(r)];
}

}  // namespace steplock
