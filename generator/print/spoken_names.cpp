#include "generator/print/spoken_names.hpp"

#include <algorithm>
#include <array>

#include "generator/names.hpp"

namespace hlsgen {
namespace {

constexpr std::size_t kTerms = 3;
constexpr std::array<const char*, 13> kNumbers = {"zero", "one", "two",   "three", "four", "five",  "six",
                                                  "seven", "eight", "nine", "ten", "eleven", "twelve"};

bool starts_with(const std::string& text, const char* with) { return text.rfind(with, 0) == 0; }

// `_if_run`, of not_run `_unless_run`; and the other way about.
std::string if_so(const std::string& when) { return starts_with(when, "not_") ? "_unless_" + when.substr(4) : "_if_" + when; }
std::string if_not(const std::string& when) { return starts_with(when, "not_") ? "_if_" + when.substr(4) : "_unless_" + when; }

}  // namespace

std::string inverted(const std::string& name) {
  if (name.empty()) return {};
  return starts_with(name, "not_") ? name.substr(4) : "not_" + name;
}

bool SpokenNames::is_zero(NodeId id) const { return m_.nodes[id].op == Op::kConstant && m_.nodes[id].value.isZero(); }

std::string SpokenNames::enumerator(int enumeration, std::uint64_t value) const {
  if (enumeration < 0) return {};
  for (const auto& [name, v] : m_.enumerations[enumeration].values)
    if (v == value) return constant_name(name);
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
    if (n.op != Op::kEq || plan_.wire[id] || n.in[0] != m_.nodes[ids[0]].in[0]) return {};
    const std::string value = given_(n.in[0]), other = compared_with(n.in[1], n.in[0]);
    if (value.empty() || other.empty()) return {};
    all += all.empty() ? value + "_is_" + other : "_or_" + other;
  }
  return all;
}

// What a value is called within another's name.
std::string SpokenNames::term(NodeId id) const {
  const Node& n = m_.nodes[id];
  // What inverts something that is seen is called after that: a name of its own would be seen nowhere else.
  const bool seen = n.op == Op::kNot && (plan_.wire[n.in[0]] || m_.nodes[n.in[0]].in.empty()) && !given_(n.in[0]).empty();
  const bool inverts = seen && !plan_.wire[id];
  if (const std::string name = given_(id); !name.empty() && !inverts) return name;
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
  const auto only = [&](const std::string& value, bool set) { return value + (set ? if_so(when) : if_not(when)); };
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
    std::string one = term(id);
    if (one.empty() && m_.nodes[id].op == Op::kAnd && between == "_or_") one = joined(flat(id), "_and_");  // binds closer
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
        const std::vector<NodeId> ids = flat(n.in[0]);
        const std::string neither = joined(ids, "_nor_");
        if (neither.empty()) return {};
        std::string all;  // !(!run || !held) is run && held
        for (const NodeId i : ids) {
          const std::string one = term(i);
          if (!starts_with(one, "not_")) return "neither_" + neither;
          all += (all.empty() ? "" : "_and_") + inverted(one);
        }
        return all;
      }
      return term(id);
    }
    case Op::kSlice: return term(id);
    default: return compared(n);
  }
}

std::string SpokenNames::of(NodeId id) const {
  const std::string name = made(id);
  return name.size() > kLongestName ? "" : name;
}

std::string SpokenNames::role(NodeId id, NodeId reader) const {
  const Node& r = m_.nodes[reader];
  std::string role;
  if (r.op == Op::kMux && r.in[1] != r.in[2] && r.in[0] != id) {
    const std::string when = term(r.in[0]);
    if (!when.empty()) role = r.in[1] == id ? if_so(when) : if_not(when);
  } else if ((r.op == Op::kAnd || r.op == Op::kOr) && r.width == 1) {
    const std::string when = term(r.in[0] == id ? r.in[1] : r.in[0]);
    if (!when.empty()) role = r.op == Op::kAnd ? if_so(when) : if_not(when);
  }
  return role.size() > kLongestName / 2 ? "" : role;
}

std::string SpokenNames::selector(NodeId id) const {
  const Node& n = m_.nodes[id];
  if (n.op != Op::kMux) return {};
  NodeId decides = n.in[0];
  while (m_.nodes[decides].op == Op::kNot && given_(decides).empty()) decides = m_.nodes[decides].in[0];
  const Node& d = m_.nodes[decides];
  std::string name = given_(decides);
  if (name.empty() && !d.in.empty()) {
    const bool bit = d.op == Op::kSlice && d.width == 1 && sets_[d.in[0]] >= 0;
    if (bit) name = snake_case(m_.enumerations[sets_[d.in[0]]].name);
    else if (d.op == Op::kSlice || (d.in.size() == 2 && m_.nodes[d.in[1]].op == Op::kConstant)) name = given_(d.in[0]);
    else name = made(decides);
  }
  return name.size() > kLongestName ? "" : name;
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
