#include "generator/cpp/memory_class.hpp"

#include "generator/machine/memory.hpp"

namespace hlsgen {

const llvm::DICompositeType* contents_of(const llvm::DICompositeType* type) {
  const auto parameters = type->getTemplateParams();
  if (!type->getName().startswith("Memory<") || parameters.size() != 1) return nullptr;
  return class_of(parameters[0]->getType());
}

Module memory_of(const Block& block) {
  Module module;
  module.name = block.module;
  module.cpp_class = block.cpp_class;
  module.source = block.source;
  std::vector<llvm::APInt> words;
  for (std::size_t i = 0; i < block.state.leaves.size(); ++i) {
    const bool is_word = block.state.leaves[i].leaf.name.find('[') != std::string::npos;
    if (is_word) words.push_back(block.reset[i]);
  }
  const unsigned width = words.at(0).getBitWidth();
  for (const auto& place : block.in.leaves) module.inputs.push_back(place.leaf);
  for (const auto& place : block.out.leaves) module.outputs.push_back({place.leaf, kNone});
  module.tables.push_back({"words", width, std::move(words)});
  return module;
}

}  // namespace hlsgen
