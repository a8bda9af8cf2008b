// A random block, and the group that holds many as its members.
//
// A block has ports and registers of all kinds, an enumeration (perhaps with gaps), a struct within
// In, Out and the state, arrays, tables, helpers, and perhaps a block of its own, or two in an
// array.

#pragma once

#include "tests/generator/random/tables.hpp"

namespace hlsgen::test {

class Program : private Tables {
 public:
  // With `products`, some more of them than chance would have it, and sums of them.
  Program(std::uint64_t seed, const std::string& name, bool may_have_child, bool products = false);

  // The class, behind the class of its child if it has one.
  std::string text();

 private:
  struct Member {
    std::string name;
    Type type;
  };

  void draw_enumeration();
  void draw_in();
  void draw_out();
  void draw_state();
  void draw_child(std::uint64_t seed);
  std::string helpers();
  std::string tick_of_child(int number);
  std::string body();
  std::string last_writes();
  std::string products();
  std::string port(const std::string& name, Type type);
  std::string formatted(const std::string& text) const;

  std::string name_, enumeration_, in_, out_, state_, in_each_, out_each_, child_;
  std::string pair_;
  std::vector<Member> given_, gives_;  // members of In and Out, for the parent
  std::vector<Member> child_given_, child_gives_;
  int children_ = 0;
  bool has_products_ = false;
};

// class <name>, whose members are the blocks Random<first> ...
std::string group_text(const std::string& name, int first, int count);

// The same as programs on a datapath each, Compiled<first> ..., with registers that hold the inputs, and multipliers
// drawn from the seed.  `clocks` of each come from hlsgen; 2 where they are not known yet.
std::string compiled_group_text(const std::string& name, int first,
                                const std::vector<int>& clocks);

}  // namespace hlsgen::test
