// The words of a drive as the C driver takes them: what `steplock design FILE --c-header` prints,
// straight from the table of registers.
//
// Doc: docs/six_step_registers.md   Test: tests/testbench/host_driver_test.cpp
#pragma once

#include <vector>

#include "testbench/registers/registers.hpp"
#include "rtl/host/steplock.h"

namespace steplock {

template <class Table = SixStep>
std::vector<steplock_word> register_config(const typename Table::Config& config) {
  std::vector<steplock_word> list;
  for (const auto& [address, value] : registers::values_of<Table>(config)) list.push_back({std::uint32_t(address), value});
  return list;
}

}  // namespace steplock
