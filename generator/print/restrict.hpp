// What a value comes to where some conditions are known.
//
//     c is 1:                 c ? a : b  ->  a       c & x  ->  x       c | x  ->  1
//     s is one of {2, 3}:     s == 5     ->  0       s < 4  ->  1       s == 2 stays
//
// Only choices, wiring and logic of one bit are looked into, never arithmetic: what is added or
// compared stays the node it was, so that two branches share it and nothing is computed twice.  What
// is new (`c & x` where x came to y) is appended to the module, each value once.
//
// Test: tests/generator/clocked_print_test.cpp

#pragma once

#include "generator/netlist.hpp"

#include <llvm/ADT/DenseMap.h>
#include <llvm/ADT/DenseSet.h>

#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace hlsgen {

// A value of few bits, and what another value is for each of its values.
struct Domain {
  NodeId selector = kNone;
  std::vector<llvm::APInt> values;  // 2^width of the selector
};

struct Facts {
  std::map<NodeId, bool> bits;           // conditions
  std::map<NodeId, llvm::APInt> ranges;  // of a selector: bit v is set if it may be v
  // A choice between words that is read in several places is hardware that they share: it stays whole
  // unless the places are arms of a case, of which each is much simpler.
  bool splits_shared = false;
};

// What restrict() asks on its way through a value.
struct Questions {
  bool settled = true;             // the value stays what it is
  std::vector<NodeId> bits;        // conditions
  std::vector<NodeId> selectors;   // whose ranges answer for some of them
};

class Restrictor {
 public:
  static constexpr unsigned kWidestSelector = 6;

  explicit Restrictor(Module& module);

  const Node& node(NodeId id) const { return m_.nodes[id]; }
  // Null unless the node is a function of one selector.
  const Domain* domain(NodeId id) const;
  llvm::APInt range(const Facts& facts, NodeId selector) const;

  void learn(Facts& facts, NodeId condition, bool value) const;
  NodeId restrict(const Facts& facts, NodeId id);
  // Other facts, of none of these, leave a settled value alone.
  Questions questions(const Facts& facts, NodeId id) const;

 private:
  using Key = std::tuple<Op, unsigned, std::vector<NodeId>>;
  using Memory = llvm::DenseMap<NodeId, NodeId>;

  bool is_bit(NodeId id, bool value) const {
    const Node& n = node(id);
    return n.op == Op::kConstant && n.width == 1 && n.value.getBoolValue() == value;
  }
  NodeId bit(bool value);
  Domain find_domain(const Node& n) const;
  std::optional<bool> known(const Facts& facts, NodeId id) const;
  void ask(const Facts& facts, NodeId id, llvm::DenseSet<NodeId>& seen, Questions& all) const;
  bool stays_whole(const Facts& facts, NodeId id) const;
  NodeId rebuild(const Facts& facts, NodeId id, Memory& memory);
  NodeId rewire(const Facts& facts, NodeId id, Memory& memory);
  // Logic of one bit, or a choice as wide as `like`; it has the line of that.
  NodeId make(NodeId like, Op op, std::vector<NodeId> in);
  NodeId choose(NodeId like, NodeId condition, NodeId then, NodeId otherwise);
  NodeId append(Node n);

  Module& m_;
  std::vector<Domain> domains_;
  std::map<Key, NodeId> made_;
  std::map<std::tuple<Op, unsigned, unsigned, std::vector<NodeId>>, NodeId> wired_;
  std::map<std::pair<unsigned, std::string>, NodeId> folded_;  // constants
  std::vector<unsigned> uses_;  // in the module as it came
  NodeId bits_[2] = {kNone, kNone};
};

}  // namespace hlsgen
