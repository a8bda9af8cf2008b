#include "generator/machine/code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace hlsgen::machine {

Code::Code(const Program& p, const Order& order) : fields(order.clocks), p_(p), order_(order) {
  look();
  make_fields();
  encode();
}

// What the program has need of.
void Code::look() {
  std::set<unsigned> used;
  for (const Instruction& i : p_.instructions) {
    has_products |= i.has_product();
    has_entries |= i.has_entry();
    has_conditions |= i.condition != kNothing;
    has_logic |= i.logic != Logic::kSum;
    most_shift = std::max(most_shift, i.shift);
    if (std::find(formats.begin(), formats.end(), i.format) == formats.end())
      formats.push_back(i.format);
    for (const ValueId v : {i.b, i.d, i.condition})
      if (v != kNothing && value(v).source == Source::kInput) used.insert(value(v).index);
  }
  std::sort(formats.begin(), formats.end());
  inputs.assign(used.begin(), used.end());
  for (const ValueId v : p_.outputs)
    if (group_of.try_emplace(v, group_of.size() + 1).second) groups.push_back(v);
  address = bits_for(order_.cells);
}

void Code::make_fields() {
  for (unsigned bank = kA; bank < kBanks; ++bank) {
    read[bank] = fields.add(fmt::format("read{}", "abcd"[bank]), address);
    old[bank] = fields.add(fmt::format("old{}", "abcd"[bank]), 1);
  }
  port = fields.add("port", bits_for(inputs.size()));
  factor_result = fields.add("factor_result", 1);
  factor_port = fields.add("factor_port", 1);
  a_on = fields.add("a_on", 1);
  a_new = fields.add("a_new", 1);
  a_sum = fields.add("a_sum", 1);
  b_on = fields.add("b_on", 1);
  b_new = fields.add("b_new", 1);
  b_from = fields.add("b_from", 2);
  negate = fields.add("negate", 1);
  carry = fields.add("carry", 1);
  test_on = fields.add("test_on", 1);
  test = fields.add("test", 2);
  unless = fields.add("unless", 1);
  if (has_logic) logic = fields.add("logic", 2);
  shift = fields.add("shift", bits_for(most_shift + 1));
  format = fields.add("format", bits_for(formats.size()));
  invert = fields.add("invert", 1);
  write = fields.add("write", 1);
  to = fields.add("to", address);
  show = fields.add("show", bits_for(groups.size() + 1));
}

void Code::read_number(unsigned word, unsigned bank, ValueId v) {
  fields.set(word, read[bank], *order_.cell_of[v]);
  if (value(v).source == Source::kState) fields.set(word, old[bank], 1);
}
void Code::read_port(unsigned word, ValueId v) {
  const auto at = std::lower_bound(inputs.begin(), inputs.end(), value(v).index);
  fields.set(word, port, static_cast<std::uint64_t>(at - inputs.begin()));
}

// The word of clock t stands at t - 1.
void Code::encode() {
  for (std::size_t k = 0; k < p_.instructions.size(); ++k) {
    const Instruction& i = p_.instructions[k];
    const Place& place = order_.places[k];
    const unsigned sum = place.clock - 1;
    if (i.a != kNothing) {
      fields.set(sum, a_on, 1);
      if (place.a == Way::kMemory) read_number(sum - 1, kA, i.a);
      if (place.a != Way::kMemory) fields.set(sum, a_new, 1);
      if (place.a == Way::kSum) fields.set(sum, a_sum, 1);
    }
    encode_second(i, place, sum);
    if (i.negate) fields.set(sum, negate, 1);
    if (i.carry) fields.set(sum, carry, 1);
    if (i.condition != kNothing) encode_condition(i, place, sum);
    if (i.logic != Logic::kSum) fields.set(sum, logic, static_cast<unsigned>(i.logic));
    fields.set(sum + 1, shift, i.shift);
    const auto which = std::lower_bound(formats.begin(), formats.end(), i.format);
    fields.set(sum + 1, format, static_cast<std::uint64_t>(which - formats.begin()));
    if (i.invert) fields.set(sum + 1, invert, 1);
    if (place.written) {
      fields.set(sum + 2, write, 1);
      fields.set(sum + 2, to, *place.written);
    }
    const auto group = group_of.find(i.result);
    if (group != group_of.end()) fields.set(sum + 2, show, group->second);
  }
}

void Code::encode_second(const Instruction& i, const Place& place, unsigned sum) {
  const auto from = [&](Second second) {
    fields.set(sum, b_on, 1);
    fields.set(sum, b_new, 1);
    fields.set(sum, b_from, second);
  };
  if (i.has_product()) {
    from(kProduct);
    if (place.c == Way::kMemory) read_number(sum - 2, kC, i.c);
    if (place.c == Way::kResult) fields.set(sum - 1, factor_result, 1);
    if (place.d == Way::kMemory) read_number(sum - 2, kD, i.d);
    if (place.d == Way::kPort) {
      read_port(sum - 2, i.d);
      fields.set(sum - 1, factor_port, 1);
    }
  } else if (i.has_entry()) {
    from(kOfTable);
  } else if (place.b == Way::kMemory) {
    fields.set(sum, b_on, 1);
    read_number(sum - 1, kB, i.b);
  } else if (place.b == Way::kResult) {
    from(kOfResult);
  } else if (place.b == Way::kPort) {
    from(kOfPort);
    read_port(sum - 1, i.b);
  }
}

void Code::encode_condition(const Instruction& i, const Place& place, unsigned sum) {
  fields.set(sum, test_on, 1);
  bool turned = i.unless;
  if (place.condition_early) {
    fields.set(sum, test, kEarly);
    if (place.condition == Way::kMemory) read_number(sum - 2, kC, i.condition);
    if (place.condition == Way::kResult) fields.set(sum - 1, factor_result, 1);
  } else if (place.condition == Way::kPort) {
    fields.set(sum, test, kPortBit);
    read_port(sum - 1, i.condition);
  } else if (place.condition == Way::kSum) {
    fields.set(sum, test, kSumSign);
    turned = turned != p_.maker(i.condition)->invert;
  } else {
    fields.set(sum, test, kResultBit);
  }
  if (turned) fields.set(sum, unless, 1);
}

}  // namespace hlsgen::machine
