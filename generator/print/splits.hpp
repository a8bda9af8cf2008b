// Which decision comes first among what is still to be decided, asked again after each one taken.
//
//     a <= c && x ? d : a;  b <= c ? e : b     ->   c, which both join;  then x, within
//
// A condition is asked of those updates alone that know it, and again only when one of them is gone:
// what a thousand registers do, each under a condition of its own, is found by as many questions.
//
// Test: tests/generator/clocked_print_test.cpp

#pragma once

#include "generator/print/rate.hpp"

#include <llvm/ADT/DenseMap.h>

namespace hlsgen {

class Splits {
 public:
  // All under `facts`, by which the updates are restricted already.
  Splits(Restrictor& restrictor, Rater& rater, Updates updates, const Facts& facts);

  // The one that leaves least to compute; no selector if none is worth it.
  Split best();
  // Who joins the last one asked for; they are gone then.
  Updates take();
  Updates rest() const;

 private:
  using Positions = std::vector<unsigned>;  // of candidates
  struct Candidate {
    Update update;
    double own = 0;                  // what it gains from its own condition
    std::vector<unsigned> literals;  // what that hangs on; numbers of literals_
    NodeId condition = kNone;
    Positions rated;       // literals that it joined, and selectors
    Positions selected;
    bool taken = false;
  };
  struct Rated {
    bool known = false;
    double gain = 0;
    Positions joined;
  };
  struct Literal {
    NodeId id = kNone;
    unsigned readers = 0;   // candidates whose condition has it as a part, and as the whole
    unsigned wholes = 0;
    unsigned selector = kNone;  // number of selectors_
    Rated rated;
  };
  struct Selector {
    NodeId id = kNone;
    unsigned readers = 0;  // literals
    Rated rated;
    Split split;
  };
  // Who asks for a condition, or for the range of a selector.
  struct Index {
    llvm::DenseMap<NodeId, Positions> bits, selectors;
    Positions always;  // changes by what is known already
  };

  const Node& node(NodeId id) const { return restrictor_.node(id); }
  void add_literals(NodeId id, unsigned depth, std::vector<NodeId>& out) const;
  void collect();
  Index index(const Facts& facts) const;
  Split on(NodeId condition) const;
  Split cases(NodeId selector, const Positions& asked);
  Positions asked(const Index& index, const Facts& facts) const;
  Positions left_of(Positions positions) const;
  Split rate(Split split, const Positions& asked, Rated& rated);
  void rate(unsigned literal);
  void rate_selector(unsigned selector);

  Restrictor& restrictor_;
  Rater& rater_;
  const Facts& facts_;
  std::vector<Candidate> candidates_;
  std::vector<Literal> literals_;    // in the order of their nodes, as are
  std::vector<Selector> selectors_;
  Index index_, index_of_cases_;
  bool has_index_of_cases_ = false;
  Rated* chosen_ = nullptr;
};

}  // namespace hlsgen
