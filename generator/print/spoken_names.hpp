// Names that say how a value is made, of the names that it is made of:
//
//     run && !held                  ->  run_and_not_held         !(enough || over)   ->  neither_enough_nor_over
//     last + 4'd1                   ->  last_plus_one            ~mask               ->  not_mask
//     state == State_kIdle          ->  state_is_idle            sub < last          ->  sub_below_last
//     code == 3 || code == 4        ->  code_is_three_or_four
//     brakes ? duty : 16'd0         ->  duty_if_brakes           at_bits[State_kRun] ->  in_run
//
// Test: tests/generator/spoken_names_test.cpp

#pragma once

#include "generator/print/plan.hpp"

#include <functional>
#include <string>
#include <vector>

namespace hlsgen {

constexpr std::size_t kLongestName = 44;  // characters; beyond, the expression says more

std::string inverted(const std::string& name);  // run -> not_run, and back

class SpokenNames {
 public:
  // `given` is the name that a value has without us, or empty; `sets` is of sets_of().
  SpokenNames(const Module& module, const Plan& plan, const std::vector<int>& sets, std::function<std::string(NodeId)> given)
      : m_(module), plan_(plan), sets_(sets), given_(std::move(given)) {}

  // Empty where something that it is made of has no name, or where the name would be longer than it says.
  std::string of(NodeId id) const;

  // Of a value that has one bit of a set or none: that bit's enumerator, as "pull_in"; else empty.
  std::string member(NodeId id) const { return sets_[id] < 0 ? "" : member(id, sets_[id]); }

  // What a value is to the only one that reads it: `_if_run` of run && value, `_unless_run` of run ? 1'b0 : value; else empty.
  std::string role(NodeId id, NodeId reader) const;

  // Of a choice, what decides it: `mode` of mode == kRun ? a : b, the enumeration of a bit of a set; else empty.
  std::string selector(NodeId id) const;

 private:
  std::string member(NodeId id, int set) const;
  std::string term(NodeId id) const;
  std::string made(NodeId id) const;
  std::string compared(const Node& n) const;
  std::string added(const Node& n) const;
  std::string chosen(const Node& n) const;
  std::string joined(const std::vector<NodeId>& ids, const std::string& between) const;
  std::vector<NodeId> flat(NodeId id) const;
  std::string number(NodeId id) const;
  std::string compared_with(NodeId id, NodeId value) const;
  std::string one_of(const std::vector<NodeId>& ids) const;
  std::string enumerator(int enumeration, std::uint64_t value) const;
  bool is_zero(NodeId id) const;

  const Module& m_;
  const Plan& plan_;
  const std::vector<int>& sets_;
  std::function<std::string(NodeId)> given_;
};

}  // namespace hlsgen
