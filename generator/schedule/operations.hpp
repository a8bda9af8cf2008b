// What there is to schedule: the nodes of a block's sample, sorted by what a clock can do with
// them.
//
//     source    a constant, a register of the block, an input that is held: there in every step
//     taken     an input in the step of the start; later only where a register keeps it
//     logic     anything computed between registers, with an estimate of its delay
//     product   of a multiplier: factors into registers in one step, the product in the next
//     entry     of a large table: a register behind the table, one step
//
// Delays count quarters of a look-up table with its wire; a carry of two bits is one quarter.
//
// Test: tests/generator/schedule_test.cpp

#pragma once

#include "generator/netlist.hpp"
#include "generator/schedule/budget.hpp"

#include <vector>

namespace hlsgen::scheduling {

enum class Kind : std::uint8_t { kSource, kTaken, kLogic, kProduct, kEntry };

inline constexpr unsigned kQuarters = 4;               // of a level
inline constexpr unsigned kChoice = 2 * kQuarters;     // of a shared unit's operands
inline constexpr unsigned kUpdate = 1 * kQuarters;     // of a register of the block
inline constexpr unsigned kSmallTable = 512;           // bits that stay logic

struct Operations {
  Operations(const Module& module, const Budget& budget);

  const Node& node(NodeId id) const { return module.nodes[id]; }
  bool is_unit(NodeId id) const { return kind[id] == Kind::kProduct || kind[id] == Kind::kEntry; }
  // Steps from the operands to the value.
  unsigned latency(NodeId id) const { return kind[id] == Kind::kProduct ? 2 : 1; }
  // Units are numbered by pools: 0 holds the multipliers, each large table has a pool of one.
  unsigned pool(NodeId id) const { return kind[id] == Kind::kProduct ? 0 : 1 + node(id).index; }
  unsigned pools() const { return 1 + static_cast<unsigned>(module.tables.size()); }
  unsigned units_in(unsigned pool) const { return pool == 0 ? budget.multipliers : 1; }
  unsigned most_delay() const { return budget.levels * kQuarters; }

  const Module& module;
  Budget budget;
  std::vector<Kind> kind;
  std::vector<unsigned> delay;
  std::vector<NodeId> sinks;        // next values and outputs
  std::vector<bool> lives;          // somebody needs it
};

}  // namespace hlsgen::scheduling
