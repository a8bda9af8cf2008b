// What each clock of a program does, as words of a memory: the fields are those that the datapath of
// machine/build reads, each in the clock in which it is used.
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/machine/fields.hpp"
#include "generator/machine/order.hpp"

#include <map>

namespace hlsgen::machine {

enum Bank : unsigned { kA, kB, kC, kD, kBanks };                          // copies of the numbers
enum Second : unsigned { kProduct, kOfResult, kOfPort, kOfTable };        // field b_from
enum Test : unsigned { kEarly, kResultBit, kSumSign, kPortBit };          // field test

class Code {
 public:
  Code(const Program& p, const Order& order);

  bool has_bank(unsigned bank) const {
    return bank < kC || has_products || (bank == kC && has_conditions);
  }

  // What the program has need of.
  bool has_products = false, has_entries = false, has_conditions = false, has_logic = false;
  unsigned most_shift = 0;
  unsigned address = 1;  // bits
  std::vector<Format> formats;
  std::vector<unsigned> inputs;               // of the sample, read through the port
  std::vector<ValueId> groups;                // outputs with one value
  std::map<ValueId, std::size_t> group_of;    // from 1

  Fields fields;
  unsigned read[kBanks] = {}, old[kBanks] = {};
  unsigned port = 0, factor_result = 0, factor_port = 0, a_on = 0, a_new = 0, a_sum = 0;
  unsigned b_on = 0, b_new = 0, b_from = 0, negate = 0, carry = 0, test_on = 0, test = 0, unless = 0;
  unsigned logic = 0, shift = 0, format = 0, invert = 0, write = 0, to = 0, show = 0;

 private:
  const Value& value(ValueId v) const { return p_.values[v]; }
  void look();
  void make_fields();
  void read_number(unsigned word, unsigned bank, ValueId v);
  void read_port(unsigned word, ValueId v);
  void encode();
  void encode_second(const Instruction& i, const Place& place, unsigned sum);
  void encode_condition(const Instruction& i, const Place& place, unsigned sum);

  const Program& p_;
  const Order& order_;
};

}  // namespace hlsgen::machine
