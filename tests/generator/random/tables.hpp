// Constant tables of a random block: of several types, two or three of one name and length but of
// different widths, one of structs, one of two indices.  Ports and registers have an entry added.
//
//     template <int W> struct Shape { static constexpr std::array<UInt<W>, 5> kShape = {...}; };
//     y0 = wrap<UInt<8>>(y0 + wrap<UInt<8>>(Shape<9>::kShape[wrap<UInt<2>>(in.x0).raw()]));

#pragma once

#include "tests/generator/random/statements.hpp"

namespace hlsgen::test {

class Tables : public Statements {
 public:
  // Drawn by themselves: what else the seed gives stays as it is without them.
  explicit Tables(std::uint64_t seed) : Statements(seed), own_(seed + 4'000'000'000) {}

 protected:
  // Statements for the end of the tick, and the members that they read.
  std::string reads_of_tables();
  const std::string& tables() const { return members_; }

 private:
  void draw_shapes(int count);
  void draw_rows(int count);
  std::string entries(int count, int least, int most);
  std::string place(int count);

  Draw own_;
  std::string members_;
  std::vector<Array> tables_;
};

}  // namespace hlsgen::test
