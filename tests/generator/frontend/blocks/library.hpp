// Test block: what the standard library computes at compile time, and bits that it counts.  Its
// headers ask the C library for all that g++ asks it for.

#pragma once

#include "hls/numeric/bits.hpp"

#include <array>
#include <bitset>
#include <complex>
#include <string>
#include <string_view>

namespace steplock::test {

class LetterCounter {
 public:
  struct In {
    UInt<3> at = 0;
    UInt<8> bits = 0;
    template <class F>
    void each(F f) { f(at), f(bits); }
  };
  struct Out {
    UInt<8> letter = 0;
    Int<8> real = 0, imaginary = 0;
    UInt<4> ones = 0;
    template <class F>
    void each(F f) { f(letter), f(real), f(imaginary), f(ones); }
  };
  Out tick(const In& in) {
    constexpr std::complex<int> turned = std::complex<int>(3, -4) * std::complex<int>(0, 1);
    static_assert(turned == std::complex<int>(4, 3));
    Out out;
    out.letter = kLetters[in.at.raw()];
    out.real = turned.real();
    out.imaginary = turned.imag();
    const std::bitset<8> ones(static_cast<unsigned>(kept_.raw()));
    out.ones = static_cast<int>((ones ^ kOdd).count());
    kept_ = kept_ ^ in.bits;
    return out;
  }

 private:
  static constexpr std::array<UInt<8>, 8> kLetters = [] {
    constexpr std::string_view kWord = "steplock";
    std::array<UInt<8>, 8> letters = {};
    for (std::size_t i = 0; i < letters.size(); ++i) letters[i] = int(kWord[i]);
    return letters;
  }();
  static constexpr std::bitset<8> kOdd = 0b10101010;
  UInt<8> kept_ = 0;
};

}  // namespace steplock::test
