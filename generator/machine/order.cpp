#include "generator/machine/order.hpp"

#include "generator/machine/cells.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace hlsgen::machine {
namespace {

enum class Role : std::uint8_t { kA, kB, kC, kD, kEntry, kCondition };

struct Use {
  Role role;
  ValueId value;
};

std::vector<Use> uses_of(const Instruction& i) {
  std::vector<Use> uses;
  const auto add = [&](Role role, ValueId v) {
    if (v != kNothing) uses.push_back({role, v});
  };
  add(Role::kA, i.a);
  add(Role::kB, i.b);
  add(Role::kC, i.c);
  add(Role::kD, i.d);
  add(Role::kEntry, i.entry);
  add(Role::kCondition, i.condition);
  return uses;
}

// How a number made in clock `made` comes to a reader in clock `now`.
Way way_of(Role role, const Instruction& maker, unsigned made, unsigned now) {
  const unsigned after = now - made;
  switch (role) {
    case Role::kA:
      if (after == 1 && maker.is_plain()) return Way::kSum;
      return after == 2 ? Way::kResult : after >= 4 ? Way::kMemory : Way::kNone;
    case Role::kB:
      return after == 2 ? Way::kResult : after >= 4 ? Way::kMemory : Way::kNone;
    case Role::kC:
      return after == 3 ? Way::kResult : after >= 5 ? Way::kMemory : Way::kNone;
    case Role::kD:
      return after >= 5 ? Way::kMemory : Way::kNone;
    case Role::kEntry:
      return after == 3 ? Way::kResult : Way::kNone;
    case Role::kCondition:
      if (after == 1 && maker.format.form == Form::kNegative) return Way::kSum;
      return after == 2 || after == 3 ? Way::kResult : after >= 5 ? Way::kMemory : Way::kNone;
  }
  return Way::kNone;
}

unsigned soonest(Role role, const Instruction& maker) {
  for (unsigned after = 1;; ++after)
    if (way_of(role, maker, 0, after) != Way::kNone) return after;
}

class Ordering {
 public:
  explicit Ordering(Program& p) : p_(p), writer_(p.next.size(), kNothing) {}

  Order run() {
    give_writers();
    collect();
    rank();
    schedule();
    find_ways();
    give_cells(p_, writer_, last_read_, out_);
    return std::move(out_);
  }

 private:
  unsigned size() const { return static_cast<unsigned>(p_.instructions.size()); }
  const Instruction& at(unsigned i) const { return p_.instructions[i]; }
  bool is_state(ValueId v, unsigned r) const {
    return p_.values[v].source == Source::kState && p_.values[v].index == r;
  }
  bool reads(unsigned i, unsigned r) const {
    for (const Use& use : uses_of(at(i)))
      if (is_state(use.value, r)) return true;
    return false;
  }

  unsigned move(ValueId v) {
    Instruction i;
    (p_.values[v].source == Source::kInput ? i.b : i.a) = v;
    p_.forget();  // each is one of its own
    p_.emit(i);
    return size() - 1;
  }

  // Who writes each register: the instruction that makes the number, if no reader of the old value
  // waits for it; else one that moves it.
  void give_writers() {
    std::set<unsigned> taken;
    for (unsigned r = 0; r < p_.next.size(); ++r) {
      const Value& v = p_.values[p_.next[r]];
      // An entry comes when its address says, not when it may be written.
      const bool direct = v.source == Source::kComputed && !at(v.index).has_entry() &&
                          taken.insert(v.index).second;
      writer_[r] = direct ? v.index : move(p_.next[r]);
    }
    for (unsigned r = 0; r < p_.next.size(); ++r) {
      if (!waits_for_itself(r)) continue;
      if (p_.values[p_.next[r]].source == Source::kComputed) {
        writer_[r] = move(p_.next[r]);
        if (!waits_for_itself(r)) continue;
      }
      const ValueId early = at(writer_[r]).result;
      writer_[r] = move(early);
    }
  }

  bool waits_for_itself(unsigned r) const {
    std::vector<bool> seen(size(), false);
    std::vector<unsigned> todo{writer_[r]};
    std::vector<std::vector<unsigned>> readers(p_.values.size());
    for (unsigned i = 0; i < size(); ++i)
      for (const Use& use : uses_of(at(i))) readers[use.value].push_back(i);
    while (!todo.empty()) {
      const unsigned i = todo.back();
      todo.pop_back();
      const auto go = [&](unsigned to) {
        if (!seen[to]) todo.push_back(to);
        seen[to] = true;
      };
      for (const unsigned reader : readers[at(i).result]) go(reader);
      for (const Use& use : uses_of(at(i))) {
        const Value& v = p_.values[use.value];
        if (v.source == Source::kState && writer_[v.index] != i) go(writer_[v.index]);
      }
    }
    for (unsigned i = 0; i < size(); ++i)
      if (seen[i] && (i == writer_[r] || reads(i, r))) return true;
    return false;
  }

  void collect() {
    out_.places.resize(size());
    before_.resize(size());
    after_.resize(size());
    entry_of_.assign(size(), kNothing);
    for (unsigned i = 0; i < size(); ++i) {
      for (const Use& use : uses_of(at(i))) {
        const Value& v = p_.values[use.value];
        if (v.source == Source::kComputed) {
          const unsigned least = soonest(use.role, at(v.index));
          after_[v.index].push_back({i, least});
          if (use.role == Role::kEntry) entry_of_[v.index] = i;
        }
        if (v.source == Source::kState && writer_[v.index] != i) {
          before_[writer_[v.index]].push_back(i);
          after_[i].push_back({writer_[v.index], 1});
        }
      }
    }
  }

