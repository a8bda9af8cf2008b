#include "generator/cpp/scheduled.hpp"

#include <llvm/IR/Constants.h>

#include <map>
#include <string>

namespace hlsgen {
namespace {

// Members of the budget by their names.
std::map<std::string, unsigned> numbers_in(const llvm::DITemplateValueParameter* parameter) {
  std::map<std::string, unsigned> numbers;
  const auto* type = class_of(parameter->getType());
  const auto* value = llvm::mdconst::dyn_extract_or_null<llvm::Constant>(parameter->getValue());
  if (type == nullptr || value == nullptr || type->getName() != "Budget") return numbers;
  unsigned place = 0;
  for (const auto* element : type->getElements()) {
    const auto* member = llvm::dyn_cast<llvm::DIDerivedType>(element);
    if (member == nullptr) continue;
    const auto* number =
        llvm::dyn_cast_or_null<llvm::ConstantInt>(value->getAggregateElement(place++));
    if (number != nullptr) {
      numbers[member->getName().str()] = static_cast<unsigned>(number->getZExtValue());
    }
  }
  return numbers;
}

}  // namespace

std::optional<ScheduledClass> scheduled_class(const llvm::DICompositeType* type) {
  const auto parameters = type->getTemplateParams();
  if (!type->getName().startswith("Scheduled<") || parameters.size() != 2) return std::nullopt;
  const auto* value = llvm::dyn_cast<llvm::DITemplateValueParameter>(parameters[1]);
  if (value == nullptr) return std::nullopt;
  auto numbers = numbers_in(value);
  if (numbers.count("clocks") == 0) return std::nullopt;
  ScheduledClass found;
  found.sample = class_of(parameters[0]->getType());
  found.budget = {numbers["width"], numbers["second_width"], numbers["clocks"], numbers["early"]};
  return found;
}

Layout flat_layout(const llvm::DICompositeType* type) {
  Layout flat = lay_out(type);
  for (const auto& instance : flat.instances) {
    for (auto place : flat_layout(instance.type).leaves) {
      place.leaf.name = instance.name + "." + place.leaf.name;
      place.offset += instance.offset;
      flat.leaves.push_back(std::move(place));
    }
  }
  flat.instances.clear();
  return flat;
}

}  // namespace hlsgen
