// A memory: many words, of which one is read and one written in a clock.  It becomes block RAM.
//
//     struct Squares {                         // what it holds from the start, and its module's name
//       using Word = UInt<8>;
//       static constexpr int kLanes = 1;       // parts of a word that are written each by itself
//       static constexpr std::array<Word, 16> kWords = ...;  // 2, 4, 8 ... words
//     };
//     Memory<Squares> squares_;                // a member, ticked once a clock as any other block
//
//     latency    1 clock from `read` to `data`, which then stays until the next read
//
// A block RAM has no reset.  Its words outlast one, and so does `data`; the class below begins anew
// instead.  A block that has a memory owes to its own reader that the difference never shows:
//
//     - `data` is not shown between a reset and the first read after it;
//     - a word is not shown that was written before the reset: keep a flag per word, say, or write
//       other words than those that are read before any write.
//
// It does not read a word in the clock in which it writes that word either: what comes then differs
// from device to device.  (Here, and in simulation, it is the old word.)
//
// Doc: docs/generator.md   Test: tests/generator/frontend/memory_test.cpp

#pragma once

#include <array>
#include <cstddef>

#include "hls/numeric/bits.hpp"

namespace steplock {

template <class Contents>
class Memory {
  static constexpr int address_width() {
    int width = 0;
    while ((std::size_t{1} << width) < Contents::kWords.size()) ++width;
    return width;
  }

 public:
  using Word = typename Contents::Word;
  static constexpr int kLanes = Contents::kLanes;
  using Address = UInt<address_width()>;
  using Lanes = UInt<kLanes>;

  static_assert(Contents::kWords.size() == std::size_t{1} << address_width(), "2, 4, 8 ... words");
  static_assert(Word::width % kLanes == 0, "lanes of one width");

  struct In {
    bool read = false;          // `data` becomes the word at `address`; else it stays
    Address address = 0;
    Lanes write = 0;            // parts of the word at `write_address` that change
    Address write_address = 0;
    Word write_data = 0;
  };

  struct Out {
    Word data = 0;  // the word that was read last
  };

  Out tick(const In& in) {
    const Out out{data_};
    if (in.read) data_ = config_[in.address.raw()];
    Word& word = config_[in.write_address.raw()];
    constexpr int kLane = Word::width / kLanes;
    for (int lane = 0; lane < kLanes; ++lane) {
      const Word mask = Word::of(UInt<kLane>::max().raw()) << lane * kLane;
      if (in.write.bit(lane)) word = (word & ~mask) | (in.write_data & mask);
    }
    return out;
  }

 private:
  std::array<Word, Contents::kWords.size()> config_ = Contents::kWords;
  Word data_ = 0;
};

}  // namespace steplock
