// Random statements: what a tick is made of.

#pragma once

#include "tests/generator/random/expressions.hpp"

namespace hlsgen::test {

class Statements : public Expressions {
 public:
  using Expressions::Expressions;

  // `depth` statements may stand within each other.  What a block declares ends with it.
  std::string block(int count, int depth);
  std::string statements(int count, int depth);

  std::string finish;                     // how a tick ends, early or not
  bool may_return = true;
  std::vector<std::string> pairs;         // variables of the block's struct Pair
  std::vector<std::string> written_pairs;
  std::vector<std::string> written_modes;

 private:
  std::string statement(int depth);
  std::string assignment();
  std::string branch(int depth);
  std::string choice(int depth);
  std::string loop(int depth);
  std::string local();
  std::string name(const char* stem) { return stem + std::to_string(names_++); }

  int names_ = 0;
  int left_ = any.between(8, 30);  // statements that may still be drawn
};

}  // namespace hlsgen::test
