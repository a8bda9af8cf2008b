#include "generator/passes/simplify_wiring.hpp"

#include "generator/passes/rebuild.hpp"

#include <algorithm>

namespace hlsgen {
namespace {

NodeId slice_of_extension(Rebuild& b, const Node& n, const Node& e) {
  const NodeId x = e.in[0];
  const unsigned inner = b.width(x), high = n.low + n.width;
  if (high <= inner) return b.slice(x, n.low, n.width);
  if (e.op == Op::kZext) {
    if (n.low >= inner) return b.zero(n.width);
    return b.zext(b.slice(x, n.low, inner - n.low), n.width);
  }
  const unsigned low = std::min(n.low, inner - 1);
  return b.sext(b.slice(x, low, inner - low), n.width);
}

NodeId slice_of_concat(Rebuild& b, const Node& n, const Node& c) {
  std::vector<NodeId> parts;
  unsigned top = c.width;
  for (const NodeId part : c.in) {
    const unsigned bottom = top - b.width(part);
    const unsigned high = std::min(top, n.low + n.width), low = std::max(bottom, n.low);
    if (low < high) parts.push_back(b.slice(part, low - bottom, high - low));
    top = bottom;
  }
  return b.concat(std::move(parts));
}

NodeId slice(Rebuild& b, const Node& n) {
  const NodeId x = n.in[0];
  if (n.low == 0 && n.width == b.width(x)) return x;
  const Node inner = b.node(x);
  const auto cut = [&](NodeId id) { return b.slice(id, n.low, n.width); };
  switch (inner.op) {
    case Op::kSlice: return b.slice(inner.in[0], inner.low + n.low, n.width);
    case Op::kZext: case Op::kSext: return slice_of_extension(b, n, inner);
    case Op::kConcat: return slice_of_concat(b, n, inner);
    case Op::kAnd: case Op::kOr: case Op::kXor:
      if (!b.used_once(x)) return kNone;
      return b.binary(inner.op, cut(inner.in[0]), cut(inner.in[1]));
    case Op::kNot:
      if (!b.used_once(x)) return kNone;
      return b.inverse(cut(inner.in[0]));
    case Op::kMux:
      if (!b.used_once(x)) return kNone;
      return b.mux(inner.in[0], cut(inner.in[1]), cut(inner.in[2]));
    default: return kNone;
  }
}

NodeId extension(Rebuild& b, const Node& n) {
  const NodeId x = n.in[0];
  if (b.width(x) == n.width) return x;
  const Node inner = b.node(x);
  if (inner.op == n.op) return n.op == Op::kZext ? b.zext(inner.in[0], n.width)
                                                 : b.sext(inner.in[0], n.width);
  if (inner.op == Op::kZext && b.width(inner.in[0]) < inner.width)
    return b.zext(inner.in[0], n.width);
  return kNone;
}

// Two neighbours of a concatenation as one value, or kNone.
NodeId joined(Rebuild& b, NodeId high, NodeId low) {
  const Node h = b.node(high), l = b.node(low);
  if (h.op == Op::kConstant && l.op == Op::kConstant) return b.value(h.value.concat(l.value));
  if (h.op == Op::kSlice && l.op == Op::kSlice && h.in[0] == l.in[0] && h.low == l.low + l.width)
    return b.slice(h.in[0], l.low, h.width + l.width);
  // Copies of the sign above the value itself.
  const NodeId sign = h.op == Op::kSext ? h.in[0] : high;
  const Node s = b.node(sign);
  if (s.width == 1 && s.op == Op::kSlice && s.in[0] == low && s.low == l.width - 1)
    return b.sext(low, h.width + l.width);
  if (s.width == 1 && s.op == Op::kSlice && l.op == Op::kSlice && s.in[0] == l.in[0] &&
      s.low == l.low + l.width - 1)
    return b.sext(low, h.width + l.width);
  return kNone;
}

NodeId concat(Rebuild& b, const Node& n) {
  if (n.in.size() == 1) return n.in[0];
  bool changed = false;
  std::vector<NodeId> flat;
  for (const NodeId part : n.in) {
    const Node p = b.node(part);
    if (p.op == Op::kConcat) {
      flat.insert(flat.end(), p.in.begin(), p.in.end());
      changed = true;
    } else if (p.op == Op::kZext) {
      flat.push_back(b.zero(p.width - b.width(p.in[0])));
      flat.push_back(p.in[0]);
      changed = true;
    } else {
      flat.push_back(part);
    }
  }
  std::vector<NodeId> parts;
  for (NodeId part : flat) {
    while (!parts.empty()) {
      const NodeId both = joined(b, parts.back(), part);
      if (both == kNone) break;
      parts.pop_back();
      part = both;
      changed = true;
    }
    parts.push_back(part);
  }
  if (const llvm::APInt* c = b.constant(parts[0]); c != nullptr && c->isZero() && parts.size() > 1) {
    parts.erase(parts.begin());
    return b.zext(b.concat(std::move(parts)), n.width);
  }
  return changed ? b.concat(std::move(parts)) : kNone;
}

NodeId wire(Rebuild& b, const Node& n) {
  switch (n.op) {
    case Op::kSlice: return slice(b, n);
    case Op::kZext: case Op::kSext: return extension(b, n);
    case Op::kConcat: return concat(b, n);
    default: return kNone;
  }
}

}  // namespace

bool simplify_wiring(Module& module) { return rewrite(module, wire); }

}  // namespace hlsgen
