#include "generator/machine/integers.hpp"

#include <algorithm>

namespace hlsgen::machine {

ValueId Integers::cut(ValueId value, unsigned low, unsigned to, bool is_signed) {
  Instruction i;
  i.a = value;
  i.shift = low;
  const Range range = p_.values[value].range;
  const Range shifted{range.low.ashr(low), range.high.ashr(low)};
  if (!shifted.within(Range::of(to, is_signed))) i.format = {Form::kWrap, to, is_signed};
  if (i.is_plain()) return value;
  if (p_.values[value].source == Source::kConstant) {
    const Number x = p_.values[value].constant.ashr(low).trunc(to);
    return p_.constant(is_signed ? x.sext(kNumberBits) : x.zext(kNumberBits));
  }
  return p_.emit(i);
}

ValueId Integers::raised(ValueId value, unsigned by, unsigned to, bool is_signed) {
  if (by == 0) return value;
  if (p_.values[value].source == Source::kConstant) {
    const Number x = p_.values[value].constant.shl(by).trunc(to);
    return p_.constant(is_signed ? x.sext(kNumberBits) : x.zext(kNumberBits));
  }
  Instruction i;
  i.format = {Form::kWrap, to, is_signed};
  const unsigned most = p_.second_factor - 2;
  if (p_.values[value].range.bits() <= p_.factor && by > 1 && most > 0) {
    const unsigned now = std::min(by, most);
    i.c = value;
    i.d = p_.constant(power(now));
    return raised(p_.emit(i), by - now, to, is_signed);
  }
  i.a = i.b = value;
  return raised(p_.emit(i), by - 1, to, is_signed);
}

// The upper part has the sign.
ValueId Integers::times(ValueId x, ValueId y, Instruction i) {
  if (!fits(x, p_.factor) || !fits(y, p_.second_factor)) std::swap(x, y);
  if (fits(x, p_.factor) && fits(y, p_.second_factor)) {
    i.c = x;
    i.d = y;
    return p_.emit(i);
  }
  if (p_.values[x].range.bits() < p_.values[y].range.bits()) std::swap(x, y);
  const unsigned other = fits(y, std::min(p_.factor, p_.second_factor))
                             ? std::max(p_.factor, p_.second_factor)
                             : std::min(p_.factor, p_.second_factor);
  const unsigned low = other - 1;
  Instruction part;
  part.format = i.format;
  const ValueId lower = times(cut(x, 0, low, false), y, part);
  const ValueId upper = times(cut(x, low, kNumberBits / 2, true), y, part);
  i.a = lower;
  i.b = raised(upper, low, i.format.width, i.format.is_signed);
  return p_.emit(i);
}

ValueId Integers::opposite(ValueId bit, Instruction i) {
  i.a = bit;
  i.format = {Form::kZero, 1, false};
  return p_.emit(i);
}

ValueId Integers::both(const ValueId of[2], const bool falls[2], bool turned, Instruction i) {
  i.a = of[0];
  i.b = of[1];
  if (falls[0] != falls[1]) {  // x & ~y: y < x
    if (falls[1]) std::swap(i.a, i.b);
    i.negate = i.carry = true;
    i.format = {Form::kNegative, 1, false};
    i.invert = turned;
    return p_.emit(i);
  }
  if (falls[0] && !turned) {
    i.format = {Form::kZero, 1, false};
    return p_.emit(i);
  }
  i.carry = falls[0];
  i.shift = 1;
  const ValueId sum = p_.emit(i);
  return turned && !falls[0] ? opposite(sum, {}) : sum;
}

}  // namespace hlsgen::machine
