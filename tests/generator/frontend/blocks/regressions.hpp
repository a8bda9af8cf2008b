// Test blocks: programs that hlsgen once got wrong or refused, cut down.  Most were met by random
// programs (tests/generator/random).

#pragma once

#include "hls/numeric/bits.hpp"

#include <array>

namespace steplock::test {

// The value of `result` is decided by returns at three places; that one of them is always met follows
// from conditions that are not spelled alike.
class EarlyReturns {
 public:
  struct In {
    UInt<16> a = 0;
    Int<9> b = 0;
    template <class F>
    void each(F f) { f(a), f(b); }
  };
  struct Out {
    UInt<16> y = 0;
    template <class F>
    void each(F f) { f(y); }
  };
  Out tick(const In& in) { return {mix(in.a, in.b)}; }

 private:
  static UInt<16> mix(const UInt<16>& a, Int<9> b) {
    UInt<16> sum = 44;
    for (int i = 0; i < 3; ++i) {
      if (b.bit(i)) sum = wrap<UInt<16>>(sum + (a << i));
      if (sum == 45) return a;
    }
    return sum ^ a;
  }
};

// A switch behind the merge of another, whose selector depends on what was merged there.
class SwitchBehindSwitch {
 public:
  enum class Mode : std::uint8_t { kA, kB, kC };
  struct In {
    Mode mode = Mode::kA;
    UInt<8> x = 0;
    template <class F>
    void each(F f) { f(mode), f(x); }
  };
  struct Out {
    UInt<8> y = 0;
    template <class F>
    void each(F f) { f(y); }
  };
  Out tick(const In& in) {
    Out out;
    switch (in.mode) {
      case Mode::kA:
        for (int i = 0; i < 4; ++i) list_[i] = wrap<UInt<8>>(list_[i] * in.x + i);
        out.y = list_[2];
        [[fallthrough]];
      case Mode::kB:
        out.y = wrap<UInt<8>>(out.y * 3 + list_[0]);
        break;
      default:
        if (in.x > 9 && list_[1] == 7) list_[3] = in.x;
    }
    if (in.x == 3) return out;
    switch (int(wrap<UInt<3>>(out.y).raw())) {
      case 0:
        if (list_[0] > in.x) list_[1] = wrap<UInt<8>>(out.y * in.x);
        break;
      case 1:
        if (list_[1] > in.x) return out;
        out.y = wrap<UInt<8>>(out.y + 1);
        break;
      default: break;
    }
    return out;
  }

 private:
  std::array<UInt<8>, 4> list_ = {5, 6, 7, 8};
};

// A closure that holds pointers, called within a loop that writes what they point to.
class Closure {
 public:
  struct In {
    bool first = false;
    Int<24> x = 0;
    UInt<2> i = 0;
    template <class F>
    void each(F f) { f(first), f(x), f(i); }
  };
  struct Out {
    Int<24> y = 0;
    template <class F>
    void each(F f) { f(y); }
  };
  Out tick(const In& in) {
    Out out;
    const auto pick = [&](bool first, const Int<24>& x) {
      return first ? x : wrap<Int<24>>(kept_[wrap<UInt<2>>(kept_[in.i.raw()]).raw()] + out.y);
    };
    for (int i = 0; i < 3; ++i) {
      if (in.i == i) continue;
      kept_[i] = wrap<UInt<9>>(pick(in.first, in.x));
      out.y = pick(kept_[i].bit(2), Int<24>(kept_[3]));
    }
    return out;
  }

 private:
  std::array<UInt<9>, 4> kept_ = {1, 2, 3, 4};
};

// `continue` before anything has changed: to LLVM two loops, one within the other.
class ContinueInWhile {
 public:
  struct In {
    UInt<8> x = 0;
    bool skips = false;
    template <class F>
    void each(F f) { f(x), f(skips); }
  };
  struct Out {
    UInt<4> turns = 0;
    UInt<8> y = 0;
    template <class F>
    void each(F f) { f(turns), f(y); }
  };
  Out tick(const In& in) {
    Out out;
    int i = 0;
    while (i < 5 && kept_ != in.x) {
      ++i;
      if (in.skips) continue;
      for (int k = 0; k < 2; ++k) {
        if (in.x.bit(i + k)) kept_ = wrap<UInt<8>>(kept_ + i);
      }
    }
    out.turns = UInt<4>(i);
    out.y = kept_;
    return out;
  }

