// Exact-width integers: UInt<W> and Int<W>, 1 to 128 bits, two's complement.
//
//     a + b, a - b   one bit wider than the wider operand: never overflows
//     a * b          the sum of both widths: never overflows
//     a << n, a >> n keep the width (n is a plain int; n >= W is a caller's error)
//     & | ^ ~        the wider width;  comparisons are exact over signs and widths
//
// Widening is implicit, because it keeps the value.  Narrowing has to be named: wrap<T>(x) drops the
// upper bits (ap_fixed and sc_fixed call it AP_WRAP, SC_WRAP), saturate<T>(x) stops at the ends of T
// (AP_SAT, SC_SAT).  A plain int converts by wrapping, so that literals read as literals; a sum or
// product with one takes it in the width of the other operand.
//
// Under clang the storage is _BitInt(W), which the generator turns into wires of W bits; under g++
// it is the next larger built-in integer, kept in range.  Both give the same values for every
// operation (tests/hls/bits_test.cpp runs under both).  Another tool's type, such as ap_int, has one
// place to go: `Storage`.
//
// Doc: docs/blocks/bits.md   Test: tests/hls/bits_test.cpp

#pragma once

#include <cstdint>
#include <type_traits>

namespace steplock {

template <int W, bool Signed>
struct Storage {
  static_assert(W >= 1 && W <= 128, "widths run from 1 to 128 bits");
#ifdef __clang__
  // A signed _BitInt needs two bits at least; no block has use for a lone sign bit.
  using type = std::conditional_t<Signed, signed _BitInt(W < 2 ? 2 : W), unsigned _BitInt(W)>;
  template <class T>
  static constexpr type keep(T v) { return static_cast<type>(v); }
#else
  __extension__ using Signed128 = __int128;
  __extension__ using Unsigned128 = unsigned __int128;
  using SignedHost = std::conditional_t<
      W <= 32, std::int32_t, std::conditional_t<W <= 64, std::int64_t, Signed128>>;
  using UnsignedHost = std::conditional_t<
      W <= 32, std::uint32_t, std::conditional_t<W <= 64, std::uint64_t, Unsigned128>>;
  using type = std::conditional_t<Signed, SignedHost, UnsignedHost>;
  template <class T>
  static constexpr type keep(T v) {
    constexpr int spare = int(sizeof(type)) * 8 - W;
    return static_cast<type>(static_cast<type>(static_cast<UnsignedHost>(v) << spare) >> spare);
  }
#endif
};

template <int W, bool Signed>
class Bits {
  using Keeper = Storage<W, Signed>;
  template <class T>
  using IfInteger = std::enable_if_t<std::is_integral_v<T>, int>;

 public:
  using Raw = typename Keeper::type;
  static constexpr int width = W;
  static constexpr bool is_signed = Signed;

  constexpr Bits() = default;

  template <class T, IfInteger<T> = 0>
  constexpr Bits(T v) : raw_(Keeper::keep(v)) {}

  // Implicit where every value of the source has a place here.
  template <int V, bool S>
    requires(S == Signed ? V <= W : !S && V < W)
  constexpr Bits(Bits<V, S> other) : raw_(Keeper::keep(other.raw())) {}

  static constexpr Bits min() { return Signed ? of(Raw(1) << (W - 1)) : of(Raw(0)); }
  static constexpr Bits max() { return of(~min().raw_); }

  // The bits of v from below, whatever stands above them.
  template <class T>
  static constexpr Bits of(T v) {
    Bits b;
    b.raw_ = Keeper::keep(v);
    return b;
  }

  constexpr Raw raw() const { return raw_; }
  constexpr bool bit(int i) const { return ((raw_ >> i) & Raw(1)) != Raw(0); }
  constexpr bool negative() const { return Signed && raw_ < Raw(0); }

  // Bits hi down to lo, as an unsigned number.
  template <int Hi, int Lo>
  constexpr Bits<Hi - Lo + 1, false> slice() const {
    static_assert(Hi < W && Lo >= 0 && Hi >= Lo);
    return Bits<Hi - Lo + 1, false>::of(raw_ >> Lo);
  }

  constexpr Bits operator<<(int n) const { return of(static_cast<Raw>(raw_ << n)); }
  constexpr Bits operator>>(int n) const { return of(static_cast<Raw>(raw_ >> n)); }
  constexpr Bits operator~() const { return of(static_cast<Raw>(~raw_)); }
  constexpr auto operator-() const {
    using R = Bits<W + 1, true>;
    return R::of(R::of(0).raw() - R::of(raw_).raw());
  }

  // Same type on both sides; found for `x + 1` as well, since 1 converts.
  friend constexpr auto operator+(Bits a, Bits b) { return add(a, b); }
  friend constexpr auto operator-(Bits a, Bits b) { return subtract(a, b); }
  friend constexpr auto operator*(Bits a, Bits b) { return multiply(a, b); }
  friend constexpr Bits operator&(Bits a, Bits b) { return of(static_cast<Raw>(a.raw_ & b.raw_)); }
  friend constexpr Bits operator|(Bits a, Bits b) { return of(static_cast<Raw>(a.raw_ | b.raw_)); }
  friend constexpr Bits operator^(Bits a, Bits b) { return of(static_cast<Raw>(a.raw_ ^ b.raw_)); }
  friend constexpr bool operator==(Bits a, Bits b) { return a.raw_ == b.raw_; }
  friend constexpr bool operator!=(Bits a, Bits b) { return a.raw_ != b.raw_; }
  friend constexpr bool operator<(Bits a, Bits b) { return a.raw_ < b.raw_; }
  friend constexpr bool operator<=(Bits a, Bits b) { return a.raw_ <= b.raw_; }
  friend constexpr bool operator>(Bits a, Bits b) { return a.raw_ > b.raw_; }
  friend constexpr bool operator>=(Bits a, Bits b) { return a.raw_ >= b.raw_; }

