// Random netlists for tests of passes and printers: every operator, mixed widths, constants at the
// corners, registers that feed back.

#pragma once

#include "tests/generator/build.hpp"

#include <llvm/ADT/ArrayRef.h>

#include <random>

namespace hlsgen::test {

class RandomNetlist {
 public:
  explicit RandomNetlist(unsigned seed) : random_(seed) {}

  Module make(const std::string& name, unsigned operators) {
    Build b(name);
    for (int i = 0; i < 4; ++i) pool_.push_back(b.input("in" + std::to_string(i), any_width()));
    std::vector<NodeId> registers;
    for (int i = 0; i < 3; ++i) {
      const unsigned w = any_width();
      registers.push_back(b.reg("state" + std::to_string(i), w));
      b.m.registers.back().reset = any_value(w);
      pool_.push_back(registers.back());
    }
    for (unsigned i = 0; i < operators; ++i) pool_.push_back(grow(b));
    for (const NodeId r : registers) b.next(r, fit(b, recent(), b.width(r)));
    for (unsigned i = 0; i < 2 + operators / 8; ++i)
      b.output("out" + std::to_string(i), i < 2 ? recent() : any());
    return std::move(b.m);
  }

  llvm::APInt any_value(unsigned w) {
    switch (below(6)) {
      case 0: return llvm::APInt(w, below(4));
      case 1: return llvm::APInt::getAllOnes(w) - llvm::APInt(w, below(3));
      case 2: return llvm::APInt::getSignedMinValue(w);
      case 3: return llvm::APInt::getOneBitSet(w, below(w));
      default: {
        std::vector<std::uint64_t> words((w + 63) / 64);
        for (std::uint64_t& word : words) word = random_();
        return {w, llvm::ArrayRef<std::uint64_t>(words)};
      }
    }
  }
  unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }

 private:
  unsigned any_width() {
    constexpr unsigned kWidths[] = {1, 1, 2, 3, 4, 7, 8, 12, 16, 33};
    return kWidths[below(std::size(kWidths))];
  }
  NodeId any() { return pool_[below(static_cast<unsigned>(pool_.size()))]; }
  NodeId recent() {
    const auto n = static_cast<unsigned>(pool_.size());
    return pool_[n - 1 - below(std::min(n, 8u))];
  }
  NodeId fit(Build& b, NodeId x, unsigned w) {
    if (b.width(x) > w) return b.slice(x, w - 1, 0);
    if (b.width(x) < w) return below(2) != 0 ? b.zext(x, w) : b.sext(x, w);
    return x;
  }
  NodeId constant(Build& b, unsigned w) {
    Node n;
    n.width = w;
    n.value = any_value(w);
    return b.add(n);
  }
  NodeId operand(Build& b, unsigned w) {
    return below(4) == 0 ? constant(b, w) : fit(b, any(), w);
  }
  NodeId condition(Build& b) { return fit(b, any(), 1); }

  NodeId grow(Build& b) {
    const unsigned w = any_width();
    switch (below(12)) {
      case 0: case 1: {
        constexpr Op kOps[] = {Op::kAdd, Op::kSub, Op::kAnd, Op::kOr, Op::kXor};
        return b.op(kOps[below(5)], operand(b, w), operand(b, w));
      }
      case 2: {  // a product of narrow factors, as C++ makes them
        const unsigned wide = std::min(w, 12u) + 4;
        const NodeId x = fit(b, any(), std::min(w, 12u)), y = fit(b, any(), 4);
        return b.op(Op::kMul, below(2) != 0 ? b.sext(x, wide) : b.zext(x, wide),
                    below(2) != 0 ? b.sext(y, wide) : b.zext(y, wide));
      }
      case 3: return b.inv(operand(b, w));
      case 4: {
        constexpr Op kOps[] = {Op::kShl, Op::kLshr, Op::kAshr};
        return b.op(kOps[below(3)], operand(b, w), operand(b, 1 + below(6)));
      }
      case 5: case 6: {
        const auto op = static_cast<Op>(static_cast<int>(Op::kEq) + static_cast<int>(below(6)));
        return b.op(op, operand(b, w), operand(b, w));
      }
      case 7: return b.mux(condition(b), operand(b, w), operand(b, w));
      case 8: {  // a switch
        const unsigned bits = 2 + below(2);
        const NodeId selector = fit(b, any(), bits);
        NodeId chain = operand(b, w);
        for (unsigned k = 0; k < (1u << bits) - below(2); ++k)
          chain = b.mux(b.op(Op::kEq, selector, b.constant(bits, k)), operand(b, w), chain);
        return chain;
      }
      case 9: {
        const NodeId x = any();
        const unsigned low = below(b.width(x));
        return b.slice(x, low + below(b.width(x) - low), low);
      }
      case 10: return b.concat({any(), operand(b, 1 + below(4)), operand(b, 1 + below(4))});
      default: {
        std::vector<std::uint64_t> entries(1u << (1 + below(3)));
        for (std::uint64_t& e : entries) e = random_() & ((1u << std::min(w, 12u)) - 1);
        unsigned bits = 0;
        while ((1u << bits) < entries.size()) ++bits;
        return b.table(std::min(w, 12u), entries, fit(b, any(), bits));
      }
    }
  }

  std::mt19937_64 random_;
  std::vector<NodeId> pool_;
};

}  // namespace hlsgen::test
