#include "generator/schedule/split_products.hpp"

#include <algorithm>

#include "generator/passes/known_bits.hpp"
#include "generator/passes/rebuild.hpp"

namespace hlsgen {
namespace {

struct Piece {
  NodeId value = kNone;
  unsigned width = 0;  // as a signed number
  unsigned shift = 0;
};

// Lower parts have no sign: one bit of the multiplier's stays 0.
std::vector<Piece> pieces_of(Rebuild& b, NodeId x, unsigned needed, unsigned width) {
  std::vector<Piece> pieces;
  unsigned low = 0;
  for (; needed - low > width; low += width - 1) {
    pieces.push_back({b.zext(b.slice(x, low, width - 1), width), width, low});
  }
  pieces.push_back({b.slice(x, low, needed - low), needed - low, low});
  return pieces;
}

NodeId resized(Rebuild& b, NodeId x, unsigned width) {
  return b.width(x) >= width ? b.slice(x, 0, width) : b.sext(x, width);
}

NodeId sum_of_products(Rebuild& b, const std::vector<Piece>& left, const std::vector<Piece>& right,
                       unsigned width) {
  std::vector<Piece> products;
  for (const Piece& x : left) {
    for (const Piece& y : right) {
      const unsigned shift = x.shift + y.shift;
      if (shift >= width) continue;
      const unsigned own = std::min(width - shift, x.width + y.width);
      products.push_back(
          {b.binary(Op::kMul, resized(b, x.value, own), resized(b, y.value, own)), own, shift});
    }
  }
  std::stable_sort(products.begin(), products.end(),
                   [](const Piece& x, const Piece& y) { return x.shift < y.shift; });
  NodeId sum = resized(b, products[0].value, width);
  for (std::size_t i = 1; i < products.size(); ++i) {
    const unsigned shift = products[i].shift;  // the bits below are the sum's already
    const NodeId upper = b.binary(Op::kAdd, b.slice(sum, shift, width - shift),
                                  resized(b, products[i].value, width - shift));
    sum = shift == 0 ? upper : b.concat({upper, b.slice(sum, 0, shift)});
  }
  return sum;
}

}  // namespace

bool split_products(Module& module, unsigned width, unsigned second_width) {
  const auto known = known_bits(module);
  const unsigned most = std::max(width, second_width);
  const unsigned least = std::min(width, second_width);
  return rewrite(module, [&](Rebuild& b, const Node& n) -> NodeId {
    if (n.op != Op::kMul) return kNone;
    const Node& old = module.nodes[b.old_id()];
    const unsigned needs[] = {std::min(n.width, known[old.in[0]].signed_width()),
                              std::min(n.width, known[old.in[1]].signed_width())};
    const unsigned wide = needs[0] >= needs[1] ? 0 : 1;
    if (needs[wide] <= most && needs[1 - wide] <= least) return kNone;
    return sum_of_products(b, pieces_of(b, n.in[wide], needs[wide], most),
                           pieces_of(b, n.in[1 - wide], needs[1 - wide], least), n.width);
  });
}

}  // namespace hlsgen
