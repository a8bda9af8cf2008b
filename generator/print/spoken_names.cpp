#include "generator/print/spoken_names.hpp"

#include <algorithm>
#include <array>

#include "generator/names.hpp"

namespace hlsgen {
namespace {

constexpr std::size_t kLongest = 34;  // characters of a name; beyond, the expression says more
constexpr std::size_t kTerms = 3;
constexpr std::array<const char*, 13> kNumbers = {"zero", "one", "two",   "three", "four", "five",  "six",
                                                  "seven", "eight", "nine", "ten", "eleven", "twelve"};

bool starts_with(const std::string& text, const char* with) { return text.rfind(with, 0) == 0; }

}  // namespace

std::string inverted(const std::string& name) {
  if (name.empty()) return {};
  return starts_with(name, "not_") ? name.substr(4) : "not_" + name;
}

bool SpokenNames::is_zero(NodeId id) const { return m_.nodes[id].op == Op::kConstant && m_.nodes[id].value.isZero(); }

std::string SpokenNames::enumerator(int enumeration, std::uint64_t value) const {
  if (enumeration < 0) return {};
  for (const auto& [name, v] : m_.enumerations[enumeration].values)
    if (v == value) return snake_case(name.size() > 1 && name[0] == 'k' ? name.substr(1) : name);
  return {};
}

std::string SpokenNames::number(NodeId id) const {
  const Node& n = m_.nodes[id];
  return n.op == Op::kConstant && n.value.ult(kNumbers.size()) ? kNumbers[n.value.getZExtValue()] : "";
}

// What stands beside a value in a comparison: an enumerator where it has some.
std::string SpokenNames::compared_with(NodeId id, NodeId value) const {
  const Node& n = m_.nodes[id];
  if (n.op != Op::kConstant) return given_(id);
  if (plan_.enumeration[value] >= 0 && n.value.getActiveBits() <= 32) return enumerator(plan_.enumeration[value], n.value.getZExtValue());
  return number(id);
}

// One value that is asked whether it is this or that: "state_is_idle_or_fault".
std::string SpokenNames::one_of(const std::vector<NodeId>& ids) const {
  if (ids.size() < 2 || ids.size() > kTerms) return {};
  std::string all;
  for (const NodeId id : ids) {
    const Node& n = m_.nodes[id];
    if (n.op != Op::kEq || !given_(id).empty() || n.in[0] != m_.nodes[ids[0]].in[0]) return {};
    const std::string value = given_(n.in[0]), other = compared_with(n.in[1], n.in[0]);
    if (value.empty() || other.empty()) return {};
    all += all.empty() ? value + "_is_" + other : "_or_" + other;
  }
  return all;
}

// What a value is called within another's name.
std::string SpokenNames::term(NodeId id) const {
  if (const std::string name = given_(id); !name.empty()) return name;
  const Node& n = m_.nodes[id];
  switch (n.op) {
    case Op::kNot: return inverted(term(n.in[0]));
    case Op::kZext: case Op::kSext: return term(n.in[0]);
    case Op::kConcat:
      return std::all_of(n.in.begin(), n.in.end() - 1, [this](NodeId i) { return is_zero(i); }) ? term(n.in.back()) : "";
    case Op::kSlice: {
      if (n.width != 1 || sets_[n.in[0]] < 0) return {};
      const std::string bit = enumerator(sets_[n.in[0]], n.low);
      return bit.empty() ? "" : "in_" + bit;
    }
    default: return compared(n);
  }
}

std::string SpokenNames::compared(const Node& n) const {
  const char* words = n.op == Op::kEq ? "_is_" : n.op == Op::kNe ? "_is_not_" : n.op == Op::kUlt || n.op == Op::kSlt ? "_below_"
                      : n.op == Op::kUle || n.op == Op::kSle ? "_at_most_" : nullptr;
  if (words == nullptr) return {};
  std::string left = given_(n.in[0]), right = given_(n.in[1]);
  if (left.empty() && !right.empty()) {  // a number first: the other way about
    left = compared_with(n.in[0], n.in[1]);
    if (left.empty()) return {};
    const bool order = n.op == Op::kUlt || n.op == Op::kSlt || n.op == Op::kUle || n.op == Op::kSle;
    if (order) words = n.op == Op::kUlt || n.op == Op::kSlt ? "_above_" : "_at_least_";
    return right + words + left;
  }
  if (!left.empty() && right.empty()) right = compared_with(n.in[1], n.in[0]);
  return left.empty() || right.empty() ? "" : left + words + right;
}

std::string SpokenNames::added(const Node& n) const {
  const std::string left = term(n.in[0]);
  if (left.empty()) return {};
  const char* words = n.op == Op::kAdd ? "_plus_" : n.op == Op::kSub ? "_minus_" : "_times_";
  std::string right = term(n.in[1]);
  const Node& second = m_.nodes[n.in[1]];
  if (n.op == Op::kAdd && second.op == Op::kConstant && second.value.isNegative() && (-second.value).ult(kNumbers.size())) {
    words = "_minus_";
    right = kNumbers[(-second.value).getZExtValue()];
  } else if (right.empty()) {
    right = number(n.in[1]);
  }
  return right.empty() ? "" : left + words + right;
}

std::string SpokenNames::chosen(const Node& n) const {
  const std::string when = term(n.in[0]);
  if (when.empty()) return {};
  const std::string then = term(n.in[1]), otherwise = term(n.in[2]);
  const auto only = [&](const std::string& value, bool set) {
    const bool inverse = starts_with(when, "not_");
    return value + (set != inverse ? "_if_" : "_unless_") + (inverse ? when.substr(4) : when);
  };
  if (!then.empty() && (!otherwise.empty() || is_zero(n.in[2]))) return only(then, true);
  if (!otherwise.empty() && m_.nodes[n.in[1]].op == Op::kConstant) return only(otherwise, false);
  return {};
}

// Operands of one operator, through those of its kind that are no wires.
std::vector<NodeId> SpokenNames::flat(NodeId id) const {
  std::vector<NodeId> all;
  for (const NodeId operand : m_.nodes[id].in) {
    const bool same = m_.nodes[operand].op == m_.nodes[id].op && !plan_.wire[operand] && given_(operand).empty();
    const std::vector<NodeId> parts = same ? flat(operand) : std::vector<NodeId>{operand};
    all.insert(all.end(), parts.begin(), parts.end());
  }
  return all;
}

std::string SpokenNames::joined(const std::vector<NodeId>& ids, const std::string& between) const {
  if (ids.size() > kTerms) return {};
  std::string all;
  for (const NodeId id : ids) {
    const std::string one = term(id);
    if (one.empty()) return {};
    all += (all.empty() ? "" : between) + one;
  }
  return all;
}

std::string SpokenNames::made(NodeId id) const {
  const Node& n = m_.nodes[id];
  switch (n.op) {
    case Op::kAnd: return joined(flat(id), "_and_");
    case Op::kOr: {
      const std::string one = one_of(flat(id));
      return one.empty() ? joined(flat(id), "_or_") : one;
    }
    case Op::kXor: return joined(flat(id), "_xor_");
    case Op::kAdd: case Op::kSub: case Op::kMul: return added(n);
    case Op::kMux: return chosen(n);
    case Op::kNot: {
      const Node& inner = m_.nodes[n.in[0]];
      if (inner.op == Op::kOr && !plan_.wire[n.in[0]]) {
        const std::string neither = joined(flat(n.in[0]), "_nor_");
        return neither.empty() ? "" : "neither_" + neither;
      }
      return term(id);
    }
    case Op::kSlice: return term(id);
    default: return compared(n);
  }
}

std::string SpokenNames::of(NodeId id) const {
  const std::string name = made(id);
  return name.size() > kLongest ? "" : name;
}

std::string SpokenNames::member(NodeId id, int set) const {
  const Node& n = m_.nodes[id];
  if (n.op == Op::kConstant) return n.value.isPowerOf2() ? enumerator(set, n.value.logBase2()) : "";
  if (n.op != Op::kMux) return {};
  const std::string then = member(n.in[1], set), otherwise = member(n.in[2], set);
  if (is_zero(n.in[1])) return otherwise;
  return is_zero(n.in[2]) || then == otherwise ? then : "";
}

}  // namespace hlsgen
