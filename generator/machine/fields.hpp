// The words of a program: fields that the datapath reads, each in the clock in which it is used.
//
// Test: tests/generator/machine_test.cpp

#pragma once

#include "generator/dataflow/nodes.hpp"

#include <llvm/Support/MathExtras.h>

#include <string>
#include <vector>

namespace hlsgen::machine {

// To tell so many apart, at least one.
inline unsigned bits_for(std::size_t count) { return count < 3 ? 1 : llvm::Log2_64_Ceil(count); }

class Fields {
 public:
  explicit Fields(unsigned words) : values_(words) {}

  // A field of the words.
  unsigned add(const std::string& name, unsigned width) {
    fields_.push_back({name, width, bits_});
    bits_ += width;
    return static_cast<unsigned>(fields_.size() - 1);
  }
  void set(unsigned word, unsigned field, std::uint64_t value) {
    values_[word].push_back({field, value});
  }

  unsigned bits() const { return bits_; }
  std::vector<llvm::APInt> words() const {
    std::vector<llvm::APInt> words;
    for (const auto& list : values_) {
      llvm::APInt word(bits_, 0);
      for (const auto& [field, value] : list)
        word.insertBits(llvm::APInt(fields_[field].width, value), fields_[field].low);
      words.push_back(word);
    }
    return words;
  }
  NodeId read(NodeBuilder& nodes, NodeId word, unsigned field) const {
    return nodes.slice(word, fields_[field].width, fields_[field].low);
  }

 private:
  struct Field {
    std::string name;
    unsigned width, low;
  };
  std::vector<Field> fields_;
  std::vector<std::vector<std::pair<unsigned, std::uint64_t>>> values_;
  unsigned bits_ = 0;
};

}  // namespace hlsgen::machine
