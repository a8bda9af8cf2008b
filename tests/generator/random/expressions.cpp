#include "tests/generator/random/expressions.hpp"

namespace hlsgen::test {
namespace {

// The most bits whose largest number stays below n.
int bits_below(int n) {
  int bits = 0;
  while ((1 << (bits + 1)) <= n) ++bits;
  return bits;
}

}  // namespace

std::string Expressions::converted(const std::string& text, Type from, Type to) {
  if (from == to) return text;
  const bool is_bits = from.kind == Type::Kind::kBits;
  switch (to.kind) {
    case Type::Kind::kBool:
      return cat({"(", text, " != 0)"});
    case Type::Kind::kBits:
      return cat({is_bits ? cat({"wrap<", to.text(), ">"}) : to.text(), "(", text, ")"});
    case Type::Kind::kPlain:
      break;
  }
  const std::string cast = cat({"static_cast<", to.text(), ">("});
  if (!is_bits) return cat({cast, text, ")"});
  return cat({cast, "wrap<", bits(to.width, to.is_signed).text(), ">(", text, ").raw())"});
}

std::string Expressions::constant(Type type) {
  if (type == kBool) return any.of({"true", "false"});
  const auto value = any.chance(50) ? any.next() % 16 : any.next() >> any.between(1, 60);
  std::string text = std::to_string(value);
  if (any.chance(20)) text = cat({"-", text});
  return cat({type.kind == Type::Kind::kPlain ? cat({"static_cast<", type.text(), ">"})
                                              : type.text(),
              "(", text, ")"});
}

std::string Expressions::leaf(Type type) {
  if (any.chance(20)) return constant(type);
  if (!arrays.empty() && any.chance(25)) {
    const Array array = any.of(arrays);
    return converted(cat({array.name, "[", index(array, 0), "]"}), array.element, type);
  }
  if (any.chance(5)) return converted(cat({"static_cast<int>(", any.of(modes), ")"}), kInteger, type);
  const Variable& variable = any.of(variables);
  return converted(variable.name, variable.type, type);
}

// In range by its width, or by a helper that limits it.
std::string Expressions::index(const Array& array, int depth) {
  if (any.chance(20)) return std::to_string(any.below(array.count));
  const int width = bits_below(array.count);
  if (1 << width == array.count) return cat({expression(bits(width, false), depth), ".raw()"});
  return cat({"below<", std::to_string(array.count), ">(",
              expression(bits(width + any.between(1, 3), false), depth), ").raw()"});
}

std::string Expressions::expression(Type type, int depth) {
  if (depth <= 0 || any.chance(15)) return leaf(type);
  if (any.chance(12)) {
    return cat({"(", condition(depth - 1), " ? ", expression(type, depth - 1), " : ",
                expression(type, depth - 1), ")"});
  }
  if (type == kBool) return condition(depth - 1);
  return type.kind == Type::Kind::kBits ? of_bits(type, depth) : of_plain(type, depth);
}

std::string Expressions::of_bits(Type type, int depth) {
  switch (any.below(10)) {
    case 0: case 1: case 2:
      return sum(type, depth);
    case 3:
      return cat({"(", expression(type, depth - 1), any.of({" & ", " | ", " ^ "}),
                  expression(type, depth - 1), ")"});
    case 4: case 5:
      return shift(type, depth);
    case 6:
      if (any.chance(50)) return cat({"(~", expression(type, depth - 1), ")"});
      return cat({"wrap<", type.text(), ">(-", expression(draw_bits(any), depth - 1), ")"});
    case 7: {
      const Type from = draw_bits(any);
      const int low = any.below(from.width);
      const int high = any.between(low, from.width - 1);
      return cat({"wrap<", type.text(), ">((", expression(from, depth - 1), ").template slice<",
                  std::to_string(high), ", ", std::to_string(low), ">())"});
    }
    case 8: {
      const Type from = draw_type(any);
      return converted(expression(from, depth - 1), from, type);
    }
    default:
      return helper(type, depth);
  }
}

// Exact, then narrowed: products have up to 128 bits.
std::string Expressions::sum(Type type, int depth) {
  return cat({any.of({"wrap<", "saturate<"}), type.text(), ">(",
              expression(draw_bits(any), depth - 1), any.of({" + ", " - ", " * "}),
              expression(draw_bits(any), depth - 1), ")"});
}

std::string Expressions::shift(Type type, int depth) {
  const std::string value = expression(type, depth - 1);
  const std::string by = any.of({" << ", " >> "});
  const int width = bits_below(type.width);
  if (width == 0 || any.chance(50)) {
    return cat({"(", value, by, std::to_string(any.below(type.width)), ")"});
  }
  return cat({"(", value, by, "int(", expression(bits(width, false), depth - 1), ".raw()))"});
}

std::string Expressions::helper(Type type, int depth) {
  if (any.chance(40)) {
    return cat({"wrap<", type.text(), ">(kTable[below<kTable.size()>(",
                expression(bits(4, false), depth - 1), ").raw()])"});
  }
  if (any.chance(30)) {
    return cat({"wrap<", type.text(), ">(pick(", expression(kBool, depth - 1), ", ",
                expression(bits(24, true), depth - 1), "))"});
  }
  return cat({"wrap<", type.text(), ">(mix(", expression(bits(16, false), depth - 1), ", ",
              expression(bits(9, true), depth - 1), "))"});
}

// int16_t and its like: promoted, computed, cut again.
std::string Expressions::of_plain(Type type, int depth) {
  const std::string cast = cat({"static_cast<", type.text(), ">("});
  switch (any.below(6)) {
    case 0: case 1:
      return cat({cast, expression(type, depth - 1), any.of({" + ", " - ", " * "}),
                  expression(type, depth - 1), ")"});
    case 2:
      return cat({cast, expression(type, depth - 1), any.of({" & ", " | ", " ^ "}),
                  expression(type, depth - 1), ")"});
    case 3:
      return cat({cast, expression(type, depth - 1), any.of({" << ", " >> "}),
                  std::to_string(any.below(type.width)), ")"});
    case 4:
      return cat({cast, expression(type, depth - 1), any.of({" / ", " % "}),
                  std::to_string(1 << any.below(type.width < 16 ? 6 : 12)), ")"});
    default: {
      const Type from = draw_type(any);
      return converted(expression(from, depth - 1), from, type);
    }
  }
}

std::string Expressions::enumerator() { return cat({"Mode::", any.of(enumerators)}); }

std::string Expressions::mode(int depth) {
  switch (depth <= 0 ? any.below(2) : any.below(4)) {
    case 0:
      return enumerator();
    case 1:
      return any.of(modes);
    case 2:
      return cat({"following(", mode(depth - 1), ")"});
    default:
      return cat({"(", condition(depth - 1), " ? ", mode(depth - 1), " : ", mode(depth - 1), ")"});
  }
}

std::string Expressions::condition(int depth) {
  if (depth > 0 && any.chance(30)) {
    return cat({"(", condition(depth - 1), any.of({" && ", " || "}), condition(depth - 1), ")"});
  }
  switch (any.below(6)) {
    case 0: {
      const Type type = draw_bits(any);
      return cat({"(", expression(type, depth - 1), ").bit(", std::to_string(any.below(type.width)),
                  ")"});
    }
    case 1:
      return cat({"(", mode(depth - 1), any.of({" == ", " != "}), enumerator(), ")"});
    case 2:
      return cat({"!", leaf(kBool)});
    case 3:
      return leaf(kBool);
    default:
      return comparison(depth);
  }
}

std::string Expressions::comparison(int depth) {
  const std::string op = any.of({" < ", " <= ", " > ", " >= ", " == ", " != "});
  const Type left = any.chance(20) ? Type{Type::Kind::kPlain, 8 << any.below(4), any.chance(50)}
                                   : draw_bits(any);
  if (any.chance(25)) {
    return cat({"(", expression(left, depth), op, std::to_string(any.between(-8, 8)), ")"});
  }
  const Type right = left.kind == Type::Kind::kBits ? draw_bits(any) : left;
  return cat({"(", expression(left, depth), op, expression(right, depth - 1), ")"});
}

}  // namespace hlsgen::test
