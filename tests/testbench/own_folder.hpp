// A folder that no other test writes: tests run side by side, each in a process of its own.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace steplock {

inline std::filesystem::path own_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  std::ranges::replace(name, '/', '_');
  const auto folder = std::filesystem::path(testing::TempDir()) / ("steplock_" + name);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace steplock
