// Keys of drive files that had another name in an earlier version: whoever still writes the old one is told the new one.
//
// Doc: docs/drive_file.md   Test: tests/testbench/drive_file_test.cpp

#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace steplock {

struct RenamedKey {
  std::string_view was, is;
};

inline constexpr std::array<RenamedKey, 5> kRenamedKeys = {{{"observe_s", "detect_spin_s"},
                                                            {"settle_s", "pre_align_s"},
                                                            {"reset_s", "align_s"},
                                                            {"reset_current_a", "align_current_a"},
                                                            {"rest_s", "retry_delay_s"}}};

// The name of a key today, if it is one of `keys`; else empty.
template <class Keys>
std::string_view renamed_key(std::string_view was, const Keys& keys) {
  for (const RenamedKey& key : kRenamedKeys) {
    if (key.was == was && std::ranges::find(keys, key.is) != keys.end()) return key.is;
  }
  return {};
}

}  // namespace steplock
