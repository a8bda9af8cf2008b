#include "generator/machine/fuse.hpp"

#include <algorithm>
#include <map>

namespace hlsgen::machine {
namespace {

template <class Visit>
void for_operands(Instruction& i, const Visit& visit) {
  for (ValueId* operand : {&i.a, &i.b, &i.c, &i.d, &i.entry, &i.condition})
    if (*operand != kNothing) visit(*operand);
}

class Fusing {
 public:
  explicit Fusing(Program& p) : p_(p), uses_(p.values.size(), 0) {
    for (Instruction& i : p_.instructions) for_operands(i, [&](ValueId v) { ++uses_[v]; });
    for (const ValueId v : p_.next) ++uses_[v];
    for (const ValueId v : p_.outputs) ++uses_[v];
  }

  void run() {
    p_.forget();
    for (Instruction& i : p_.instructions)
      for (bool again = true; again;) {
        drop_zeros(i);
        again = take_product(i) || take_cut(i) || give_constant(i);
      }
    remove_unread();
  }

 private:
  bool is_constant(ValueId v) const {
    return v != kNothing && p_.values[v].source == Source::kConstant;
  }
  bool is_zero(ValueId v) const { return is_constant(v) && p_.values[v].constant == 0; }
  static bool is_sum(const Instruction& i) {
    return i.condition == kNothing && i.logic == Logic::kSum;
  }
  void unread(ValueId v) {
    if (v != kNothing) --uses_[v];
  }
  void read(Instruction& i) {
    for_operands(i, [&](ValueId v) { ++uses_[v]; });
  }

  void drop_zeros(Instruction& i) {
    if (!is_sum(i)) return;
    if (is_zero(i.a)) unread(std::exchange(i.a, kNothing));
    if (is_zero(i.b) && i.negate == i.carry) {
      unread(std::exchange(i.b, kNothing));
      i.negate = i.carry = false;
    }
    if (i.a == kNothing && !i.negate && i.b != kNothing) std::swap(i.a, i.b);
  }

  // A product that nobody but sums reads is made where it is read.
  bool take_product(Instruction& i) {
    if (!is_sum(i) || i.has_product() || i.has_entry()) return false;
    const auto takes = [&](ValueId& from) {
      if (from == kNothing) return false;
      const Instruction* made = p_.maker(from);
      if (made == nullptr || !made->has_product() || !made->is_plain() || made->a != kNothing ||
          made->negate || made->carry)
        return false;
      unread(from);
      from = kNothing;
      i.c = made->c;
      i.d = made->d;
      ++uses_[i.c];
      ++uses_[i.d];
      return true;
    };
    if (takes(i.b)) return true;
    if (i.negate || !takes(i.a)) return false;
    i.a = i.b;
    i.b = kNothing;
    return true;
  }

  // Shift, cut and flag of the only reader become those of the sum.
  bool take_cut(Instruction& i) {
    const bool only_cuts = is_sum(i) && i.a != kNothing && i.b == kNothing && !i.has_product() &&
                           !i.has_entry() && !i.negate && !i.carry;
    if (!only_cuts || uses_[i.a] != 1) return false;
    Instruction* made = p_.maker(i.a);
    if (made == nullptr) return false;
    Format format = i.format;
    const Format& before = made->format;
    if (i.format.is_flag()) {
      if (!made->is_plain()) return false;
    } else if (before.form == Form::kWrap) {
      if (i.format.form == Form::kAll && i.shift < before.width) {
        format = {Form::kWrap, before.width - i.shift, before.is_signed};
      } else if (i.format.form != Form::kWrap || i.shift + i.format.width > before.width) {
        return false;
      }
    } else if (before.form != Form::kAll) {
      return false;
    }
    replace(i, *made, format);
    return true;
  }

  void replace(Instruction& i, Instruction& made, const Format& format) {
    Instruction merged = made;
    unread(i.a);
    merged.shift += i.shift;
    merged.format = format;
    merged.invert = i.invert;
    merged.result = i.result;
    if (!i.name.empty()) merged.name = i.name;
    i = merged;
    read(i);  // the one that it replaces still counts until it is removed; it is never looked at
    for_operands(made, [&](ValueId v) { --uses_[v]; });
    made = gone(made.result);
  }
  static Instruction gone(ValueId result) {
    Instruction none;
    none.result = result;
    return none;
  }

