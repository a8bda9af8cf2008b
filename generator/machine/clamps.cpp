#include "generator/machine/clamps.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "generator/passes/evaluate.hpp"
#include "generator/passes/known_bits.hpp"

namespace hlsgen::machine {
namespace {

constexpr std::size_t kMostChoices = 16;

struct Less {
  bool operator()(const Number& a, const Number& b) const { return a.slt(b); }
};

// One node as a choice between ends and bits of a number.
class Candidate {
 public:
  Candidate(const Module& m, const std::vector<Known>& known, const Clamps::RangeOf& range)
      : m_(m), known_(known), range_(range) {}

  std::optional<Clamp> look(NodeId choice) {
    if (!follow(choice) || bits_ == kNone) return std::nullopt;
    number_ = bits_;
    const bool extends = node(bits_).op == Op::kZext || node(bits_).op == Op::kSext;
    if (extends && node(node(bits_).in[0]).op == Op::kSlice) {
      number_ = node(bits_).in[0];
      shown_ = Range::of(node(number_).width, node(bits_).op == Op::kSext);
    }
    if (node(number_).op == Op::kSlice) {
      shift_ = node(number_).low;
      number_ = node(number_).in[0];
    }
    base_ = number_;
    while (step_down(base_, {})) {
    }
    for (const NodeId condition : conditions_)
      if (!divide(condition)) return std::nullopt;

    const unsigned width = node(choice).width;
    std::set<unsigned> widths{width};
    for (const NodeId end : ends_)
      if (node(end).value.isMask()) widths.insert(node(end).value.countTrailingOnes());
    for (const unsigned w : widths) {
      if (w + 1 <= width && agrees(choice, {number_, true, shift_, w + 1, true})) return found_;
      if (agrees(choice, {number_, true, shift_, w, true})) return found_;
      if (agrees(choice, {number_, true, shift_, w, false})) return found_;
    }
    return std::nullopt;
  }

 private:
  const Node& node(NodeId id) const { return m_.nodes[id]; }

  bool follow(NodeId id) {
    const Node& n = node(id);
    if (n.op == Op::kMux) {
      if (conditions_.size() == kMostChoices) return false;
      conditions_.push_back(n.in[0]);
      return follow(n.in[1]) && follow(n.in[2]);
    }
    if (n.op == Op::kConstant) {
      ends_.insert(id);
      return true;
    }
    if (bits_ != kNone && bits_ != id) return false;
    bits_ = id;
    return true;
  }

  bool keeps_in(NodeId id, const Number& constant) const {  // its sum cannot wrap
    const unsigned width = node(id).width;
    for (const NodeId in : node(id).in)
      if (node(in).op != Op::kConstant && known_[in].signed_width() >= width) return false;
    return bits_of(constant) < width;
  }

  // Through one node that only rises or only falls with the number below it.  `at` are the first of
  // those integers from which on something else holds, and become the same of the number below.
  bool step_down(NodeId& id, std::vector<Number*> at) const {
    const Node& n = node(id);
    if (n.op == Op::kSext) {
      id = n.in[0];
      return true;
    }
    if (n.op == Op::kSlice && n.low + n.width == node(n.in[0]).width) {
      for (Number* x : at) *x = x->shl(n.low);
      id = n.in[0];
      return true;
    }
    if (n.op != Op::kAdd && n.op != Op::kSub && n.op != Op::kMul) return false;
    for (unsigned k = 0; k < 2; ++k) {
      if (node(n.in[k]).op != Op::kConstant) continue;
      const Number constant = node(n.in[k]).value.sext(kNumberBits);
      const NodeId other = n.in[1 - k];
      if (n.op == Op::kMul) {
        const bool wraps = known_[other].signed_width() + bits_of(constant) > n.width;
        if (wraps || !constant.isStrictlyPositive()) return false;
        for (Number* x : at)  // rounded up
          *x = llvm::APIntOps::RoundingSDiv(*x, constant, llvm::APInt::Rounding::UP);
      } else {
        if (!keeps_in(id, constant)) return false;
        const bool falls = n.op == Op::kSub && k == 0;
        for (Number* x : at)
          *x = falls ? constant - *x + 1 : n.op == Op::kSub ? *x + constant : *x - constant;
      }
      id = other;
      return true;
    }
    return false;
  }