  // Ranks of what early outputs wait for begin above all others.
  void rank() {
    std::vector<bool> early(size(), false);
    for (std::size_t o = 0; o < p_.outputs.size(); ++o)
      if (p_.early[o]) early[p_.values[p_.outputs[o]].index] = true;
    rank_.assign(size(), kNothing);
    for (unsigned i = 0; i < size(); ++i) rank_of(i, {});
    for (unsigned i = 0; i < size(); ++i) out_.bound = std::max(out_.bound, rank_[i]);
    rank_.assign(size(), kNothing);
    for (unsigned i = 0; i < size(); ++i) rank_of(i, early);
  }
  unsigned rank_of(unsigned i, const std::vector<bool>& early) {
    if (rank_[i] != kNothing) return rank_[i];
    unsigned rank = !early.empty() && early[i] ? kEarly : 0;
    for (const auto& [to, least] : after_[i]) rank = std::max(rank, rank_of(to, early) + least);
    return rank_[i] = rank;
  }

  // Clocks before the sum in which the port is read; 0: not at all.
  unsigned port_lead(const Instruction& i) const {
    const auto is_input = [&](ValueId v) {
      return v != kNothing && p_.values[v].source == Source::kInput;
    };
    return is_input(i.b) || is_input(i.condition) ? 1 : is_input(i.d) ? 2 : 0;
  }

  bool is_ready(unsigned i, unsigned now) const {
    const Instruction& instruction = at(i);
    if (instruction.has_entry()) return false;  // comes with its address
    const bool early = instruction.has_product() || instruction.condition != kNothing;  // reads
    if (now < (early ? kFirst + 1 : kFirst)) return false;
    for (const unsigned reader : before_[i])
      if (out_.places[reader].clock == 0) return false;
    for (const Use& use : uses_of(instruction)) {
      const Value& v = p_.values[use.value];
      if (v.source != Source::kComputed) continue;
      const unsigned made = out_.places[v.index].clock;
      if (made == 0 || way_of(use.role, at(v.index), made, now) == Way::kNone) return false;
    }
    const unsigned lead = port_lead(instruction);
    if (lead != 0 && ports_.count(now - lead) != 0) return false;
    return entry_of_[i] == kNothing || reserved_.count(now + 3) == 0;
  }

  void take(unsigned i, unsigned now) {
    out_.places[i].clock = now;
    const unsigned lead = port_lead(at(i));
    if (lead != 0) ports_.insert(now - lead);
    if (entry_of_[i] != kNothing) reserved_[now + 3] = entry_of_[i];
  }

  void schedule() {
    std::vector<unsigned> waiting(size());
    for (unsigned i = 0; i < size(); ++i) waiting[i] = i;
    std::stable_sort(waiting.begin(), waiting.end(),
                     [&](unsigned x, unsigned y) { return rank_[x] > rank_[y]; });
    unsigned now = kFirst;
    for (; !waiting.empty(); ++now) {
      auto chosen = waiting.end();
      if (const auto entry = reserved_.find(now); entry != reserved_.end()) {
        chosen = std::find(waiting.begin(), waiting.end(), entry->second);
      } else {
        chosen = std::find_if(waiting.begin(), waiting.end(),
                              [&](unsigned i) { return is_ready(i, now); });
      }
      if (chosen == waiting.end()) continue;
      take(*chosen, now);
      waiting.erase(chosen);
    }
    // Written in the clock after the next, then shown.
    out_.clocks = now - 1 + 4;
    out_.bound += kFirst + 4;
    for (std::size_t o = 0; o < p_.outputs.size(); ++o)
      if (p_.early[o])
        out_.early = std::max(out_.early, out_.places[p_.values[p_.outputs[o]].index].clock + 4);
  }

  void find_ways() {
    for (unsigned i = 0; i < size(); ++i) {
      Place& place = out_.places[i];
      for (const Use& use : uses_of(at(i))) {
        const Value& v = p_.values[use.value];
        Way way = v.source == Source::kInput ? Way::kPort : Way::kMemory;
        unsigned distance = 0;
        if (v.source == Source::kComputed) {
          distance = place.clock - out_.places[v.index].clock;
          way = way_of(use.role, at(v.index), out_.places[v.index].clock, place.clock);
        }
        switch (use.role) {
          case Role::kA: place.a = way; break;
          case Role::kB: place.b = way; break;
          case Role::kC: place.c = way; break;
          case Role::kD: place.d = way; break;
          case Role::kEntry: break;
          case Role::kCondition:
            place.condition = way;
            place.condition_early = way == Way::kMemory || distance == 3;
            break;
        }
        if (way != Way::kMemory) continue;
        const bool early = use.role != Role::kA && use.role != Role::kB;
        last_read_.resize(p_.values.size(), 0);
        last_read_[use.value] = std::max(last_read_[use.value], place.clock - (early ? 2 : 1));
      }
    }
    last_read_.resize(p_.values.size(), 0);
  }

  static constexpr unsigned kFirst = 2;  // the first clock that finds its operands read
  static constexpr unsigned kEarly = 1U << 20;  // more clocks than any program has

  Program& p_;
  Order out_;
  std::vector<unsigned> writer_;                // per register, an instruction
  std::vector<std::vector<unsigned>> before_;   // readers of the old value
  std::vector<std::vector<std::pair<unsigned, unsigned>>> after_;
  std::vector<unsigned> entry_of_;  // the reader of the table at this address
  std::vector<unsigned> rank_;
  std::set<unsigned> ports_;
  std::map<unsigned, unsigned> reserved_;
  std::vector<unsigned> last_read_;  // per value
};

}  // namespace

Order order(Program& program) { return Ordering(program).run(); }

}  // namespace hlsgen::machine