 private:
  Raw raw_ = 0;
};

template <int W>
using UInt = Bits<W, false>;  // 0 .. 2^W - 1
template <int W>
using Int = Bits<W, true>;  // -2^(W-1) .. 2^(W-1) - 1

// The narrowest type that holds every value of both.
template <class A, class B>
inline constexpr int common_width =
    A::is_signed == B::is_signed ? (A::width > B::width ? A::width : B::width)
    : A::is_signed               ? (A::width > B::width ? A::width : B::width + 1)
                                 : (B::width > A::width ? B::width : A::width + 1);
template <class A, class B>
using Common = Bits<common_width<A, B>, A::is_signed || B::is_signed>;

template <int A, bool S, int B, bool T>
constexpr auto add(Bits<A, S> a, Bits<B, T> b) {
  using R = Bits<common_width<Bits<A, S>, Bits<B, T>> + 1, S || T>;
  return R::of(R(a).raw() + R(b).raw());
}
template <int A, bool S, int B, bool T>
constexpr auto subtract(Bits<A, S> a, Bits<B, T> b) {
  // The difference of two unsigned numbers is signed.
  using R = Bits<common_width<Bits<A, S>, Bits<B, T>> + 1, true>;
  return R::of(R::of(a.raw()).raw() - R::of(b.raw()).raw());
}
template <int A, bool S, int B, bool T>
constexpr auto multiply(Bits<A, S> a, Bits<B, T> b) {
  using R = Bits<A + B, S || T>;
  return R::of(R::of(a.raw()).raw() * R::of(b.raw()).raw());
}

// Different types on the two sides.
template <class A, class B>
concept Unlike = requires { A::width; B::width; } && !std::is_same_v<A, B>;

template <int A, bool S, int B, bool T>
  requires Unlike<Bits<A, S>, Bits<B, T>>
constexpr auto operator+(Bits<A, S> a, Bits<B, T> b) { return add(a, b); }
template <int A, bool S, int B, bool T>
  requires Unlike<Bits<A, S>, Bits<B, T>>
constexpr auto operator-(Bits<A, S> a, Bits<B, T> b) { return subtract(a, b); }
template <int A, bool S, int B, bool T>
  requires Unlike<Bits<A, S>, Bits<B, T>>
constexpr auto operator*(Bits<A, S> a, Bits<B, T> b) { return multiply(a, b); }

template <class A, class B>
  requires Unlike<A, B>
constexpr bool operator==(A a, B b) { return Common<A, B>(a) == Common<A, B>(b); }
template <class A, class B>
  requires Unlike<A, B>
constexpr bool operator!=(A a, B b) { return Common<A, B>(a) != Common<A, B>(b); }
template <class A, class B>
  requires Unlike<A, B>
constexpr bool operator<(A a, B b) { return Common<A, B>(a) < Common<A, B>(b); }
template <class A, class B>
  requires Unlike<A, B>
constexpr bool operator<=(A a, B b) { return Common<A, B>(a) <= Common<A, B>(b); }
template <class A, class B>
  requires Unlike<A, B>
constexpr bool operator>(A a, B b) { return Common<A, B>(a) > Common<A, B>(b); }
template <class A, class B>
  requires Unlike<A, B>
constexpr bool operator>=(A a, B b) { return Common<A, B>(a) >= Common<A, B>(b); }

// a >= b of unsigned numbers, where a register holds ~b: its carry chain needs no inverter in front.
template <int W>
constexpr bool at_least(Bits<W, false> a, Bits<W, false> not_b) { return (a + not_b + Bits<1, false>(1)).bit(W); }

// The same of signed numbers that were offset to unsigned ones: the sign's opposite in front.
template <int W>
constexpr Bits<W, false> offset(Bits<W, true> x) { return wrap<Bits<W, false>>(x) ^ (Bits<W, false>(1) << (W - 1)); }

// Narrowing, by name.
template <class To, int W, bool S>
constexpr To wrap(Bits<W, S> x) { return To::of(x.raw()); }

template <class To, int W, bool S>
constexpr To saturate(Bits<W, S> x) {
  // x fits when all bits above To's are copies of the sign; comparing with the ends would take adders.
  constexpr int kept = To::is_signed ? To::width - 1 : To::width;
  if (x.negative()) {
    if (!To::is_signed) return To::min();
    if constexpr (W > kept) {
      if ((x >> kept) != Bits<W, S>::of(-1)) return To::min();
    }
  } else if constexpr (W > kept) {
    if ((x >> kept) != Bits<W, S>::of(0)) return To::max();
  }
  return To::of(x.raw());
}

}  // namespace steplock
