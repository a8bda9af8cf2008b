#include "testbench/drive/sinusoidal/watch.hpp"

namespace steplock::sinusoidal {

const char* name_of(State s) {
  constexpr const char* kNames[] = {"idle", "calibrate", "pilot", "pattern", "starting",
                                    "run",  "slow_down", "brake", "retry_delay",    "fault"};
  return kNames[static_cast<int>(s)];
}

const char* name_of(Reason r) {
  constexpr const char* kNames[] = {"none",     "fault_pin", "over_current", "lost_sample",
                                    "saturated", "too_slow", "emf",          "no_lock",
                                    "no_decay", "no_saliency", "no_polarity"};
  return kNames[static_cast<int>(r)];
}

}  // namespace steplock::sinusoidal
