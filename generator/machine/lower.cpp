#include "generator/machine/lower.hpp"

#include <algorithm>
#include <array>

#include "generator/backend.hpp"
#include "generator/machine/clamps.hpp"
#include "generator/passes/known_bits.hpp"
#include "generator/passes/rebuild.hpp"

namespace hlsgen::machine {
namespace {

class Lowering {
 public:
  Lowering(const Module& sample, unsigned factor, unsigned second_factor)
      : m_(sample), known_(known_bits(sample)), clamps_(sample, known_), made_(sample.nodes.size()) {
    p_.sample = &sample;
    p_.factor = factor;
    p_.second_factor = second_factor;
    for (const Table& table : m_.tables) {
      bases_.push_back(static_cast<unsigned>(p_.table.size()));
      for (const auto& entry : table.entries) p_.table.push_back(entry.zext(kNumberBits));
    }
  }

  Program run() {
    for (const Register& r : m_.registers) p_.next.push_back(get(r.next, r.leaf.is_signed));
    for (const Output& o : m_.outputs) p_.outputs.push_back(either(o.value));
    return std::move(p_);
  }

 private:
  const Node& node(NodeId id) const { return m_.nodes[id]; }
  unsigned width(NodeId id) const { return node(id).width; }

  // The value as an integer of that sign.
  ValueId get(NodeId id, bool is_signed) {
    if (made_[id][is_signed] == kNothing) made_[id][is_signed] = find(id, is_signed);
    return made_[id][is_signed];
  }
  // As whichever is there.
  ValueId either(NodeId id) {
    if (made_[id][0] != kNothing) return made_[id][0];
    return get(id, width(id) > 1);
  }

  ValueId find(NodeId id, bool is_signed) {
    const Range fits = Range::of(width(id), is_signed);
    const ValueId other = made_[id][!is_signed];
    if (other != kNothing) return cut(other, 0, width(id), is_signed);
    const ValueId value = make(id, is_signed);
    const ValueId right = cut(value, 0, width(id), is_signed);
    if (right != value) made_[id][!is_signed] = value;
    return right;
  }

