// Config registers: keeps the configuration of a drive, and says which writes its map refuses.
//
// A write to a hole, to a read-only register, to a stopped or keyed one while the motor may turn,
// or to a keyed one behind the closed lock changes nothing and is refused.  Byte strobes count.
// A shadowed word is read back at once, but acts from `boundary` on, and at once while stopped.
//
// The words act all at once, so each bit has its flip-flop; nothing else reads them.  A read comes from a
// memory that every write goes to as well, which spares a choice among all of them:
//
//     words 0 .. 63     what was written; a flag per register says whether it was since the reset
//     words 64 .. 127   what never changes: the reset values, and those registers that are constants
//
// An iCE40 may write word 0 of a block RAM by itself while it is configured (Yosys issue 101): here
// that is a word which is never read.
//
//     latency      1 clock from a write to the word, and from a read to `data`, which then stays;
//                  `hole` and `refused` are of this clock
//     registers    all words, the shadow of the set-point and the lock: some 800 bits of either map
//     memory       128 words of 32 bits     multipliers  none
//
// Doc: docs/blocks/config_registers.md   Test: tests/hls/config_registers_test.cpp

#pragma once

#include <array>

#include "hls/bus/bus.hpp"
#include "hls/bus/register_map.hpp"
#include "hls/numeric/memory.hpp"

namespace steplock {

// One number for each register of words, the upper half of the map: `bits` of all its fields.
using OfRows = std::array<UInt<32>, kMapBytes / 8>;
template <class Map>
constexpr OfRows of_rows(std::uint32_t (*bits)(const Field&)) {
  OfRows all{};
  const auto add = [&](const Field& f) {
    UInt<32>& one = all[f.address / 4 - kMapBytes / 8];
    one = one | UInt<32>::of(bits(f));
  };
  std::apply([&](const auto&... row) { (add(row), ...); }, Map::kWordRows);
  return all;
}

// What is read back, as it stands before any write: see ConfigRegisters.
template <class Map = SixStep>
struct ConfigMirror {
  using Word = UInt<32>;
  static constexpr int kLanes = 4;  // a byte each
  static constexpr int kRegisters = kMapBytes / 4;
  static constexpr int kLastConstant = index_of<Map>("CAPABILITY");  // behind ID and VERSION

  static constexpr OfRows kResets = of_rows<Map>([](const Field& f) { return f.reset << f.lsb; });
  static constexpr OfRows kFieldBits = of_rows<Map>(mask_of);

  static constexpr std::array<Word, 2 * kRegisters> kWords = [] {
    std::array<Word, 2 * kRegisters> config{};
    const auto add = [&](const Field& f) {
      Word& word = config[kRegisters + f.address / 4];
      word = word | Word::of(f.reset << f.lsb);
    };
    for (int i = 0; i < kRegisters / 2; ++i) config[kRegisters + kRegisters / 2 + i] = kResets[i];
    for (const Field& f : Map::kSystemFields) {
      if (f.address <= 4 * kLastConstant) add(f);
    }
    return config;
  }();
};

template <class Map = SixStep>
class ConfigRegisters {
  using Config = typename Map::Config;
  using Mirror = ConfigMirror<Map>;

 public:
  struct In {
    BusRequest request;
    bool stopped = false;   // stopped and keyed words may change
    bool boundary = false;  // strobe: shadowed words are taken over
  };

  struct Out {
    Config config;
    UInt<32> data = 0;      // answer to the last read: 0 if it was of no register kept here
    bool hole = false;      // no register stands there
    bool refused = false;   // the map does not allow this write
    bool unlocked = false;  // the lock is open
    bool no_period = false;  // with this PWM period the bridge has to stay off
  };

  Out tick(const In& in) {
    const Rule rule = rule_at(in.request.index);
    const bool allowed = rule == Rule::kOpen || (rule == Rule::kStopped && in.stopped) ||
                         (rule == Rule::kKeyed && in.stopped && unlocked_);
    const bool writes = in.request.write && allowed;
    const Out out{.config = config_,
                  .data = mirror(in.request, writes),
                  .hole = rule == Rule::kHole,
                  .refused = !allowed,
                  .unlocked = unlocked_,
                  .no_period = Map::no_period(config_)};

    if (in.boundary || in.stopped) each<0>([&](auto row) { show<decltype(row)>(); });
    if (writes) {
      const UInt<32> mask = byte_mask(in.request.strobes);
      each<0>([&](auto row) { write<decltype(row)>(in.request, mask); });
      if (in.request.index == kLock) {
        unlocked_ = opens(in.request.data & mask);
      }
    }
    return out;
  }

