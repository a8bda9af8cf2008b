// The netlist: what the front end makes of a C++ block, what the passes work on, what the printers
// print.
//
// A module is a list of nodes in topological order: every input of a node stands before it (registers
// and instance outputs are sources, so there is no cycle).  Values are bit vectors without a sign;
// signed meaning sits in the operator (slt, ashr, sext), as in LLVM.  Ports and registers remember
// their C++ spelling, sign and enumeration for the printer.
//
// Doc: docs/generator.md   Test: tests/generator/backend_pass_test.cpp

#pragma once

#include <llvm/ADT/APInt.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hlsgen {

using NodeId = std::uint32_t;
inline constexpr NodeId kNone = ~NodeId{0};

enum class Op : std::uint8_t {
  // sources
  kConstant,        // value
  kInput,           // index: Module::inputs
  kRegister,        // index: Module::registers (the present value)
  kInstanceOutput,  // index: Module::instances, port: output of that instance
  // arithmetic, all operands and the result of one width
  kAdd, kSub, kMul,
  kAnd, kOr, kXor, kNot,
  kShl, kLshr, kAshr,  // {value, amount}; the amount may have another width; amount >= width gives 0
                       // (or the sign), never poison
  // comparisons, operands of one width, result of one bit
  kEq, kNe, kUlt, kUle, kSlt, kSle,
  // shape
  kMux,     // {condition (one bit), then, else}
  kSlice,   // {value}: bits [low + width - 1 : low]
  kConcat,  // most significant first
  kZext, kSext,
  kTable,  // {address}: entry of Module::tables[index]; the address is in range by construction
};

struct SourceLine {
  std::string file;  // relative to the root of the tree
  unsigned line = 0;
};

struct Node {
  Op op = Op::kConstant;
  unsigned width = 1;
  std::vector<NodeId> in;
  llvm::APInt value{1, 0};  // kConstant
  unsigned index = 0;       // see Op
  unsigned port = 0;        // kInstanceOutput
  unsigned low = 0;         // kSlice
  std::string name;         // C++ variable, or empty
  std::string function;     // C++ function that made it, other than tick, or empty
  bool returned = false;    // it is what that function returned
  std::string hint;         // what to call it where it has no name and needs one, as "not_goes"; "_0_to_3": behind what it is for
  SourceLine source;
};

struct Enumeration {
  std::string name;  // C++ name without namespaces
  unsigned width = 1;
  std::vector<std::pair<std::string, std::uint64_t>> values;  // in the order of the source
};

// How a leaf of In, Out or of the state looked in C++.
struct Leaf {
  std::string name;      // "kp", or "config.kp" for a member of a member, "history[3]" for an element
  unsigned width = 1;
  bool is_signed = false;
  int enumeration = -1;  // Module::enumerations
  std::string comment;   // the `// u0.16, turns` behind the member in its header, or empty
  std::optional<bool> parameter = {};  // of In: fixed at synthesis, with this default
  int set_of = -1;                     // Module::enumerations: a bit for each of its values (hls/numeric/one_hot.hpp)
};

// Printed as a signed vector: a bit alone has no sign to show.
inline bool is_signed(const Leaf& leaf) { return leaf.is_signed && leaf.width > 1; }

struct Register {
  Leaf leaf;
  llvm::APInt reset{1, 0};
  NodeId next = kNone;
  SourceLine source;
};

struct Output {
  Leaf leaf;
  NodeId value = kNone;
};

struct Module;

struct Instance {
  std::string name;             // the C++ member
  std::string module;           // name of the module it is made of
  std::vector<NodeId> inputs;   // one per input of that module, in its order
};

struct Table {
  std::string name;
  unsigned width = 1;
  std::vector<llvm::APInt> entries;
};

struct Module {
  std::string name;        // gate_guard
  std::string cpp_class;   // steplock::GateGuard<12>
  SourceLine source;       // where the class is defined
  std::vector<std::string> remarks;  // lines in the header of its print
  std::vector<std::string> contract;  // what its C++ header begins with
  std::vector<Leaf> inputs;
  std::vector<Output> outputs;
  std::vector<Register> registers;
  std::vector<Instance> instances;
  std::vector<Table> tables;
  std::vector<Enumeration> enumerations;
  std::vector<Node> nodes;
};

// Children before parents; the top is last.
struct Design {
  std::vector<Module> modules;
};

}  // namespace hlsgen
