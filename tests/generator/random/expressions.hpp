// Random expressions over the variables in scope.  Whatever is drawn is defined by C++ (with -fwrapv):
// shifts stay below the width, indices within their arrays.

#pragma once

#include "tests/generator/random/draw.hpp"

namespace hlsgen::test {

struct Variable {
  std::string name;
  Type type;
  bool is_writable = false;
};

struct Array {
  std::string name;
  Type element;
  int count = 0;
  bool is_writable = false;
  std::string member = {};  // of an element, ".a"
};

class Expressions {
 public:
  explicit Expressions(std::uint64_t seed) : any(seed) {}

  // Text of exactly that type.
  std::string expression(Type type, int depth);
  std::string condition(int depth);
  std::string mode(int depth);        // of the block's enumeration
  std::string enumerator();           // Mode::kB
  std::string index(const Array& array, int depth);

  static std::string converted(const std::string& text, Type from, Type to);

  Draw any;
  std::vector<Variable> variables;
  std::vector<Array> arrays;
  std::vector<std::string> modes;        // variables of the enumeration
  std::vector<std::string> enumerators;  // kA ...

 private:
  std::string leaf(Type type);
  std::string constant(Type type);
  std::string of_bits(Type type, int depth);
  std::string of_plain(Type type, int depth);
  std::string sum(Type type, int depth);
  std::string shift(Type type, int depth);
  std::string helper(Type type, int depth);
  std::string comparison(int depth);
};

}  // namespace hlsgen::test
