// What a member of a drive's words is called, from the way to it (hls/bus/register_map.hpp).
//
//     word_name<At<&SixStepConfig::speed, &SpeedConfig::kp>>('.') = "speed.kp"
//
// Test: tests/testbench/engine_test.cpp
#pragma once

#include <string>
#include <string_view>

#include "hls/bus/register_map.hpp"

namespace steplock {

// What the compiler calls the way to a word, such as "&steplock::SixStepConfig::pwm, &steplock::PwmConfig::period".
template <auto... Path>
constexpr std::string_view path_name(At<Path...>) {
  return __PRETTY_FUNCTION__;
}

template <class Place>
std::string word_name(char between) {
  constexpr std::string_view path = path_name(Place{});
  std::string name;
  for (std::size_t at = path.find('&'); at != path.npos; at = path.find('&', at + 1)) {
    const std::size_t end = path.find_first_of(",>})];", at);
    const std::size_t begin = path.rfind("::", end) + 2;
    if (!name.empty()) name += between;
    name += path.substr(begin, end - begin);
  }
  return name;
}

}  // namespace steplock
