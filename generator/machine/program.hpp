// A sample as a program for one datapath: numbers in a memory, one sum per clock.
//
//     result = format((a + b) >> shift)       b may be the product c d, an entry of the table, a port;
//                                             ~b with `negate`; one of both with a condition, then
//                                             with `negate` and `carry` -b or a
//     result = a + b == 0, < 0                flags: 0 or 1
//
// Numbers are integers, held sign-extended in words wide enough for each; sums may be wider before their
// format cuts them.  A value of the netlist is one integer or another by whether its reader takes it as
// signed.  Ranges are kept, so that what cannot wrap is not wrapped.
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/netlist.hpp"

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace hlsgen::machine {

using Number = llvm::APInt;                  // signed
inline constexpr unsigned kNumberBits = 320;  // of all that is computed here

Number number(std::int64_t value);
Number power(unsigned exponent);
unsigned bits_of(const Number& value);  // as a signed number

struct Range {
  Number low, high;

  bool within(const Range& other) const { return low.sge(other.low) && high.sle(other.high); }
  unsigned bits() const { return std::max(bits_of(low), bits_of(high)); }
  static Range of(unsigned width, bool is_signed);
};

using ValueId = unsigned;
inline constexpr ValueId kNothing = ~0U;

enum class Source : std::uint8_t { kConstant, kState, kInput, kComputed };

struct Value {
  Source source = Source::kComputed;
  unsigned index = 0;  // of the register, the input, the instruction
  Number constant;
  Range range;
};

enum class Form : std::uint8_t { kAll, kWrap, kClamp, kZero, kNegative };

struct Format {
  Form form = Form::kAll;
  unsigned width = 0;
  bool is_signed = false;

  bool is_flag() const { return form == Form::kZero || form == Form::kNegative; }
  bool operator==(const Format&) const = default;
  auto operator<=>(const Format&) const = default;
};

enum class Logic : std::uint8_t { kSum, kAnd, kOr, kXor };

struct Instruction {
  ValueId a = kNothing, b = kNothing;  // none: 0
  ValueId c = kNothing, d = kNothing;  // b is their product
  ValueId entry = kNothing;            // b is the table's, at this address
  ValueId condition = kNothing;        // 1: a, 0: b
  bool unless = false;                 // 1: b, 0: a
  bool negate = false;                 // a + ~b + carry
  bool carry = false;
  Logic logic = Logic::kSum;
  unsigned shift = 0;
  Format format;
  bool invert = false;  // the flag
  ValueId result = kNothing;
  std::string name;

  bool has_product() const { return c != kNothing; }
  bool has_entry() const { return entry != kNothing; }
  // The sum is the result: a reader in the next clock may have it.
  auto key() const {
    return std::tuple(a, b, c, d, entry, condition, unless, negate, carry, logic, shift, format,
                      invert);
  }
  bool is_plain() const { return shift == 0 && format.form == Form::kAll; }
};

struct Program {
  const Module* sample = nullptr;
  unsigned factor = 16, second_factor = 16;  // bits, signed
  std::vector<Value> values;
  std::vector<Instruction> instructions;  // operands before results
  std::vector<ValueId> next;              // per register of the sample
  std::vector<ValueId> outputs;
  std::vector<bool> early;                // per output: made before the others
  std::vector<Number> table;  // all of the sample's, one behind the other
  unsigned word = 2;          // bits of numbers
  unsigned sum = 2;           // bits of their sums

  ValueId constant(const Number& value);
  ValueId emit(Instruction instruction);  // or what does the same already
  // Range of the sum, before shift and format.
  Range sum_range(const Instruction& instruction) const;
  Range second_range(const Instruction& instruction) const;  // of b
  // Makes words and sums wide enough for what is there.
  void measure();
  const Instruction* maker(ValueId value) const;
  // Instructions are about to change.
  void forget() { known_.clear(); }
  Instruction* maker(ValueId value);

 private:
  std::map<decltype(Instruction().key()), ValueId> known_;
};

}  // namespace hlsgen::machine
