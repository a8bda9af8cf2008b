#include "generator/cpp/layout.hpp"

#include <llvm/BinaryFormat/Dwarf.h>
#include <llvm/IR/Constants.h>

#include <algorithm>

#include "generator/cpp/comments.hpp"
#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

using llvm::cast;
using llvm::dyn_cast;
namespace dwarf = llvm::dwarf;

const llvm::DIType* behind_typedefs(const llvm::DIType* type) {
  while (const auto* derived = llvm::dyn_cast_or_null<llvm::DIDerivedType>(type)) {
    switch (derived->getTag()) {
      case dwarf::DW_TAG_typedef:
      case dwarf::DW_TAG_const_type:
      case dwarf::DW_TAG_member:
        type = derived->getBaseType();
        break;
      default:
        return type;
    }
  }
  return type;
}

bool is_data_member(const llvm::DINode* element) {
  const auto* member = llvm::dyn_cast_or_null<llvm::DIDerivedType>(element);
  return member != nullptr && member->getTag() == dwarf::DW_TAG_member && !member->isStaticMember();
}

// The one data member, when there is exactly one and nothing else with data.
const llvm::DIDerivedType* only_member(const llvm::DICompositeType* type) {
  const llvm::DIDerivedType* only = nullptr;
  for (const auto* element : type->getElements()) {
    const auto* derived = dyn_cast<llvm::DIDerivedType>(element);
    if (derived != nullptr && derived->getTag() == dwarf::DW_TAG_inheritance) return nullptr;
    if (!is_data_member(element)) continue;
    if (only != nullptr) return nullptr;
    only = derived;
  }
  return only;
}

// _BitInt does not tell its width to the debugger; the number class has it as first argument.
std::int64_t first_value_argument(const llvm::DICompositeType* type) {
  for (const auto* parameter : type->getTemplateParams()) {
    const auto* value = dyn_cast<llvm::DITemplateValueParameter>(parameter);
    if (value == nullptr) continue;
    const auto* constant = llvm::mdconst::dyn_extract_or_null<llvm::ConstantInt>(value->getValue());
    return constant == nullptr ? 0 : constant->getSExtValue();
  }
  return 0;
}

// hls/numeric/one_hot.hpp: the enumeration whose values its bits stand for, null for other classes.
const llvm::DICompositeType* values_of_set(const llvm::DICompositeType* type) {
  if (!type->getName().startswith("OneHot<")) return nullptr;
  for (const auto* parameter : type->getTemplateParams()) {
    const auto* argument = dyn_cast<llvm::DITemplateTypeParameter>(parameter);
    if (argument == nullptr) continue;
    const auto* values = llvm::dyn_cast_or_null<llvm::DICompositeType>(behind_typedefs(argument->getType()));
    return values != nullptr && values->getTag() == dwarf::DW_TAG_enumeration_type ? values : nullptr;
  }
  return nullptr;
}

class Walk {
 public:
  explicit Walk(Layout& layout) : layout_(layout) {}