 private:
  enum class Rule : std::uint8_t { kHole, kNever, kOpen, kStopped, kKeyed };

  using Rows = std::remove_cvref_t<decltype(Map::kWordRows)>;
  static constexpr int kLock = index_of<Map>("LOCK");
  static constexpr int kRegisters = Mirror::kRegisters;
  static constexpr int kFirst = kRegisters / 2;  // words stand in the upper half of the map
  static constexpr int kRows = std::tuple_size_v<Rows>;

  // What the fields of every address say; a writable one speaks for all.
  static constexpr std::array<Rule, kRegisters> kRules = [] {
    std::array<Rule, kRegisters> rules{};
    for (const Field& f : Map::kFields) {
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

  static bool opens(UInt<32> key) { return key.slice<15, 0>() == UInt<16>(kLockKey); }

  // A row of the table as a type, so that nothing of the table itself remains.
  template <int I>
  struct Row {
    using Word = typename std::tuple_element_t<I, Rows>::Word;
    static constexpr int index = std::get<I>(Map::kWordRows).address / 4;
    static constexpr int lsb = std::get<I>(Map::kWordRows).lsb;
    static constexpr bool shadowed = std::get<I>(Map::kWordRows).access == Access::kShadowed;
  };
  template <int I, class Use>
  static void each(const Use& use) {
    use(Row<I>{});
    if constexpr (I + 1 < kRows) each<I + 1>(use);
  }

  template <class R>
  void show() {
    if constexpr (R::shadowed) R::Word::of(config_) = R::Word::of(staged_);
  }
  template <class R>
  UInt<32> placed() const {
    if constexpr (R::shadowed) {
      return bits_of(R::Word::of(staged_)) << R::lsb;
    } else {
      return bits_of(R::Word::of(config_)) << R::lsb;
    }
  }
  template <class R>
  void write(const BusRequest& request, UInt<32> mask) {
    if (request.index != R::index) return;
    const UInt<32> merged = (request.data & mask) | (placed<R>() & ~mask);
    Config& config = R::shadowed ? staged_ : config_;
    auto& word = R::Word::of(config);
    word = word_of<std::remove_reference_t<decltype(word)>>(merged >> R::lsb);
  }

  // Writes and reads the memory, and gives the answer to the last read.  The first write since the
  // reset is of all four bytes: those without a strobe get their reset values.
  UInt<32> mirror(const BusRequest& request, bool writes) {
    const auto place = request.index.slice<5, 0>();
    const auto row = place.slice<4, 0>().raw();
    const bool fresh = !(place.bit(5) && (written_ >> int(row)).bit(0));
    if (writes && place.bit(5)) written_ = written_ | (UInt<kRegisters - kFirst>(1) << int(row));
    const UInt<32> mask = byte_mask(request.strobes);
    const UInt<32> data = request.data & mask & Mirror::kFieldBits[row];
    const UInt<4> lanes = fresh ? UInt<4>::max() : request.strobes;
    const auto word = mirror_.tick(
        {.read = request.read,
         .address = UInt<7>(place) | (fresh ? UInt<7>(kRegisters) : UInt<7>(0)),
         .write = writes ? lanes : UInt<4>(0),
         .write_address = place,
         .write_data = data | (Mirror::kResets[row] & ~mask)});
    const UInt<32> shown = shows_ ? word.data : UInt<32>(0);
    if (request.read) shows_ = request.index < kRegisters;
    return shown;
  }

  Config config_;
  Config staged_;  // of shadowed words alone; the others' bits never leave their reset values
  bool unlocked_ = false;
  Memory<Mirror> mirror_;
  UInt<kRegisters - kFirst> written_ = 0;  // a bit for each register of words, since the reset
  bool shows_ = false;  // the last read was of the map
};

}  // namespace steplock
