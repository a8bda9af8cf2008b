#include "generator/machine/program.hpp"

#include <algorithm>

namespace hlsgen::machine {
namespace {

const Number& least(const Number& a, const Number& b) { return a.slt(b) ? a : b; }
const Number& greatest(const Number& a, const Number& b) { return a.sgt(b) ? a : b; }

Range either(const Range& a, const Range& b) {
  return {least(a.low, b.low), greatest(a.high, b.high)};
}

Range product(const Range& a, const Range& b) {
  const Number corners[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  Range all{corners[0], corners[0]};
  for (const Number& corner : corners) all = either(all, {corner, corner});
  return all;
}

}  // namespace

Number number(std::int64_t value) {
  return Number(kNumberBits, static_cast<std::uint64_t>(value), /*isSigned=*/true);
}
Number power(unsigned exponent) { return Number::getOneBitSet(kNumberBits, exponent); }
unsigned bits_of(const Number& value) { return value.getSignificantBits(); }

Range Range::of(unsigned width, bool is_signed) {
  if (is_signed) return {-power(width - 1), power(width - 1) - 1};
  return {number(0), power(width) - 1};
}

ValueId Program::constant(const Number& value) {
  for (ValueId id = 0; id < values.size(); ++id)
    if (values[id].source == Source::kConstant && values[id].constant == value) return id;
  values.push_back({Source::kConstant, 0, value, {value, value}});
  return static_cast<ValueId>(values.size() - 1);
}

Range Program::second_range(const Instruction& i) const {
  if (i.has_product()) return product(values[i.c].range, values[i.d].range);
  if (!i.has_entry()) return i.b == kNothing ? Range{number(0), number(0)} : values[i.b].range;
  Range all{table[0], table[0]};
  for (const Number& entry : table) all = either(all, {entry, entry});
  return all;
}

Range Program::sum_range(const Instruction& i) const {
  const Range none{number(0), number(0)};
  const Range a = i.a == kNothing ? none : values[i.a].range;
  Range b = second_range(i);
  if (i.logic != Logic::kSum) {
    const bool is_signed = a.low.isNegative() || b.low.isNegative();
    unsigned width = std::max(a.bits(), b.bits());
    if (!is_signed) --width;
    return width == 0 ? none : Range::of(width, is_signed);
  }
  if (i.condition != kNothing) return either(a, i.negate ? Range{-b.high, -b.low} : b);
  if (i.negate) b = {-b.high - 1, -b.low - 1};
  const Number carry = number(i.carry ? 1 : 0);
  return {a.low + b.low + carry, a.high + b.high + carry};
}

void Program::measure() {
  const auto hold = [&](ValueId v) {
    if (v != kNothing) word = std::max(word, values[v].range.bits());
  };
  for (const ValueId v : next) hold(v);
  for (const ValueId v : outputs) hold(v);
  for (const Instruction& i : instructions) {
    for (const ValueId v : {i.a, i.b, i.c, i.d, i.entry, i.condition, i.result}) hold(v);
    sum = std::max({sum, sum_range(i).bits(), second_range(i).bits()});
  }
  for (const Register& r : sample->registers) word = std::max(word, r.leaf.width + 1);
  sum = std::max(sum, word);
}

ValueId Program::emit(Instruction i) {
  const auto [known, is_new] = known_.try_emplace(i.key(), kNothing);
  if (!is_new) return known->second;
  Range range = sum_range(i);
  range = {range.low.ashr(i.shift), range.high.ashr(i.shift)};
  if (i.format.is_flag()) {
    range = {number(0), number(1)};
  } else if (i.format.form != Form::kAll) {
    const Range fits = Range::of(i.format.width, i.format.is_signed);
    if (range.within(fits)) {
      i.format = {};
    } else if (i.format.form == Form::kWrap) {
      range = fits;
    } else {
      const auto clamped = [&](const Number& x) { return least(greatest(x, fits.low), fits.high); };
      range = {clamped(range.low), clamped(range.high)};
    }
  }
  i.result = known->second = static_cast<ValueId>(values.size());
  values.push_back({Source::kComputed, static_cast<unsigned>(instructions.size()), number(0), range});
  instructions.push_back(std::move(i));
  return instructions.back().result;
}

const Instruction* Program::maker(ValueId value) const {
  const Value& v = values[value];
  return v.source == Source::kComputed ? &instructions[v.index] : nullptr;
}
Instruction* Program::maker(ValueId value) {
  const Value& v = values[value];
  return v.source == Source::kComputed ? &instructions[v.index] : nullptr;
}

}  // namespace hlsgen::machine