  // Bits from `low` on.
  ValueId cut(ValueId value, unsigned low, unsigned to, bool is_signed) {
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

  // The result of the operator in that width, as either integer if it has no sign of its own.
  ValueId make(NodeId id, bool is_signed) {
    const Node& n = node(id);
    if (const auto clamp = clamps_.find(id)) return clamped(*clamp);
    Instruction i;
    i.name = n.name;
    i.format = {Form::kWrap, n.width, is_signed};
    const bool is_bit = n.width == 1;
    switch (n.op) {
      case Op::kConstant:
        return p_.constant(is_signed ? n.value.sext(kNumberBits) : n.value.zext(kNumberBits));
      case Op::kInput:
        return source(Source::kInput, n, m_.inputs[n.index].is_signed);
      case Op::kRegister:
        return source(Source::kState, n, m_.registers[n.index].leaf.is_signed);
      case Op::kAdd:
      case Op::kSub:
        i.a = get(n.in[0], is_signed);
        i.b = get(n.in[1], is_signed);
        i.negate = i.carry = n.op == Op::kSub;
        return p_.emit(i);
      case Op::kMul:
        return multiply(n, i);
      case Op::kAnd: case Op::kOr: case Op::kXor:
        return logic(n, i, is_signed);
      case Op::kNot:
        i.b = get(n.in[0], is_signed);
        i.negate = true;
        if (is_bit) {
          i.a = p_.constant(number(1));
          i.b = get(n.in[0], false);
          i.carry = true;
        }
        return p_.emit(i);
      case Op::kShl:
        return shifted_up(n.in[0], amount(n), n, is_signed);
      case Op::kLshr:
        return amount(n) >= n.width ? p_.constant(number(0))
                                    : cut(get(n.in[0], false), amount(n), n.width, is_signed);
      case Op::kAshr:
        return cut(get(n.in[0], true), std::min(amount(n), n.width - 1), n.width, is_signed);
      case Op::kEq: case Op::kNe: case Op::kUlt: case Op::kUle: case Op::kSlt: case Op::kSle:
        return compare(n, i);
      case Op::kMux:
        return choose(n, i, is_signed);
      case Op::kSlice:
        return slice(n, is_signed);
      case Op::kConcat:
        return concat(n, is_signed);
      case Op::kZext:
        return get(n.in[0], false);
      case Op::kSext:
        return get(n.in[0], true);
      case Op::kTable:
        i.entry = get(n.in[0], false);
        if (bases_[n.index] != 0) {
          Instruction place;
          place.a = i.entry;
          place.b = p_.constant(number(bases_[n.index]));
          i.entry = p_.emit(place);
        }
        return p_.emit(i);
      case Op::kInstanceOutput:
        break;
    }
    throw NetlistError("module " + m_.name + ": a sample has no instances");
  }

  ValueId source(Source from, const Node& n, bool is_signed) {
    Value v;
    v.source = from;
    v.index = n.index;
    v.range = Range::of(n.width, is_signed);
    p_.word = std::max(p_.word, v.range.bits());
    p_.values.push_back(v);
    return static_cast<ValueId>(p_.values.size() - 1);
  }

  unsigned amount(const Node& n) const {
    return static_cast<unsigned>(node(n.in[1]).value.getLimitedValue(1U << 16));
  }

  ValueId clamped(const Clamp& clamp) {
    Instruction i;
    i.a = get(clamp.of, clamp.of_signed);
    i.shift = clamp.shift;
    i.format = {Form::kClamp, clamp.width, clamp.is_signed};
    return p_.emit(i);
  }

  bool fits(NodeId id, unsigned bits) const { return known_[id].signed_width() <= bits; }

  ValueId multiply(const Node& n, Instruction i) {
    i.c = get(n.in[0], true);
    i.d = get(n.in[1], true);
    const bool stand = fits(n.in[0], p_.factor) && fits(n.in[1], p_.second_factor);
    if (!stand) std::swap(i.c, i.d);
    return p_.emit(i);
  }

  ValueId logic(const Node& n, Instruction i, bool is_signed) {
    const bool is_bit = n.width == 1;
    i.a = get(n.in[0], is_signed && !is_bit);
    i.b = get(n.in[1], is_signed && !is_bit);
    if (is_bit) {
      i.carry = n.op == Op::kOr;
      i.shift = n.op == Op::kXor ? 0 : 1;
      if (n.op == Op::kXor) i.format = {Form::kWrap, 1, false};
      return p_.emit(i);
    }
    if (n.op == Op::kAnd)
      for (unsigned k = 0; k < 2; ++k) {
        const Node& mask = node(n.in[1 - k]);
        if (mask.op == Op::kConstant && mask.value.isMask())
          return cut(get(n.in[k], false), 0, mask.value.countTrailingOnes(), false);
      }
    i.logic = n.op == Op::kAnd ? Logic::kAnd : n.op == Op::kOr ? Logic::kOr : Logic::kXor;
    return p_.emit(i);
  }

  ValueId shifted_up(NodeId from, unsigned by, const Node& n, bool is_signed) {
    if (by >= n.width) return p_.constant(number(0));
    return raised(get(from, is_signed), by, n.width, is_signed);
  }

  // 2^by times as much, modulo 2^to.
  ValueId raised(ValueId value, unsigned by, unsigned to, bool is_signed) {
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

  ValueId compare(const Node& n, Instruction i) {
    const bool same = n.op == Op::kEq || n.op == Op::kNe;
    bool is_signed = n.op == Op::kSlt || n.op == Op::kSle;
    if (same) is_signed = made_[n.in[0]][0] == kNothing && width(n.in[0]) > 1;
    i.a = get(n.in[0], is_signed);
    i.b = get(n.in[1], is_signed);
    i.invert = n.op == Op::kNe || n.op == Op::kUle || n.op == Op::kSle;
    if (i.invert && !same) std::swap(i.a, i.b);  // a <= b is not b < a
    i.negate = i.carry = true;
    i.format = {same ? Form::kZero : Form::kNegative, 1, false};
    return p_.emit(i);
  }

  ValueId choose(const Node& n, Instruction i, bool is_signed) {
    NodeId condition = n.in[0], yes = n.in[1], no = n.in[2];
    while (node(condition).op == Op::kNot) {
      condition = node(condition).in[0];
      std::swap(yes, no);
    }
    i.a = get(yes, is_signed);
    i.b = get(no, is_signed);
    i.condition = get(condition, false);
    return p_.emit(i);
  }

  ValueId slice(const Node& n, bool is_signed) {
    const NodeId from = n.in[0];
    const bool is_top = n.low + n.width == width(from);
    const ValueId value = is_top ? get(from, is_signed) : either(from);
    return cut(value, n.low, n.width, is_signed);
  }

  ValueId concat(const Node& n, bool is_signed) {
    ValueId sum = get(n.in[0], is_signed);
    unsigned so_far = width(n.in[0]);
    for (std::size_t k = 1; k < n.in.size(); ++k) {
      const unsigned more = width(n.in[k]);
      so_far += more;
      const ValueId high = raised(sum, more, so_far, is_signed);
      const ValueId low = get(n.in[k], false);
      const bool adds = !(p_.values[low].source == Source::kConstant && p_.values[low].constant == 0);
      Instruction i;
      i.a = low;
      i.b = high;
      sum = adds ? p_.emit(i) : high;
    }
    return sum;
  }

  struct Both : std::array<ValueId, 2> {
    Both() : std::array<ValueId, 2>{kNothing, kNothing} {}
  };

  const Module& m_;
  std::vector<Known> known_;
  Clamps clamps_;
  Program p_;
  std::vector<unsigned> bases_;  // of the tables in the one
  std::vector<Both> made_;       // per node: without and with a sign
};

}  // namespace

void expand_shifts(Module& sample) {
  rewrite(sample, [](Rebuild& b, const Node& n) -> NodeId {
    const bool shifts = n.op == Op::kShl || n.op == Op::kLshr || n.op == Op::kAshr;
    if (!shifts || b.constant(n.in[1]) != nullptr) return kNone;
    const auto by = [&](NodeId value, unsigned amount) {
      Node shift = n;
      shift.in = {value, b.value(llvm::APInt(32, amount))};
      return b.add(shift);
    };
    NodeId value = n.in[0];
    NodeId beyond = kNone;
    const unsigned bits = b.width(n.in[1]);
    for (unsigned k = 0; k < bits; ++k) {
      const NodeId bit = b.slice(n.in[1], k, 1);
      if (k < 16 && (1U << k) < n.width) {
        value = b.mux(bit, by(value, 1U << k), value);
      } else {
        beyond = beyond == kNone ? bit : b.binary(Op::kOr, beyond, bit);
      }
    }
    return beyond == kNone ? value : b.mux(beyond, by(n.in[0], n.width), value);
  });
}

Program lower(const Module& sample, unsigned factor, unsigned second_factor) {
  return Lowering(sample, factor, second_factor).run();
}

}  // namespace hlsgen::machine