  // (p + q) + constant: the constant goes where there is room for it, in p.
  bool give_constant(Instruction& i) {
    if (!is_sum(i) || i.negate || i.carry || i.has_product() || i.has_entry()) return false;
    if (is_constant(i.a)) std::swap(i.a, i.b);
    if (!is_constant(i.b) || i.a == kNothing || uses_[i.a] != 1) return false;
    Instruction* sum = p_.maker(i.a);
    if (sum == nullptr || !is_sum(*sum) || !sum->is_plain() || sum->a == kNothing) return false;
    if (sum->b == kNothing && !sum->has_product()) return false;
    for (const ValueId part : {sum->a, sum->negate ? kNothing : sum->b}) {
      if (part == kNothing || uses_[part] != 1) continue;
      Instruction* room = p_.maker(part);
      if (room == nullptr || room->a != kNothing || !room->is_plain() || !is_sum(*room)) continue;
      room->a = std::exchange(i.b, kNothing);
      const Range range = p_.sum_range(*room);
      p_.values[room->result].range = range;
      p_.values[sum->result].range = p_.sum_range(*sum);
      return true;  // what is left of the sum only cuts
    }
    return false;
  }

  void remove_unread() {
    std::vector<bool> read(p_.values.size(), false);
    for (const ValueId v : p_.next) read[v] = true;
    for (const ValueId v : p_.outputs) read[v] = true;
    for (std::size_t k = p_.instructions.size(); k-- > 0;)
      if (read[p_.instructions[k].result])
        for_operands(p_.instructions[k], [&](ValueId v) { read[v] = true; });
    std::vector<Instruction> kept;
    for (Instruction& i : p_.instructions) {
      if (!read[i.result]) continue;
      p_.values[i.result].index = static_cast<unsigned>(kept.size());
      kept.push_back(std::move(i));
    }
    p_.instructions = std::move(kept);
  }

  Program& p_;
  std::vector<unsigned> uses_;
};

class Legalising {
 public:
  explicit Legalising(Program& p) : p_(p) {}

  void run() {
    std::vector<Instruction> before;
    before.swap(p_.instructions);
    p_.forget();
    for (Instruction& i : before) {
      place_inputs(i);
      if (i.has_entry()) place_address(i);
      append(i);
    }
    for (ValueId& v : p_.outputs) v = computed(v);
  }

 private:
  bool is_input(ValueId v) const {
    return v != kNothing && p_.values[v].source == Source::kInput;
  }

  void append(Instruction i) {
    p_.values[i.result].index = static_cast<unsigned>(p_.instructions.size());
    p_.instructions.push_back(std::move(i));
  }

  ValueId copy(ValueId v) {
    Instruction i;
    (is_input(v) ? i.b : i.a) = v;
    return p_.emit(i);
  }
  ValueId copy_of_input(ValueId v) {
    const auto [known, is_new] = copies_.try_emplace(v, kNothing);
    if (is_new) known->second = copy(v);
    return known->second;
  }
  void off_port(ValueId& v) {
    if (is_input(v)) v = copy_of_input(v);
  }

  void place_inputs(Instruction& i) {
    if (i.has_product()) {
      off_port(i.a);
      const auto fits = [&](ValueId v, unsigned bits) { return p_.values[v].range.bits() <= bits; };
      if (is_input(i.c) && !is_input(i.d) && fits(i.c, p_.second_factor) && fits(i.d, p_.factor))
        std::swap(i.c, i.d);
      off_port(i.c);
    } else if (is_input(i.a) && !is_input(i.b) && !i.has_entry()) {
      exchange(i);
    }
    off_port(i.a);
    off_port(i.entry);
    if (is_input(i.b) || is_input(i.d)) off_port(i.condition);
  }

  // The same from b and a.
  void exchange(Instruction& i) {
    if (i.condition != kNothing) {
      if (i.negate) return;
      i.unless = !i.unless;
    } else if (i.negate && i.format.form == Form::kNegative) {  // a < b: not b <= a
      i.carry = !i.carry;
      i.invert = !i.invert;
    } else if (i.negate && !(i.format.form == Form::kZero && i.carry)) {
      return;
    }
    std::swap(i.a, i.b);
  }

  // One that makes this address and no other.
  void place_address(Instruction& i) {
    const bool taken = p_.maker(i.entry) == nullptr || !addresses_.insert({i.entry, true}).second;
    if (taken) i.entry = copy(i.entry);
    addresses_.insert({i.entry, true});
  }

  // An output is loaded from what the datapath has made.
  ValueId computed(ValueId v) {
    if (p_.values[v].source == Source::kComputed) return v;
    if (is_input(v)) return copy_of_input(v);
    const auto [known, is_new] = copies_.try_emplace(v, kNothing);
    if (is_new) known->second = copy(v);
    return known->second;
  }

  Program& p_;
  std::map<ValueId, ValueId> copies_;
  std::map<ValueId, bool> addresses_;
};

}  // namespace

void fuse(Program& program) { Fusing(program).run(); }
void legalise(Program& program) { Legalising(program).run(); }

}  // namespace hlsgen::machine