  // Where the condition may change, as values of the base.
  bool divide(NodeId condition) {
    const Node& n = node(condition);
    switch (n.op) {
      case Op::kConstant:
        return true;
      case Op::kAnd: case Op::kOr: case Op::kXor: case Op::kNot: case Op::kMux:
        return std::all_of(n.in.begin(), n.in.end(), [&](NodeId in) { return divide(in); });
      case Op::kSlice:
        return n.low + 1 == node(n.in[0]).width && divide_at(n.in[0], {number(0)});
      case Op::kEq: case Op::kNe: case Op::kSlt: case Op::kSle: case Op::kUlt: case Op::kUle: {
        const bool left = node(n.in[0]).op == Op::kConstant;
        const Node& constant = node(n.in[left ? 0 : 1]);
        if (constant.op != Op::kConstant) return false;
        const NodeId number = n.in[left ? 1 : 0];
        if (is_extended(number) && n.op != Op::kSlt && n.op != Op::kSle) {
          const Number end = constant.value.zext(kNumberBits);
          starts_.insert({end, end + 1});
          return true;
        }
        const Number end = constant.value.sext(kNumberBits);
        return divide_at(number, {end, end + 1, machine::number(0)});
      }
      default:
        return false;
    }
  }

  // The base is this with zeros on top.
  bool is_extended(NodeId id) const {
    return node(base_).op == Op::kZext && node(base_).in[0] == id;
  }
  std::map<NodeId, llvm::APInt> values_at(const Number& base) const {
    std::map<NodeId, llvm::APInt> values{{base_, base.trunc(node(base_).width)}};
    if (node(base_).op == Op::kZext)
      values.emplace(node(base_).in[0], base.trunc(node(node(base_).in[0]).width));
    return values;
  }

  bool divide_at(NodeId id, std::vector<Number> at) {
    std::vector<Number*> places;
    for (Number& x : at) places.push_back(&x);
    while (id != base_ && step_down(id, places)) {
    }
    if (id != base_) return false;
    starts_.insert(at.begin(), at.end());
    return true;
  }

  llvm::APInt value(NodeId id, std::map<NodeId, llvm::APInt>& values) const {
    const auto known = values.find(id);
    if (known != values.end()) return known->second;
    const Node& n = node(id);
    llvm::APInt result = n.value;
    if (n.op != Op::kConstant) {
      std::vector<llvm::APInt> in;
      for (const NodeId operand : n.in) in.push_back(value(operand, values));
      result = evaluate(m_, n, in);
    }
    values.emplace(id, result);
    return result;
  }

  NodeId chosen(NodeId choice, std::map<NodeId, llvm::APInt>& values) const {
    while (node(choice).op == Op::kMux)
      choice = node(choice).in[value(node(choice).in[0], values).isZero() ? 2 : 1];
    return choice;
  }

  bool agrees(NodeId choice, const Clamp& clamp) {
    const Range all = range_(base_), fits = Range::of(clamp.width, clamp.is_signed);
    if (clamp.width > node(choice).width) return false;
    std::set<Number, Less> starts = starts_;
    starts.insert(all.low);
    for (auto start = starts.begin(); start != starts.end(); ++start) {
      if (start->slt(all.low) || start->sgt(all.high)) continue;
      const auto after = std::next(start);
      const Number last = after == starts.end() || after->sgt(all.high) ? all.high : *after - 1;
      auto values = values_at(*start), values_at_last = values_at(last);
      Number low = value(number_, values).sext(kNumberBits).ashr(clamp.shift);
      Number high = value(number_, values_at_last).sext(kNumberBits).ashr(clamp.shift);
      if (low.sgt(high)) std::swap(low, high);
      const NodeId leaf = chosen(choice, values);
      if (node(leaf).op == Op::kConstant) {
        const auto& end = node(leaf).value;
        const Number is = clamp.is_signed ? end.sext(kNumberBits) : end.zext(kNumberBits);
        const bool below = high.sle(fits.low) && is == fits.low;
        const bool above = low.sge(fits.high) && is == fits.high;
        if (!below && !above) return false;
      } else if (low.slt(fits.low) || high.sgt(fits.high)) {
        return false;
      } else if (shown_ && !Range{low, high}.within(*shown_)) {
        return false;
      }
    }
    found_ = clamp;
    return true;
  }

  const Module& m_;
  const std::vector<Known>& known_;
  const Clamps::RangeOf& range_;
  std::vector<NodeId> conditions_;
  std::set<NodeId> ends_;
  NodeId bits_ = kNone, number_ = kNone, base_ = kNone;
  unsigned shift_ = 0;
  std::optional<Range> shown_;  // what the bits can say, extended
  std::set<Number, Less> starts_;  // of stretches, in the base
  std::optional<Clamp> found_;
};

}  // namespace

std::optional<Clamp> Clamps::find(NodeId choice) const {
  if (m_.nodes[choice].op != Op::kMux || m_.nodes[choice].width == 1) return std::nullopt;
  return Candidate(m_, known_, range_).look(choice);
}

}  // namespace hlsgen::machine
