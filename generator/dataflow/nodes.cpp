#include "generator/dataflow/nodes.hpp"

#include <llvm/ADT/StringExtras.h>

#include <algorithm>

namespace hlsgen {

void NodeBuilder::name(NodeId node, const std::string& name) {
  const Op op = nodes_[node].op;
  const bool has_own =
      op == Op::kConstant || op == Op::kInput || op == Op::kRegister || op == Op::kInstanceOutput;
  if (!has_own && nodes_[node].name.empty()) nodes_[node].name = name;
}

void NodeBuilder::hint(NodeId node, const std::string& name) {
  if (nodes_[node].hint.empty()) nodes_[node].hint = name;
}

void NodeBuilder::returned(NodeId node, const std::string& function) {
  if (nodes_[node].returned) return;
  nodes_[node].function = function;
  nodes_[node].returned = true;
}

NodeId NodeBuilder::add(Op op, unsigned width, std::vector<NodeId> in, unsigned index,
                        unsigned port, unsigned low) {
  const auto [entry, is_new] =
      known_.try_emplace(Key{op, width, in, index, port, low}, static_cast<NodeId>(nodes_.size()));
  if (is_new) {
    Node node;
    node.op = op;
    node.width = width;
    node.in = std::move(in);
    node.index = index;
    node.port = port;
    node.low = low;
    node.source = source_;
    node.function = function_;
    nodes_.push_back(std::move(node));
  }
  return entry->second;
}

NodeId NodeBuilder::constant(const llvm::APInt& value) {
  const auto key = std::pair(value.getBitWidth(), llvm::toString(value, 16, false));
  const auto [entry, is_new] = constants_.try_emplace(key, static_cast<NodeId>(nodes_.size()));
  if (is_new) {
    Node node;
    node.width = value.getBitWidth();
    node.value = value;
    nodes_.push_back(std::move(node));
  }
  return entry->second;
}

NodeId NodeBuilder::source_node(Op op, unsigned width, unsigned index, unsigned port) {
  return add(op, width, {}, index, port);
}

NodeId NodeBuilder::table(unsigned width, NodeId address, unsigned index) {
  return add(Op::kTable, width, {address}, index);
}

bool NodeBuilder::is_value(NodeId a, std::uint64_t value) const {
  return is_constant(a) && nodes_[a].value == value;
}

unsigned NodeBuilder::significant(NodeId a) const {
  return nodes_[a].op == Op::kZext ? nodes_[nodes_[a].in[0]].width : nodes_[a].width;
}

NodeId NodeBuilder::unary_not(NodeId a) {
  if (nodes_[a].op == Op::kNot) return nodes_[a].in[0];
  if (is_constant(a)) return constant(~nodes_[a].value);
  return add(Op::kNot, width(a), {a});
}

NodeId NodeBuilder::binary(Op op, NodeId a, NodeId b) {
  if (op == Op::kXor && is_constant(b) && nodes_[b].value.isAllOnes()) return unary_not(a);
  if (op == Op::kAnd && width(a) > 1 && is_constant(b) && nodes_[b].value.isMask()) {
    const unsigned low = nodes_[b].value.countTrailingOnes();
    return zext(slice(a, low, 0), width(a));
  }
  return add(op, width(a), {a, b});
}

NodeId NodeBuilder::compare(Op op, NodeId a, NodeId b) {
  if (op == Op::kSlt && is_value(b, 0)) return bit(a, width(a) - 1);
  // One bit against a constant is a wire.
  if (width(a) == 1 && is_constant(b) && (op == Op::kEq || op == Op::kNe)) {
    return (op == Op::kEq) == is_value(b, 1) ? a : unary_not(a);
  }
  if (is_constant(b) && (op == Op::kEq || op == Op::kNe)) {
    const NodeId equal = equals(a, b);
    return op == Op::kEq ? equal : unary_not(equal);
  }
  return add(op, 1, {a, b});
}

// Against a constant; a choice between constants is known by its condition.
NodeId NodeBuilder::equals(NodeId a, NodeId b) {
  if (is_constant(a)) return constant(1, nodes_[a].value == nodes_[b].value ? 1 : 0);
  if (nodes_[a].op == Op::kMux) {
    const auto in = nodes_[a].in;
    if (is_constant(in[1]) || is_constant(in[2])) {
      return mux(in[0], equals(in[1], b), equals(in[2], b));
    }
  }
  return add(Op::kEq, 1, {a, b});
}

NodeId NodeBuilder::mux(NodeId condition, NodeId yes, NodeId no) {
  if (yes == no) return yes;
  if (is_constant(condition)) return is_value(condition, 1) ? yes : no;
  if (nodes_[condition].op == Op::kNot) return mux(nodes_[condition].in[0], no, yes);
  if (width(yes) == 1) {
    if (is_value(yes, 1)) return is_value(no, 0) ? condition : binary(Op::kOr, condition, no);
    if (is_value(no, 0)) return binary(Op::kAnd, condition, yes);
    if (is_value(yes, 0)) {
      const NodeId other = unary_not(condition);
      return is_value(no, 1) ? other : binary(Op::kAnd, other, no);
    }
    if (is_value(no, 1)) return binary(Op::kOr, unary_not(condition), yes);
  }
  return add(Op::kMux, width(yes), {condition, yes, no});
}

NodeId NodeBuilder::slice(NodeId a, unsigned width, unsigned low) {
  const Node& node = nodes_[a];
  if (low == 0 && width == node.width) return a;
  switch (node.op) {
    case Op::kConstant:
      return constant(node.value.extractBits(width, low));
    case Op::kSlice:
      return slice(node.in[0], width, node.low + low);
    case Op::kZext:
    case Op::kSext: {
      const NodeId inner = node.in[0];
      const unsigned known = nodes_[inner].width;
      if (low + width <= known) return slice(inner, width, low);
      if (low == 0) return node.op == Op::kZext ? zext(inner, width) : sext(inner, width);
      if (low >= known && node.op == Op::kZext) return constant(width, 0);
      break;
    }
    case Op::kConcat: {
      unsigned end = node.width;
      for (const NodeId part : node.in) {
        const unsigned start = end - nodes_[part].width;
        if (low >= start && low + width <= end) return slice(part, width, low - start);
        end = start;
      }
      break;
    }
    default:
      break;
  }
  return add(Op::kSlice, width, {a}, 0, 0, low);
}

NodeId NodeBuilder::concat(const std::vector<NodeId>& parts) {
  if (parts.size() == 1) return parts[0];
  unsigned sum = 0;
  for (const NodeId part : parts) sum += width(part);
  return add(Op::kConcat, sum, parts);
}

NodeId NodeBuilder::zext(NodeId a, unsigned width) {
  if (width == nodes_[a].width) return a;
  if (is_constant(a)) return constant(nodes_[a].value.zext(width));
  if (nodes_[a].op == Op::kZext) return zext(nodes_[a].in[0], width);
  return add(Op::kZext, width, {a});
}

NodeId NodeBuilder::sext(NodeId a, unsigned width) {
  if (width == nodes_[a].width) return a;
  if (is_constant(a)) return constant(nodes_[a].value.sext(width));
  if (nodes_[a].op == Op::kSext) return sext(nodes_[a].in[0], width);
  if (nodes_[a].op == Op::kZext) return zext(nodes_[a].in[0], width);  // its top bit is zero
  return add(Op::kSext, width, {a});
}

NodeId NodeBuilder::shift(Op op, NodeId a, NodeId amount) {
  return is_constant(amount) ? shift_by(op, a, value(amount)) : add(op, width(a), {a, amount});
}

NodeId NodeBuilder::shift_by(Op op, NodeId a, std::uint64_t amount) {
  const unsigned total = width(a);
  const auto by = static_cast<unsigned>(std::min<std::uint64_t>(amount, total));
  if (by == 0) return a;
  if (op == Op::kAshr)
    return sext(slice(a, std::max(1U, total - by), std::min(by, total - 1)), total);
  if (by == total) return constant(total, 0);
  if (op == Op::kLshr) return zext(slice(a, total - by, by), total);
  return concat({slice(a, total - by, 0), constant(by, 0)});
}

NodeId NodeBuilder::choice(std::vector<NodeId> list, NodeId number) {
  const std::size_t all = list.size();
  for (unsigned place = 0; list.size() > 1; ++place) {
    std::vector<NodeId> half;
    for (std::size_t i = 0; i + 1 < list.size(); i += 2) {
      half.push_back(mux(bit(number, place), list[i + 1], list[i]));
      const std::size_t first = i << place, last = std::min(all, (i + 2) << place) - 1;
      if (last - first + 1 < all) hint(half.back(), "_" + std::to_string(first) + "_to_" + std::to_string(last));
    }
    if (list.size() % 2 == 1) half.push_back(list.back());
    list = std::move(half);
  }
  return list[0];
}

}  // namespace hlsgen
