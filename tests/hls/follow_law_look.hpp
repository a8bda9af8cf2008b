// One look, and a belief in a real rotor: for the tests of FollowLaw.
#pragma once

#include <array>

#include "hls/six_step/follow_law.hpp"

namespace steplock::test {

using Belief = FollowLaw::Belief;

inline constexpr UInt<8> kStill = 20;
inline constexpr std::array<int, 6> kCodes = {0b101, 0b100, 0b110, 0b010, 0b011, 0b001};  // of sectors 0 to 5

struct Look : FollowLaw::News {
  Step step = 0;
};
inline Look look(const Belief& was, int code, int step, bool reverse = false, bool clear = true) {
  const auto news = FollowLaw::judge(was, FollowLaw::see(code, clear, step, reverse, was, kStill), code);
  return {news, FollowLaw::step_after(news, code, step, reverse)};
}
inline Belief real(Belief b = {}) {
  b.looked = b.real = true;
  return b;
}

}  // namespace steplock::test