  void members_of(const llvm::DICompositeType* type, const std::string& prefix,
                  std::uint64_t offset) {
    if (type->getTag() == dwarf::DW_TAG_union_type) {
      refuse("a union has no fixed meaning in hardware", "make it a struct with one member each");
    }
    if (type->getVTableHolder() != nullptr) {
      refuse("virtual functions need a pointer at run time", "choose the type by a template");
    }
    for (const auto* element : type->getElements()) {
      const auto* member = dyn_cast<llvm::DIDerivedType>(element);
      if (member == nullptr) continue;
      const std::uint64_t place = offset + member->getOffsetInBits() / 8;
      if (member->getTag() == dwarf::DW_TAG_inheritance) {
        if ((member->getFlags() & llvm::DINode::FlagVirtual) != 0) {
          refuse("virtual base class", "inherit without `virtual`");
        }
        members_of(class_of(member->getBaseType()), prefix, place);
      } else if (is_data_member(member)) {
        at_ = source_line(member->getFile(), member->getLine());
        if (member->isBitField()) {
          refuse("bit-field '" + member->getName().str() + "'", "use UInt<W> or Int<W>");
        }
        if (member->getName().startswith("_vptr")) {
          refuse("virtual functions need a pointer at run time", "choose the type by a template");
        }
        // Names reserved for the library (std::array's _M_elems) are not the user's.
        const bool reserved = member->getName().startswith("_M_");
        const std::string name = reserved         ? prefix
                                 : prefix.empty() ? member->getName().str()
                                                  : prefix + "." + member->getName().str();
        // What the number library says of its own member says nothing of this one.
        const bool inner = !prefix.empty() && is_number_library(at_);
        if (!reserved && !inner) declared_ = at_;
        place_type(behind_typedefs(member->getBaseType()), name, place);
      }
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& mend) const {
    throw Refusal(declared_.file.empty() ? at_ : declared_, what, mend);
  }

  void place_type(const llvm::DIType* type, const std::string& name, std::uint64_t offset) {
    if (const auto* basic = llvm::dyn_cast_or_null<llvm::DIBasicType>(type)) {
      return place_basic(basic, name, offset);
    }
    if (const auto* composite = llvm::dyn_cast_or_null<llvm::DICompositeType>(type)) {
      return place_composite(composite, name, offset);
    }
    refuse("'" + name + "' is a pointer or a reference", "hold the value itself, or an index");
  }

  void place_basic(const llvm::DIBasicType* type, const std::string& name, std::uint64_t offset) {
    LeafPlace place = new_leaf(name, offset);
    place.storage_bits = static_cast<unsigned>(type->getSizeInBits());
    place.leaf.width = place.storage_bits;
    switch (type->getEncoding()) {
      case dwarf::DW_ATE_boolean:
        place.leaf.width = 1;
        break;
      case dwarf::DW_ATE_signed:
      case dwarf::DW_ATE_signed_char:
        place.leaf.is_signed = true;
        break;
      case dwarf::DW_ATE_unsigned:
      case dwarf::DW_ATE_unsigned_char:
      case dwarf::DW_ATE_UTF:
        break;
      default:
        refuse("'" + name + "' is floating point", "use fixed point (UInt<W>, Int<W>)");
    }
    if (type->getName().contains("_BitInt")) {
      refuse("'" + name + "' is a bare _BitInt", "use UInt<W> or Int<W>");
    }
    layout_.leaves.push_back(place);
  }

  void place_composite(const llvm::DICompositeType* type, const std::string& name,
                       std::uint64_t offset) {
    if (type->getTag() == dwarf::DW_TAG_enumeration_type) return place_enum(type, name, offset);
    if (type->getTag() == dwarf::DW_TAG_array_type) return place_array(type, name, offset);
    if (tick_of(type) != nullptr) {
      layout_.instances.push_back({name, offset, type->getSizeInBits() / 8, type, declared_});
      return;
    }
    if (place_parameter(type, name, offset) || place_number(type, name, offset)) return;
    const auto* outer = set_of_;
    set_of_ = values_of_set(type);
    members_of(type, name, offset);
    set_of_ = outer;
  }

  // hls/numeric/parameter.hpp, and no other class of that name.
  bool place_parameter(const llvm::DICompositeType* type, const std::string& name,
                       std::uint64_t offset) {
    if (!type->getName().startswith("Parameter<")) return false;
    const auto* member = only_member(type);
    if (member == nullptr) return false;
    const auto* basic =
        llvm::dyn_cast_or_null<llvm::DIBasicType>(behind_typedefs(member->getBaseType()));
    if (basic == nullptr || basic->getEncoding() != dwarf::DW_ATE_boolean) return false;
    place_basic(basic, name, offset);
    layout_.leaves.back().leaf.parameter = first_value_argument(type) != 0;
    return true;
  }

  // A class around one private _BitInt.
  bool place_number(const llvm::DICompositeType* type, const std::string& name,
                    std::uint64_t offset) {
    const auto* member = only_member(type);
    if (member == nullptr) return false;
    const auto* basic =
        llvm::dyn_cast_or_null<llvm::DIBasicType>(behind_typedefs(member->getBaseType()));
    if (basic == nullptr || !basic->getName().contains("_BitInt")) return false;
    LeafPlace place = new_leaf(name, offset);
    place.leaf.width = static_cast<unsigned>(first_value_argument(type));
    place.leaf.is_signed = basic->getEncoding() == dwarf::DW_ATE_signed;
    place.storage_bits = place.leaf.width;
    if (place.leaf.width < 1 || place.leaf.width > 128) {
      refuse("'" + name + "' has a width outside 1 to 128 bits", "split it into parts");
    }
    if (place.leaf.is_signed && place.leaf.width == 1) {
      refuse("'" + name + "' is a sign bit without a number", "use bool or Int<2>");
    }
    layout_.leaves.push_back(place);
    return true;
  }

  void place_enum(const llvm::DICompositeType* type, const std::string& name,
                  std::uint64_t offset) {
    LeafPlace place = new_leaf(name, offset);
    place.storage_bits = static_cast<unsigned>(type->getSizeInBits());
    place.enumeration = type;
    for (const auto* element : type->getElements()) {
      if (cast<llvm::DIEnumerator>(element)->getValue().isNegative() &&
          !cast<llvm::DIEnumerator>(element)->isUnsigned()) {
        refuse("'" + name + "' has a negative enumerator", "number enumerators from 0 up");
      }
    }
    place.leaf.width = enumeration_of(type).width;
    layout_.leaves.push_back(place);
  }

  void place_array(const llvm::DICompositeType* type, const std::string& name,
                   std::uint64_t offset) {
    std::vector<std::int64_t> counts;
    for (const auto* element : type->getElements()) {
      const auto count = cast<llvm::DISubrange>(element)->getCount();
      auto* constant = count.dyn_cast<llvm::ConstantInt*>();
      if (constant == nullptr) refuse("'" + name + "' has no constant size", "give it one");
      counts.push_back(constant->getSExtValue());
    }
    place_elements(behind_typedefs(type->getBaseType()), counts, 0, name, offset,
                   type->getSizeInBits() / 8);
  }

  void place_elements(const llvm::DIType* element, const std::vector<std::int64_t>& counts,
                      std::size_t dimension, const std::string& name, std::uint64_t offset,
                      std::uint64_t size) {
    if (dimension == counts.size()) return place_type(element, name, offset);
    const std::uint64_t count = counts[dimension] < 0 ? 0 : counts[dimension];
    for (std::uint64_t i = 0; i < count; ++i) {
      place_elements(element, counts, dimension + 1, name + "[" + std::to_string(i) + "]",
                     offset + i * (size / count), size / count);
    }
  }

  LeafPlace new_leaf(const std::string& name, std::uint64_t offset) const {
    LeafPlace place;
    place.leaf.name = name;
    place.leaf.comment = comment_at(declared_);
    place.offset = offset;
    place.set_of = set_of_;
    place.source = declared_;
    return place;
  }

  Layout& layout_;
  SourceLine at_;        // the member being looked at
  SourceLine declared_;  // the innermost member that the user wrote
  const llvm::DICompositeType* set_of_ = nullptr;  // of the OneHot that is being looked at
};

}  // namespace

const llvm::DICompositeType* class_of(const llvm::DIType* type) {
  return llvm::dyn_cast_or_null<llvm::DICompositeType>(behind_typedefs(type));
}

const llvm::DISubprogram* tick_of(const llvm::DICompositeType* type) {
  for (const auto* element : type->getElements()) {
    const auto* method = dyn_cast<llvm::DISubprogram>(element);
    if (method != nullptr && method->getName() == "tick") return method;
  }
  return nullptr;
}

Enumeration enumeration_of(const llvm::DICompositeType* type) {
  Enumeration result;
  result.name = type->getName().str();
  std::uint64_t largest = 1;
  for (const auto* element : type->getElements()) {
    const auto* enumerator = cast<llvm::DIEnumerator>(element);
    const std::uint64_t value = enumerator->getValue().getZExtValue();
    result.values.emplace_back(enumerator->getName().str(), value);
    largest = std::max(largest, value);
  }
  result.width = llvm::APInt(64, largest).getActiveBits();
  return result;
}

Layout lay_out(const llvm::DICompositeType* type) {
  Layout layout;
  layout.size = type->getSizeInBits() / 8;
  Walk(layout).members_of(type, "", 0);
  return layout;
}

}  // namespace hlsgen
