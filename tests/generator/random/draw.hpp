// What random programs are drawn from: dice that fall alike on every machine, and types.
//
// Texts are put together by cat({...}), whose parts are drawn from left to right; the operands of + may
// be drawn in any order.

#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace hlsgen::test {

class Draw {
 public:
  // Mixed once, so that neighbouring seeds do not walk behind each other.
  explicit Draw(std::uint64_t seed) : state_(seed) { state_ = next(); }

  std::uint64_t next() {  // splitmix64
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
    z = (z ^ z >> 27) * 0x94d049bb133111ebU;
    return z ^ z >> 31;
  }
  int below(int n) { return static_cast<int>(next() % static_cast<unsigned>(n)); }
  int between(int least, int most) { return least + below(most - least + 1); }
  bool chance(int percent) { return below(100) < percent; }

  template <class T>
  const T& of(const std::vector<T>& all) {
    return all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
  }
  std::string of(std::initializer_list<const char*> all) {
    return all.begin()[below(static_cast<int>(all.size()))];
  }

 private:
  std::uint64_t state_;
};

inline std::string cat(std::initializer_list<std::string> parts) {
  std::string all;
  for (const auto& part : parts) all += part;
  return all;
}

// UInt<W> and Int<W>; std::int16_t and its like; bool.
struct Type {
  enum class Kind : std::uint8_t { kBits, kPlain, kBool };
  Kind kind = Kind::kBits;
  int width = 1;
  bool is_signed = false;

  bool operator==(const Type&) const = default;
  std::string text() const {
    const std::string digits = std::to_string(width);
    if (kind == Kind::kBool) return "bool";
    if (kind == Kind::kPlain) return (is_signed ? "std::int" : "std::uint") + digits + "_t";
    return (is_signed ? "Int<" : "UInt<") + digits + ">";
  }
};

inline constexpr Type kBool{Type::Kind::kBool, 1, false};
inline constexpr Type kInteger{Type::Kind::kPlain, 32, true};
inline Type bits(int width, bool is_signed) { return {Type::Kind::kBits, width, is_signed}; }

// Widths at which storage, products or words change come as often as all others.
inline Type draw_bits(Draw& any) {
  static const std::vector<int> corners = {1, 2, 8, 9, 16, 17, 31, 32, 33, 48, 63, 64};
  const int width = any.chance(50) ? any.of(corners) : any.between(1, 40);
  const bool is_signed = any.chance(45);
  return bits(is_signed && width == 1 ? 2 : width, is_signed);
}

inline Type draw_type(Draw& any) {
  if (any.chance(10)) return kBool;
  if (any.chance(20)) return {Type::Kind::kPlain, 8 << any.below(4), any.chance(50)};
  return draw_bits(any);
}

}  // namespace hlsgen::test
