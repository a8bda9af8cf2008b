// Which instruction in which clock, and what of its numbers goes through the memory.
//
//     clock t      the sum                          its result, if nothing is cut, for a in t + 1
//     clock t + 1  shift and format                 in t + 2 for a, b, the condition; in t + 3 for c
//     clock t + 2  written to the memory            read in t + 3: for a, b in t + 4, for c, d in t + 5
//
// List scheduling, what early outputs wait for before the rest, the longest way to go first.  A register of the block has
// a cell of its own, which is written when nobody reads the old value any more.
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include <optional>

#include "generator/machine/program.hpp"

namespace hlsgen::machine {

enum class Way : std::uint8_t { kNone, kMemory, kSum, kResult, kPort };

struct Place {
  unsigned clock = 0;
  Way a = Way::kNone, b = Way::kNone, c = Way::kNone, d = Way::kNone, condition = Way::kNone;
  bool condition_early = false;        // taken with the factors, a clock before
  std::optional<unsigned> written;     // cell
};

struct Order {
  std::vector<Place> places;           // per instruction
  std::vector<std::optional<unsigned>> cell_of;  // per value that is read from the memory
  std::vector<std::optional<unsigned>> states;   // per register: its cell, the next one has the reset
  unsigned cells = 0;
  unsigned clocks = 0;                 // from start to done
  unsigned early = 0;                  // from start to the early outputs; 0: there are none
  unsigned bound = 0;                  // the longest way
};

// Adds what moves numbers to registers.
Order order(Program& program);

}  // namespace hlsgen::machine
