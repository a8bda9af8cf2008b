#include "generator/machine/lower.hpp"

#include <algorithm>
#include <array>

#include "generator/backend.hpp"
#include "generator/machine/clamps.hpp"
#include "generator/machine/integers.hpp"
#include "generator/passes/known_bits.hpp"

namespace hlsgen::machine {
namespace {

class Lowering : private Integers {
 public:
  Lowering(const Module& sample, unsigned factor, unsigned second_factor)
      : m_(sample),
        known_(known_bits(sample)),
        clamps_(sample, known_, [this](NodeId id) { return p_.values[get(id, true)].range; }),
        made_(sample.nodes.size()) {
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
  // As whichever is there, or costs nothing.
  ValueId either(NodeId id) {
    for (const bool is_signed : {false, true})
      if (made_[id][is_signed] != kNothing) return made_[id][is_signed];
    const Node& n = node(id);
    const bool computes = n.op == Op::kAdd || n.op == Op::kMul || n.op == Op::kMux;
    const auto rises = [&](NodeId in) { return width(in) == 1 || known_[in].bits.isNonNegative(); };
    const bool is_signed = computes ? !std::all_of(n.in.begin(), n.in.end(), rises) : width(id) > 1;
    return get(id, is_signed);
  }
  // An integer that is the node's modulo its width, for what is cut to no more bits.
  ValueId loose(NodeId id) {
    const Node& n = node(id);
    const bool is_there = made_[id][0] != kNothing || made_[id][1] != kNothing;
    if (is_there || n.op != Op::kSlice) return either(id);
    const ValueId whole = loose(n.in[0]);
    const bool is_near = p_.values[whole].range.bits() <= n.low + n.width + kSpare;
    return is_near ? cut(whole, n.low, kNumberBits / 2, true) : either(id);
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
        i.a = loose(n.in[0]);
        i.b = loose(n.in[1]);
        i.negate = i.carry = n.op == Op::kSub;
        return p_.emit(i);
      case Op::kMul:
        return multiply(n, i);
      case Op::kAnd: case Op::kOr: case Op::kXor:
        return is_bit ? bit(id, false, i) : logic(n, i, is_signed);
      case Op::kNot:
        if (is_bit) return bit(n.in[0], true, i);
        i.b = get(n.in[0], is_signed);
        i.negate = true;
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
        return choose(n, i);
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

  ValueId multiply(const Node& n, const Instruction& i) {
    return times(get(n.in[0], true), get(n.in[1], true), i);
  }
  // A bit or its opposite; the opposites of what it is made of cost nothing.
  ValueId bit(NodeId id, bool inverted, Instruction i) {
    const Node& n = node(id);
    if (n.op == Op::kNot) return bit(n.in[0], !inverted, i);
    if (n.op == Op::kXor) {
      i.a = get(n.in[0], false);
      i.b = get(n.in[1], false);
      i.carry = inverted;
      i.format = {Form::kWrap, 1, false};
      return p_.emit(i);
    }
    const bool is_or = n.op == Op::kOr;
    const bool shares = inverted && made_[id][0] != kNothing;
    if ((is_or || n.op == Op::kAnd) && !shares) return pair(n, inverted, i);
    const ValueId x = get(id, false);
    return inverted ? opposite(x, i) : x;
  }
  // x & y and its like; x | y is the opposite of ~x & ~y.
  ValueId pair(const Node& n, bool inverted, Instruction i) {
    const bool is_or = n.op == Op::kOr;
    const bool turned = inverted != is_or;
    bool falls[2] = {is_or, is_or};
    ValueId of[2];
    for (unsigned k = 0; k < 2; ++k) {
      NodeId in = n.in[k];
      for (; node(in).op == Op::kNot; in = node(in).in[0]) falls[k] = !falls[k];
      of[k] = get(in, false);
    }
    return both(of, falls, turned, i);
  }

  ValueId logic(const Node& n, Instruction i, bool is_signed) {
    for (unsigned k = 0; k < 2; ++k) {
      const NodeId value = n.in[1 - k];
      const Node& other = node(n.in[k]);
      if (n.op == Op::kAnd && other.op == Op::kConstant && other.value.isMask())
        return cut(get(value, false), 0, other.value.countTrailingOnes(), false);
      if (n.op != Op::kXor || other.op != Op::kSext || width(other.in[0]) != 1) continue;
      Instruction turned;  // every bit, or none
      turned.format = i.format;
      turned.negate = true;
      turned.b = i.b = loose(value);
      i.a = p_.emit(turned);
      i.condition = get(other.in[0], false);
      return p_.emit(i);
    }
    i.a = get(n.in[0], is_signed);
    i.b = get(n.in[1], is_signed);
    const auto turns_sign = [&](NodeId id) {
      return node(id).op == Op::kConstant && node(id).value.isSignMask();
    };
    if (n.op == Op::kXor && (turns_sign(n.in[0]) || turns_sign(n.in[1]))) return p_.emit(i);
    i.logic = n.op == Op::kAnd ? Logic::kAnd : n.op == Op::kOr ? Logic::kOr : Logic::kXor;
    return p_.emit(i);
  }

  ValueId shifted_up(NodeId from, unsigned by, const Node& n, bool is_signed) {
    if (by >= n.width) return p_.constant(number(0));
    return raised(get(from, is_signed), by, n.width, is_signed);
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

  bool is_opposite(NodeId id) const {  // 0 - x
    return node(id).op == Op::kSub && node(node(id).in[0]).op == Op::kConstant &&
           node(node(id).in[0]).value.isZero() && node(node(id).in[1]).op != Op::kConstant;
  }

  ValueId choose(const Node& n, Instruction i) {
    NodeId condition = n.in[0], yes = n.in[1], no = n.in[2];
    while (node(condition).op == Op::kNot) {
      condition = node(condition).in[0];
      std::swap(yes, no);
    }
    if (is_opposite(yes)) {
      std::swap(yes, no);
      i.unless = true;
    }
    i.negate = i.carry = is_opposite(no);
    i.a = loose(yes);
    i.b = loose(i.negate ? node(no).in[1] : no);
    i.condition = get(condition, false);
    return p_.emit(i);
  }

  // The same modulo 2^bits: extensions do not matter.
  ValueId lower_bits(NodeId id, unsigned bits) {
    const bool extends = node(id).op == Op::kZext || node(id).op == Op::kSext;
    return loose(extends && width(node(id).in[0]) >= bits ? node(id).in[0] : id);
  }

  ValueId slice(const Node& n, bool is_signed) {
    NodeId from = n.in[0];
    unsigned low = n.low;
    while ((node(from).op == Op::kLshr || node(from).op == Op::kAshr) &&
           node(node(from).in[1]).op == Op::kConstant &&
           low + n.width + amount(node(from)) <= width(from)) {
      low += amount(node(from));
      from = node(from).in[0];
    }
    const unsigned bits = low + n.width;
    const bool is_top = bits == width(from);
    ValueId value = kNothing;
    if (node(from).op == Op::kAdd && !is_top) {
      Instruction sum;
      sum.a = lower_bits(node(from).in[0], bits);
      sum.b = lower_bits(node(from).in[1], bits);
      value = p_.emit(sum);
    } else {
      value = is_top ? get(from, is_signed) : either(from);
    }
    return cut(value, low, n.width, is_signed);
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

  static constexpr unsigned kSpare = 8;  // bits that a sum may be wider for want of a cut

  const Module& m_;
  std::vector<Known> known_;
  Clamps clamps_;
  std::vector<unsigned> bases_;  // of the tables in the one
  std::vector<Both> made_;       // per node: without and with a sign
};

}  // namespace

Program lower(const Module& sample, unsigned factor, unsigned second_factor) {
  return Lowering(sample, factor, second_factor).run();
}

}  // namespace hlsgen::machine
