#include "generator/print/restrict.hpp"

#include <llvm/ADT/StringExtras.h>

#include "generator/passes/evaluate.hpp"
#include "generator/print/plan.hpp"

namespace hlsgen {
namespace {

bool is_source(Op op) {
  return op == Op::kInput || op == Op::kRegister || op == Op::kInstanceOutput;
}
bool is_logic(const Node& n) {
  return n.width == 1 &&
         (n.op == Op::kNot || n.op == Op::kAnd || n.op == Op::kOr || n.op == Op::kXor);
}

bool is_wiring(Op op) {
  return op == Op::kSlice || op == Op::kConcat || op == Op::kZext || op == Op::kSext;
}

}  // namespace

Restrictor::Restrictor(Module& module) : m_(module), uses_(count_uses(module)) {
  for (NodeId id = 0; id < m_.nodes.size(); ++id) {
    const Node& n = node(id);
    domains_.push_back(find_domain(n));
    if (is_logic(n) || n.op == Op::kMux) made_.emplace(Key{n.op, n.width, n.in}, id);
    if (is_bit(id, false)) bits_[0] = id;
    if (is_bit(id, true)) bits_[1] = id;
  }
}

const Domain* Restrictor::domain(NodeId id) const {
  return domains_[id].selector == kNone ? nullptr : &domains_[id];
}

Domain Restrictor::find_domain(const Node& n) const {
  const auto all_values = [](unsigned width) {
    std::vector<llvm::APInt> values;
    for (unsigned v = 0; v < (1u << width); ++v) values.emplace_back(width, v);
    return values;
  };
  if (n.op == Op::kConstant || n.op == Op::kTable) return {};
  if (is_source(n.op)) {
    if (n.width < 2 || n.width > kWidestSelector) return {};
    return {static_cast<NodeId>(&n - m_.nodes.data()), all_values(n.width)};
  }
  // A value that is compared with constants selects, whatever it is made of.
  const bool compares = n.op == Op::kEq || n.op == Op::kNe;
  if (compares && node(n.in[1]).op == Op::kConstant && domain(n.in[0]) == nullptr) {
    const unsigned width = node(n.in[0]).width;
    if (width < 2 || width > kWidestSelector) return {};
    Domain d{n.in[0], {}};
    for (const llvm::APInt& v : all_values(width))
      d.values.push_back(evaluate(m_, n, {v, node(n.in[1]).value}));
    return d;
  }
  Domain d;
  for (const NodeId operand : n.in) {
    if (node(operand).op == Op::kConstant) continue;
    const Domain* o = domain(operand);
    if (o == nullptr || (d.selector != kNone && d.selector != o->selector)) return {};
    d.selector = o->selector;
  }
  if (d.selector == kNone) return {};
  for (std::size_t v = 0; v < (std::size_t{1} << node(d.selector).width); ++v) {
    std::vector<llvm::APInt> in;
    for (const NodeId operand : n.in)
      in.push_back(node(operand).op == Op::kConstant ? node(operand).value
                                                     : domain(operand)->values[v]);
    d.values.push_back(evaluate(m_, n, in));
  }
  return d;
}

llvm::APInt Restrictor::range(const Facts& facts, NodeId selector) const {
  const auto found = facts.ranges.find(selector);
  return found != facts.ranges.end() ? found->second
                                     : llvm::APInt::getAllOnes(1u << node(selector).width);
}

void Restrictor::learn(Facts& facts, NodeId condition, bool value) const {
  const Node& n = node(condition);
  facts.bits[condition] = value;
  if (const Domain* d = domain(condition)) {
    llvm::APInt range = this->range(facts, d->selector);
    for (unsigned v = 0; v < range.getBitWidth(); ++v)
      if (d->values[v].getBoolValue() != value) range.clearBit(v);
    facts.ranges[d->selector] = range;
  }
  if (n.op == Op::kNot) learn(facts, n.in[0], !value);
  if ((n.op == Op::kAnd && value) || (n.op == Op::kOr && !value))
    for (const NodeId operand : n.in) learn(facts, operand, value);
}

std::optional<bool> Restrictor::known(const Facts& facts, NodeId id) const {
  if (is_bit(id, false)) return false;
  if (is_bit(id, true)) return true;
  const auto found = facts.bits.find(id);
  if (found != facts.bits.end()) return found->second;
  const Domain* d = domain(id);
  if (d == nullptr || facts.ranges.count(d->selector) == 0) return std::nullopt;
  const llvm::APInt range = this->range(facts, d->selector);
  std::optional<bool> answer;
  for (unsigned v = 0; v < range.getBitWidth(); ++v) {
    if (!range[v]) continue;
    const bool bit = d->values[v].getBoolValue();
    if (answer && *answer != bit) return std::nullopt;
    answer = bit;
  }
  return answer;
}

NodeId Restrictor::restrict(const Facts& facts, NodeId id) {
  Memory memory;
  return rebuild(facts, id, memory);
}

Questions Restrictor::questions(const Facts& facts, NodeId id) const {
  Questions all;
  llvm::DenseSet<NodeId> seen;
  ask(facts, id, seen, all);
  return all;
}

// The way of rebuild(), as long as nothing is known.
void Restrictor::ask(const Facts& facts, NodeId id, llvm::DenseSet<NodeId>& seen,
                     Questions& all) const {
  if (!seen.insert(id).second) return;
  const Node& n = node(id);
  if (n.width == 1) {
    if (const auto value = known(facts, id)) {
      if (bits_[*value] != id) all.settled = false;
      return;
    }
    all.bits.push_back(id);
    if (const Domain* d = domain(id)) all.selectors.push_back(d->selector);
  }
  if (n.op == Op::kMux) {
    if (stays_whole(facts, id)) return;
    if (is_bit(n.in[0], false) || is_bit(n.in[0], true)) all.settled = false;
  } else if (!is_logic(n) && !(is_wiring(n.op) && facts.splits_shared)) {
    return;
  }
  for (const NodeId operand : n.in) ask(facts, operand, seen, all);
}

bool Restrictor::stays_whole(const Facts& facts, NodeId id) const {
  return node(id).width > 1 && id < uses_.size() && uses_[id] > 1 && !facts.splits_shared;
}

NodeId Restrictor::rebuild(const Facts& facts, NodeId id, Memory& memory) {
  const auto found = memory.find(id);
  if (found != memory.end()) return found->second;
  const auto answer = [&](NodeId result) { return memory[id] = result; };
  if (node(id).width == 1)
    if (const auto value = known(facts, id)) return answer(bit(*value));
  const Op op = node(id).op;
  if (op == Op::kMux) {
    if (stays_whole(facts, id)) return answer(id);
    const std::vector<NodeId> in = node(id).in;  // a copy: the list may grow
    const NodeId condition = rebuild(facts, in[0], memory);
    if (is_bit(condition, true)) return answer(rebuild(facts, in[1], memory));
    if (is_bit(condition, false)) return answer(rebuild(facts, in[2], memory));
    const NodeId then = rebuild(facts, in[1], memory);
    const NodeId otherwise = rebuild(facts, in[2], memory);
    if (condition == in[0] && then == in[1] && otherwise == in[2]) return answer(id);
    return answer(choose(id, condition, then, otherwise));
  }
  if (is_wiring(op) && facts.splits_shared) return answer(rewire(facts, id, memory));
  if (!is_logic(node(id))) return answer(id);
  std::vector<NodeId> in = node(id).in;
  for (NodeId& operand : in) operand = rebuild(facts, operand, memory);
  return answer(in == node(id).in ? id : make(id, op, std::move(in)));
}

NodeId Restrictor::rewire(const Facts& facts, NodeId id, Memory& memory) {
  std::vector<NodeId> in = node(id).in;
  for (NodeId& operand : in) operand = rebuild(facts, operand, memory);
  if (in == node(id).in) return id;
  Node n = node(id);
  n.in = std::move(in);
  n.name.clear();
  std::vector<llvm::APInt> constants;
  for (const NodeId operand : n.in)
    if (node(operand).op == Op::kConstant) constants.push_back(node(operand).value);
  if (constants.size() == n.in.size()) {  // no bits can be selected from a number
    n.value = evaluate(m_, n, constants);
    n.op = Op::kConstant;
    n.in.clear();
    const auto known = folded_.emplace(std::pair(n.width, llvm::toString(n.value, 16, false)), kNone);
    if (known.second) known.first->second = append(std::move(n));
    return known.first->second;
  }
  const Node& inner = node(n.in[0]);
  if (n.op == Op::kSlice) {
    if (n.low == 0 && inner.width == n.width) return n.in[0];
    if (inner.op == Op::kSlice) {
      n.low += inner.low;
      n.in = {inner.in[0]};
    }
  }
  const auto [at, fresh] = wired_.emplace(std::tuple(n.op, n.width, n.low, n.in), kNone);
  if (fresh) at->second = append(std::move(n));
  return at->second;
}

NodeId Restrictor::bit(bool value) {
  if (bits_[value] == kNone) {
    Node n;
    n.value = llvm::APInt(1, value);
    bits_[value] = append(std::move(n));
  }
  return bits_[value];
}

NodeId Restrictor::choose(NodeId like, NodeId condition, NodeId then, NodeId otherwise) {
  if (then == otherwise) return then;
  if (node(condition).op == Op::kNot)
    return choose(like, node(condition).in[0], otherwise, then);
  // c ? a : d ? a : b  and  c ? (d ? a : b) : b
  if (node(otherwise).op == Op::kMux && node(otherwise).in[1] == then) {
    const NodeId last = node(otherwise).in[2];
    const NodeId either = make(like, Op::kOr, {condition, node(otherwise).in[0]});
    return choose(like, either, then, last);
  }
  if (node(then).op == Op::kMux && node(then).in[2] == otherwise) {
    const NodeId first = node(then).in[1];
    const NodeId both = make(like, Op::kAnd, {condition, node(then).in[0]});
    return choose(like, both, first, otherwise);
  }
  if (is_bit(then, true)) return make(like, Op::kOr, {condition, otherwise});
  if (is_bit(otherwise, false)) return make(like, Op::kAnd, {condition, then});
  const bool falls = is_bit(then, false), rises = is_bit(otherwise, true);
  if (!falls && !rises) return make(like, Op::kMux, {condition, then, otherwise});
  const NodeId inverse = make(like, Op::kNot, {condition});
  return falls ? make(like, Op::kAnd, {inverse, otherwise}) : make(like, Op::kOr, {inverse, then});
}

NodeId Restrictor::make(NodeId like, Op op, std::vector<NodeId> in) {
  if (op == Op::kNot) {
    if (is_bit(in[0], false) || is_bit(in[0], true)) return bit(is_bit(in[0], false));
    if (node(in[0]).op == Op::kNot) return node(in[0]).in[0];
  } else if (op != Op::kMux) {
    for (int i = 0; i < 2; ++i) {
      const NodeId other = in[1 - i];
      const bool zero = is_bit(in[i], false), one = is_bit(in[i], true);
      if (!zero && !one) continue;
      if (op == Op::kAnd) return zero ? in[i] : other;
      if (op == Op::kOr) return one ? in[i] : other;
      return zero ? other : make(like, Op::kNot, {other});
    }
    if (in[0] == in[1]) return op == Op::kXor ? bit(false) : in[0];
  }
  const unsigned width = op == Op::kMux ? node(like).width : 1;
  const Key key{op, width, in};
  const auto found = made_.find(key);
  if (found != made_.end()) return found->second;
  Node n;
  n.op = op;
  n.width = width;
  n.in = std::move(in);
  n.source = node(like).source;
  const NodeId id = append(std::move(n));
  made_.emplace(key, id);
  return id;
}

NodeId Restrictor::append(Node n) {
  m_.nodes.push_back(std::move(n));
  domains_.emplace_back();
  domains_.back() = find_domain(m_.nodes.back());
  return static_cast<NodeId>(m_.nodes.size() - 1);
}

}  // namespace hlsgen
