// Word registers: keeps the words of the six-step drive, and says which writes the map refuses.
//
// A write to a hole, to a read-only register, to a stopped or keyed one while the motor may turn,
// or to a keyed one behind the closed lock changes nothing and is refused.  Byte strobes count.
// A shadowed word is read back at once, but acts from `boundary` on, and at once while stopped.
//
//     latency      1 clock from a write to the word; the word read and `refused` are of this clock
//     registers    all words, the shadow of the set-point and the lock: 732 bits
//     multipliers  none
//
// Doc: docs/blocks/word_registers.md   Test: tests/hls/word_registers_test.cpp

#pragma once

#include <array>

#include "hls/bus/bus.hpp"
#include "hls/bus/six_step_registers.hpp"

namespace steplock {

class WordRegisters {
 public:
  struct In {
    BusRequest request;
    bool stopped = false;   // stopped and keyed words may change
    bool boundary = false;  // strobe: a PWM period begins
  };

  struct Out {
    Words words;
    UInt<32> data = 0;      // the word register at `request.index`; 0 for all others
    bool hole = false;      // no register stands there
    bool refused = false;   // the map does not allow this write
    bool unlocked = false;  // the lock is open
  };

  Out tick(const In& in) {
    const Rule rule = rule_at(in.request.index);
    const bool allowed = rule == Rule::kOpen || (rule == Rule::kStopped && in.stopped) ||
                         (rule == Rule::kKeyed && in.stopped && unlocked_);
    const Out out{.words = words_,
                  .data = read(in.request.index.slice<5, 0>()),
                  .hole = rule == Rule::kHole,
                  .refused = !allowed,
                  .unlocked = unlocked_};

    if (in.boundary || in.stopped) each<0>([&](auto row) { show<decltype(row)>(); });
    if (in.request.write && allowed) {
      const UInt<32> mask = byte_mask(in.request.strobes);
      each<0>([&](auto row) { write<decltype(row)>(in.request, mask); });
      if (in.request.index == kLock) {
        unlocked_ = (in.request.data & mask).slice<15, 0>() == UInt<16>(kLockKey);
      }
    }
    return out;
  }

 private:
  enum class Rule : std::uint8_t { kHole, kNever, kOpen, kStopped, kKeyed };

  static constexpr int kLock = index_of("LOCK");
  static constexpr int kRegisters = kMapBytes / 4;
  static constexpr int kRows = std::tuple_size_v<decltype(kWordRows)>;

  // What the fields of every address say; a writable one speaks for all.
  static constexpr std::array<Rule, kRegisters> kRules = [] {
    std::array<Rule, kRegisters> rules{};
    for (const Field& f : kFields) {
      Rule& rule = rules[f.address / 4];
      if (f.access == Access::kStopped) {
        rule = Rule::kStopped;
      } else if (f.access == Access::kKeyed) {
        rule = Rule::kKeyed;
      } else if (writable(f.access)) {
        rule = Rule::kOpen;
      } else if (rule == Rule::kHole) {
        rule = Rule::kNever;
      }
    }
    return rules;
  }();
  static Rule rule_at(WordIndex index) {
    return index >= kRegisters ? Rule::kHole : kRules[index.slice<5, 0>().raw()];
  }

  // A row of the table as a type, so that nothing of the table itself remains.
  template <int I>
  struct Row {
    using Word = typename std::tuple_element_t<I, std::remove_cv_t<decltype(kWordRows)>>::Word;
    static constexpr int index = std::get<I>(kWordRows).address / 4;
    static constexpr int lsb = std::get<I>(kWordRows).lsb;
    static constexpr bool shadowed = std::get<I>(kWordRows).access == Access::kShadowed;
  };
  template <int I, class Use>
  static void each(const Use& use) {
    use(Row<I>{});
    if constexpr (I + 1 < kRows) each<I + 1>(use);
  }

  template <class R>
  void show() {
    if constexpr (R::shadowed) R::Word::of(words_) = R::Word::of(staged_);
  }
  template <class R>
  UInt<32> placed() const {
    if constexpr (R::shadowed) {
      return bits_of(R::Word::of(staged_)) << R::lsb;
    } else {
      return bits_of(R::Word::of(words_)) << R::lsb;
    }
  }
  template <class R>
  void write(const BusRequest& request, UInt<32> mask) {
    if (request.index != R::index) return;
    const UInt<32> merged = (request.data & mask) | (placed<R>() & ~mask);
    Words& words = R::shadowed ? staged_ : words_;
    auto& word = R::Word::of(words);
    word = word_of<std::remove_reference_t<decltype(word)>>(merged >> R::lsb);
  }

  // The register at a constant address.
  template <int I, int Index>
  UInt<32> fields() const {
    UInt<32> rest = 0;
    if constexpr (I + 1 < kRows) rest = fields<I + 1, Index>();
    if constexpr (Row<I>::index == Index) rest = rest | placed<Row<I>>();
    return rest;
  }
  // A tree of choices over the address, half of the map at each branch.
  template <int First = 0, int Count = kRegisters>
  UInt<32> read(UInt<6> index) const {
    if constexpr (Count == 1) {
      return fields<0, First>();
    } else {
      constexpr int kHalf = Count / 2;
      const UInt<32> low = read<First, kHalf>(index);
      const UInt<32> high = read<First + kHalf, kHalf>(index);
      return (index & UInt<6>(kHalf)) != UInt<6>(0) ? high : low;
    }
  }

  Words words_;
  Words staged_;  // of shadowed words alone; the others' bits never leave their reset values
  bool unlocked_ = false;
};

}  // namespace steplock
