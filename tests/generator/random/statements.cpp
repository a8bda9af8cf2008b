#include "tests/generator/random/statements.hpp"

namespace hlsgen::test {

std::string Statements::block(int count, int depth) {
  const auto outer_variables = variables;
  const auto outer_pairs = pairs;
  const std::string text = statements(count, depth);
  variables = outer_variables;
  pairs = outer_pairs;
  return text;
}

std::string Statements::statements(int count, int depth) {
  std::string text;
  for (int i = 0; i < count && left_ > 0; ++i, --left_) text += statement(depth);
  return text;
}

std::string Statements::statement(int depth) {
  switch (depth == 0 ? 0 : any.below(14)) {
    case 4: case 5:
      return branch(depth);
    case 6: case 7:
      return choice(depth);
    case 8: case 9:
      return loop(depth);
    case 10: case 11:
      return local();
    case 12:
      if (!may_return) return assignment();
      return cat({"if (", condition(1), ") {\n", finish, "}\n"});
    default:
      return assignment();
  }
}

std::string Statements::assignment() {
  if (any.chance(15)) return cat({any.of(written_modes), " = ", mode(2), ";\n"});
  if (!written_pairs.empty() && any.chance(10)) {
    return cat({any.of(written_pairs), " = ", any.of(pairs), ";\n"});
  }
  std::vector<Array> written;
  for (const auto& array : arrays) {
    if (array.is_writable) written.push_back(array);
  }
  if (!written.empty() && any.chance(25)) {
    const Array& array = any.of(written);
    return cat({array.name, "[", index(array, 1), "] = ", expression(array.element, 2), ";\n"});
  }
  std::vector<Variable> targets;
  for (const auto& variable : variables) {
    if (variable.is_writable) targets.push_back(variable);
  }
  const Variable target = any.of(targets);
  if (target.type.kind == Type::Kind::kPlain && any.chance(40)) {
    if (any.chance(30)) return cat({any.of({"++", "--"}), target.name, ";\n"});
    return cat({target.name, any.of({" += ", " -= ", " ^= ", " *= "}), expression(target.type, 2),
                ";\n"});
  }
  if (target.type.kind == Type::Kind::kBits && any.chance(15)) {
    return cat({"add(", target.name, ", ", expression(bits(8, true), 1), ");\n"});
  }
  return cat({target.name, " = ", expression(target.type, 3), ";\n"});
}

std::string Statements::branch(int depth) {
  return cat({"if (", condition(2), ") {\n", block(any.between(1, 3), depth - 1), "}",
              any.chance(60) ? cat({" else {\n", block(any.between(1, 3), depth - 1), "}\n"})
                             : "\n"});
}

std::string Statements::choice(int depth) {
  const bool by_mode = any.chance(60);
  const int count = by_mode ? static_cast<int>(enumerators.size()) : 7;
  std::string text = by_mode ? cat({"switch (", any.of(modes), ") {\n"})
                             : cat({"switch (int(", expression(bits(3, false), 1), ".raw())) {\n"});
  for (int i = 0; i < count; ++i) {
    if (any.chance(35)) continue;
    text += cat({"case ", by_mode ? "Mode::" + enumerators[static_cast<std::size_t>(i)]
                                  : std::to_string(i), ": {\n",
                 block(any.between(1, 2), depth - 1), "}\n"});
    text += any.chance(20) ? "[[fallthrough]];\n" : "break;\n";
  }
  // The last may not fall out of the switch.
  return cat({text, any.chance(70) ? cat({"default: {\n", block(1, depth - 1), "}\n"})
                                   : "default: break;\n", "}\n"});
}

std::string Statements::loop(int depth) {
  const std::string i = name("i");
  const int count = any.between(1, 5);
  const bool is_while = any.chance(25);
  std::string text =
      is_while ? cat({"int ", i, " = 0;\nwhile (", i, " < ", std::to_string(count), " && ",
                      condition(1), ") {\n"})
               : cat({"for (int ", i, " = 0; ", i, " < ", std::to_string(count), "; ++", i, ") {\n"});
  const auto outer = variables;
  variables.push_back({i, kInteger, false});
  if (is_while) text += cat({"++", i, ";\n"});
  if (any.chance(40)) text += cat({"if (", condition(1), ") ", any.of({"break", "continue"}), ";\n"});
  for (const auto& array : arrays) {  // element by element
    if (is_while || !array.is_writable || array.count < count || any.chance(50)) continue;
    text += cat({array.name, "[", i, "] = ", expression(array.element, 2), ";\n"});
  }
  if (any.chance(30)) {
    text += cat({"if ((", expression(bits(8, false), 0), ").bit(", i, ")) ", assignment()});
  }
  text += block(any.between(1, 2), any.chance(30) ? depth - 1 : 0);
  variables = outer;
  return text + "}\n";
}

std::string Statements::local() {
  const Type type = draw_type(any);
  switch (any.below(4)) {
    case 0: {  // as wide as the product comes
      const Type left = draw_bits(any);
      const Type right = draw_bits(any);
      const std::string own = name("p");
      const std::string text = cat({"const auto ", own, " = ", expression(left, 2), " * ",
                                    expression(right, 2), ";\n"});
      const bool is_signed = left.is_signed || right.is_signed;
      variables.push_back({own, bits(left.width + right.width, is_signed), false});
      return text;
    }
    case 1: {
      if (pairs.size() < 2) break;
      const std::string own = name("pair");
      const std::string text = cat({"Pair ", own, " = ", condition(1), " ? ", any.of(pairs), " : ",
                                    any.of(pairs), ";\n"});
      pairs.push_back(own);
      return text;
    }
    default:
      break;
  }
  const std::string own = name("v");
  const bool is_constant = any.chance(30);
  const std::string text = cat({is_constant ? "const " : "", type.text(), " ", own, " = ",
                                expression(type, 3), ";\n"});
  variables.push_back({own, type, !is_constant});
  return text;
}

}  // namespace hlsgen::test
