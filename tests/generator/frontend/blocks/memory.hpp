// Test blocks with a memory: one that keeps what it owes to it over a reset, one that does not.

#pragma once

#include <array>

#include "hls/numeric/memory.hpp"

namespace steplock::test {

struct Pages {
  using Word = UInt<12>;
  static constexpr int kLanes = 3;
  static constexpr std::array<Word, 16> kWords = [] {
    std::array<Word, 16> words{};
    for (int i = 0; i < 16; ++i) words[i] = Word(i * i * 17);
    return words;
  }();
};

struct NotebookIn {
  bool write = false;
  bool read = false;
  UInt<3> place = 0;
  UInt<3> lanes = 0;
  UInt<12> data = 0;
  template <class F>
  void each(F f) {
    f(write), f(read), f(place), f(lanes), f(data);
  }
};

// Reads pages 0 to 7 until they are written, then 8 to 15.
class Notebook {
 public:
  using In = NotebookIn;
  struct Out {
    UInt<12> data = 0;
    template <class F>
    void each(F f) {
      f(data);
    }
  };

  Out tick(const In& in) {
    const bool fresh = !written_[in.place.raw()];
    const auto lanes = fresh ? UInt<3>(7) : in.lanes;
    const auto pages = pages_.tick({.read = in.read,
                                    .address = UInt<4>(in.place) | UInt<4>(fresh ? 0 : 8),
                                    .write = in.write ? lanes : UInt<3>(0),
                                    .write_address = UInt<4>(in.place) | UInt<4>(8),
                                    .write_data = in.data});
    const Out out{shows_ ? pages.data : UInt<12>(0)};
    if (in.read) shows_ = true;
    if (in.write) written_[in.place.raw()] = true;
    return out;
  }

 private:
  Memory<Pages> pages_;
  std::array<bool, 8> written_{};
  bool shows_ = false;
};

struct Leaves {
  using Word = UInt<12>;
  static constexpr int kLanes = 1;
  static constexpr std::array<Word, 8> kWords{};
};

// Forgets nothing over a reset.
class Elephant {
 public:
  using In = NotebookIn;
  using Out = Notebook::Out;

  Out tick(const In& in) {
    const auto leaves = leaves_.tick({.read = in.read,
                                      .address = in.place,
                                      .write = UInt<1>(in.write ? 1 : 0),
                                      .write_address = in.place,
                                      .write_data = in.data});
    const Out out{shows_ ? leaves.data : UInt<12>(0)};
    if (in.read) shows_ = true;
    return out;
  }

 private:
  Memory<Leaves> leaves_;
  bool shows_ = false;
};

}  // namespace steplock::test
