// The syntax tree of one printed module: what legalise makes, prettify improves and the writer
// writes down.  Every expression knows its width; no text is ever taken apart again.
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include <llvm/ADT/APInt.h>

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace hlsgen::syntax {

struct Expr {
  enum class Kind {
    kName,         // text
    kLiteral,      // value
    kSelect,       // text[high:low]
    kConcat,       // {operands...}
    kReplicate,    // {count{operands[0]}}
    kUnary,        // text operands[0]
    kBinary,       // operands[0] text operands[1]
    kConditional,  // operands[0] ? operands[1] : operands[2]
    kSigned,       // $signed(operands[0]), or what `text` says
  };
  enum class Base { kDecimal, kHex, kSignedDecimal, kSignedHex };

  Kind kind = Kind::kLiteral;
  unsigned width = 1;
  std::string text;
  llvm::APInt value{1, 0};
  Base base = Base::kDecimal;
  unsigned high = 0, low = 0;   // kSelect
  unsigned declared_width = 1;  // kSelect: of the signal, a select of all of it being its name
  std::string index;            // kSelect: of one bit, its name
  bool declared_signed = false;  // kName
  unsigned count = 1;           // kReplicate
  std::vector<Expr> operands;

  bool is(Kind k) const { return kind == k; }
  bool is_operator(std::string_view op) const {
    return (kind == Kind::kUnary || kind == Kind::kBinary) && text == op;
  }
};
bool operator==(const Expr& a, const Expr& b);

Expr name(std::string text, unsigned width);
Expr literal(llvm::APInt value, Expr::Base base = Expr::Base::kDecimal);
Expr select(const Expr& signal, unsigned high, unsigned low);  // of a name or a select
Expr concat(std::vector<Expr> parts);
Expr replicate(unsigned count, Expr e);
Expr unary(std::string op, Expr e, unsigned width);
Expr binary(std::string op, Expr a, Expr b, unsigned width);
Expr conditional(Expr condition, Expr then, Expr otherwise);
Expr as_signed(Expr e);
Expr as_unsigned(Expr e);
// Whether a tool takes it for a signed value: all that it is made of is.
bool is_signed(const Expr& e);

struct Wire {
  std::string name;
  unsigned width = 1;
  Expr value;
  std::string comment;
};

struct Case {
  struct Target {
    std::string name;
    unsigned width = 1;
  };
  struct Arm {
    std::vector<Expr> labels;   // none: default
    std::vector<Expr> values;   // one per target
  };
  std::vector<Target> targets;
  Expr selector;
  std::vector<Arm> arms;  // the last is the default
  std::string comment;
};

struct Cell {
  struct Output {
    std::string port, wire;
    unsigned width = 1;
  };
  std::string module, name;
  bool clocked = false;
  std::vector<std::pair<std::string, Expr>> parameters, inputs;
  std::vector<Output> outputs;
};

using Item = std::variant<Wire, Case, Cell>;

struct Statement;

struct Block {  // of an always_ff
  std::vector<Item> locals;  // wires and cases
  std::vector<Statement> statements;
};

struct Statement {
  struct Arm {
    std::vector<Expr> labels;  // none: default
    Block block;
    std::vector<Expr> rest;  // what the default stands for, for a comment
  };
  // An assignment if target is set, a case if there are arms, else an if.
  std::string target;
  Expr value;  // assigned, or what decides
  Block then, otherwise;
  std::vector<Arm> arms;
  std::string comment;

  bool is_if() const { return target.empty() && arms.empty(); }
};

struct Signal {  // parameter, port or register
  std::string name;
  unsigned width = 1;
  std::string comment;
  bool synchronises = false;
  bool value = false;      // parameter: the default
  bool is_signed = false;  // register
};

using Enumerators = std::vector<std::pair<std::string, Expr>>;  // localparams

struct Text {
  std::vector<std::string> header;  // comment lines
  std::string name;
  bool clocked = false;
  std::vector<Signal> parameters, inputs, outputs, registers;
  std::vector<std::pair<std::string, Expr>> constants;  // localparams
  std::vector<Item> items;                              // each after what it reads
  Block resets, updates;                                // of the one always_ff
  std::vector<Enumerators> enumerations;                // those of the module
  std::map<std::string, std::size_t> sets;              // signals with a bit for each value of an enumeration
  std::vector<std::pair<std::string, Expr>> assigns;    // of the outputs
  std::vector<Expr> unused;                             // what no one reads
};

}  // namespace hlsgen::syntax
