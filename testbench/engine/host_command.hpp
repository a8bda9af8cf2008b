// What firmware and the fault pin tell a drive while it runs, whichever engine plays it.
//
// Test: tests/testbench/engine_test.cpp
#pragma once

namespace steplock {

struct HostCommand {
  bool run = false, reverse = false, brake_to_stop = false, clear_fault = false;
  bool fault_pin = false;
  double set_speed = 0;  // commutation steps per second; 0: that of the configuration
};

}  // namespace steplock
