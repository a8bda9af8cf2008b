#include "generator/machine/format_unit.hpp"

#include <algorithm>

namespace hlsgen::machine {

NodeId FormatUnit::fits(const Format& format, NodeId shifted) const {
  const unsigned width = nodes_.width(shifted);
  if (format.form != Form::kClamp) return nodes_.constant(1, 1);
  const unsigned low = format.width - (format.is_signed ? 1 : 0);
  const NodeId top = nodes_.slice(shifted, width - low, low);
  const NodeId zeros = nodes_.compare(Op::kEq, top, nodes_.constant(width - low, 0));
  if (!format.is_signed) return zeros;
  const NodeId ones =
      nodes_.compare(Op::kEq, top, nodes_.constant(llvm::APInt::getAllOnes(width - low)));
  return nodes_.binary(Op::kOr, zeros, ones);
}

NodeId FormatUnit::above(const Format& format, NodeId shifted) const {
  if (format.form == Form::kWrap && format.is_signed)
    return nodes_.bit(shifted, format.width - 1);
  if (format.form == Form::kAll || (format.form == Form::kClamp && format.is_signed))
    return nodes_.bit(shifted, nodes_.width(shifted) - 1);
  return nodes_.constant(1, 0);
}

NodeId FormatUnit::make(NodeId sum, NodeId shifted, unsigned width, NodeId format,
                        NodeId invert) const {
  const unsigned all = nodes_.width(shifted);
  const NodeId negative = nodes_.bit(sum, all - 1);
  const NodeId zero = nodes_.compare(Op::kEq, sum, nodes_.constant(all, 0));
  std::vector<NodeId> fit, sign, flag;
  Table masks{"low_bits", width, {}};
  for (const Format& f : formats_) {
    fit.push_back(fits(f, shifted));
    sign.push_back(above(f, shifted));
    const NodeId is = f.form == Form::kZero ? zero : negative;
    flag.push_back(f.is_flag() ? nodes_.binary(Op::kXor, is, invert) : nodes_.constant(1, 0));
    unsigned low = f.width - (f.is_signed ? 1 : 0);
    if (f.is_flag()) low = 0;
    if (f.form == Form::kAll) low = width;
    masks.entries.push_back(llvm::APInt::getLowBitsSet(width, std::min(low, width)));
  }
  // Whatever stands beyond is never asked for, but an address has to be within its table.
  while ((masks.entries.size() & (masks.entries.size() - 1)) != 0 || masks.entries.size() < 2)
    masks.entries.push_back(masks.entries.back());
  tables_.push_back(masks);
  const NodeId mask =
      nodes_.table(width, format, static_cast<unsigned>(tables_.size() - 1));
  const NodeId end = nodes_.sext(nodes_.unary_not(nodes_.bit(shifted, all - 1)), width);
  const NodeId fitting = nodes_.choice(fit, format);
  const NodeId low = nodes_.mux(fitting, nodes_.slice(shifted, width, 0), end);
  const NodeId beyond = nodes_.choice(sign, format);
  const NodeId high = nodes_.sext(beyond, width);
  const NodeId cut = nodes_.binary(Op::kOr, nodes_.binary(Op::kAnd, mask, low),
                                   nodes_.binary(Op::kAnd, nodes_.unary_not(mask), high));
  const NodeId flagged = nodes_.choice(flag, format);
  for (const auto& [node, name] : {std::pair{fitting, "fits"}, {beyond, "sign_above"}, {flagged, "flag"}, {mask, "low_bits"},
                                   {low, "clamped"}, {cut, "formatted"}}) {
    nodes_.hint(node, name);
  }
  return nodes_.binary(Op::kOr, cut, nodes_.zext(flagged, width));
}

}  // namespace hlsgen::machine