 private:
  UInt<8> kept_ = 0;
};

// Signed division by what LLVM turns into -8; a product of which only the overflow is asked; a choice
// between a port and a register, which LLVM turns into a choice between their addresses.
class Rewritten {
 public:
  enum class Mode : std::uint8_t { kA, kB, kC };
  struct In {
    std::int8_t n = 0;
    UInt<17> a = 0;
    UInt<17> b = 0;
    Mode mode = Mode::kA;
    bool takes = false;
    template <class F>
    void each(F f) { f(n), f(a), f(b), f(mode), f(takes); }
  };
  struct Out {
    std::int8_t quotient = 0;
    std::int8_t rest = 0;
    UInt<17> product = 0;
    Mode mode = Mode::kA;
    template <class F>
    void each(F f) { f(quotient), f(rest), f(product), f(mode); }
  };
  Out tick(const In& in) {
    Out out;
    const std::int8_t negative = static_cast<std::int8_t>(-in.n);
    out.quotient = static_cast<std::int8_t>(negative / 8);
    out.rest = static_cast<std::int8_t>(negative % 8);
    out.product = saturate<UInt<17>>(in.a * in.b);
    if (in.takes) {
      mode_ = in.mode;
      out.product = out.product ^ in.a;
    }
    out.mode = mode_;
    return out;
  }

 private:
  Mode mode_ = Mode::kC;
};

// Limited indices whose range alone does not show it: an even number, a few constants.
class LimitedIndex {
 public:
  struct In {
    UInt<8> x = 0;
    bool chooses = false;
    template <class F>
    void each(F f) { f(x), f(chooses); }
  };
  struct Out {
    UInt<9> even = 0;
    UInt<9> chosen = 0;
    UInt<9> cut = 0;
    template <class F>
    void each(F f) { f(even), f(chosen), f(cut); }
  };
  Out tick(const In& in) {
    Out out;
    out.even = kept_[below(wrap<UInt<3>>((in.x << 1) + 2)).raw()];
    out.chosen = kept_[below(wrap<UInt<3>>(in.chooses ? Int<8>(0) : Int<8>(-2))).raw()];
    out.cut = kept_[below(wrap<UInt<3>>(in.x)).raw()];
    kept_[below(wrap<UInt<3>>(kept_[2])).raw()] = wrap<UInt<9>>(in.x * 3);
    return out;
  }

 private:
  static UInt<3> below(UInt<3> i) { return i < 6 ? i : UInt<3>(1); }
  std::array<UInt<9>, 6> kept_ = {10, 20, 30, 40, 50, 60};
};

// Tables of one name and length whose entries differ in width; a line of a table of lines.
template <int W>
struct Sine {
  static constexpr UInt<W> kSine[4] = {1, 50, 99, 77};
};

class TablesOfOneName {
 public:
  struct In {
    UInt<2> at = 0;
    template <class F>
    void each(F f) { f(at); }
  };
  struct Out {
    UInt<8> narrow = 0;
    UInt<9> wide = 0;
    UInt<5> high = 0;
    UInt<6> low = 0;
    UInt<7> line = 0;
    template <class F>
    void each(F f) { f(narrow), f(wide), f(high), f(low), f(line); }
  };
  Out tick(const In& in) {
    Out out;
    out.narrow = Sine<8>::kSine[in.at.raw()];
    out.wide = Sine<9>::kSine[in.at.raw()];
    out.high = kPatterns[in.at.raw()].high;
    out.low = kPatterns[in.at.raw()].low;
    out.line = kLines[1][in.at.raw()];
    return out;
  }

 private:
  struct Pattern {
    UInt<5> high;
    UInt<6> low;
  };
  static constexpr Pattern kPatterns[4] = {{1, 1}, {20, 20}, {3, 3}, {31, 31}};
  static constexpr UInt<7> kLines[2][4] = {{1, 2, 3, 4}, {99, 7, 50, 120}};
};

}  // namespace steplock::test
