#include "tests/generator/random/tables.hpp"

#include <algorithm>
#include <utility>

namespace hlsgen::test {

std::string Tables::entries(int count, int least, int most) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += cat({i == 0 ? "" : ", ", std::to_string(any.between(least, most))});
  }
  return text;
}

// The same numbers, cut to each width: entries may be equal in all of them.
void Tables::draw_shapes(int count) {
  const bool is_signed = any.chance(40);
  const std::string element = is_signed ? "Int<W>" : "UInt<W>";
  const int most = any.chance(40) ? 7 : 30'000;
  members_ += cat({"template <int W>\nstruct Shape {\nstatic constexpr std::array<", element, ", ",
                   std::to_string(count), "> kShape = {", entries(count, is_signed ? -most : 0, most),
                   "};\n};\n"});
  int width = any.of(std::vector<int>{4, 7, 8, 15, 16, 31, 32, 40});
  for (int i = 0, n = any.between(2, 3); i < n; ++i, width += any.between(1, 9)) {
    tables_.push_back({cat({"Shape<", std::to_string(width), ">::kShape"}), bits(width, is_signed),
                       count, false});
  }
}

void Tables::draw_rows(int count) {
  const std::vector<Array> columns = {{"kRows", draw_bits(any), count, false, ".a"},
                                      {"kRows", draw_bits(any), count, false, ".b"},
                                      {"kRows", kBool, count, false, ".c"}};
  std::string rows;
  for (int i = 0; i < count; ++i) {
    rows += cat({i == 0 ? "{" : ", {", entries(2, 0, 100), ", ", any.of({"true", "false"}), "}"});
  }
  members_ += cat({"struct Row {\n", columns[0].element.text(), " a;\n", columns[1].element.text(),
                   " b;\nbool c;\n};\nstatic constexpr Row kRows[] = {", rows, "};\n"});
  tables_.insert(tables_.end(), columns.begin(), columns.end());
}

// In range by its width.
std::string Tables::place(int count) {
  if (any.chance(10)) return std::to_string(any.below(count));
  int width = 1;
  while (2 << width <= count) ++width;
  return cat({expression(bits(width, false), 0), ".raw()"});
}

std::string Tables::reads_of_tables() {
  std::swap(any, own_);
  const auto others = std::exchange(arrays, {});  // an index there needs more than its width
  const int count = any.between(3, 16);
  draw_shapes(count);
  draw_rows(any.chance(50) ? count : any.between(2, 9));
  const Type plain{Type::Kind::kPlain, 8 << any.below(3), true};
  const int plains = any.between(2, 20);
  members_ += cat({"static constexpr ", plain.text(), " kPlain[] = {", entries(plains, -99, 99),
                   "};\n"});
  tables_.push_back({"kPlain", plain, plains, false});
  const Array grid{"kGrid", draw_bits(any), any.between(2, 5), false};
  const int lines = any.between(2, 4);
  std::string texts;
  for (int i = 0; i < lines; ++i) {
    texts += cat({i == 0 ? "{{" : ", {{", entries(grid.count, 0, 50), "}}"});
  }
  members_ += cat({"static constexpr std::array<std::array<", grid.element.text(), ", ",
                   std::to_string(grid.count), ">, ", std::to_string(lines), "> kGrid = {{", texts,
                   "}};\n"});
  tables_.push_back({cat({"kGrid[", place(lines), "]"}), grid.element,
                     grid.count, false});

  std::vector<Variable> targets;
  for (const auto& variable : variables) {
    const bool is_local = !variable.name.starts_with("out.") && !variable.name.ends_with("_");
    if (variable.is_writable && !is_local) targets.push_back(variable);
  }
  std::string text;
  for (std::size_t next = 0; next < std::max(targets.size(), tables_.size()); ++next) {
    const Variable& variable = targets[next % targets.size()];
    const Array& table = tables_[next % tables_.size()];
    const Type type = variable.type;
    const std::string entry =
        converted(cat({table.name, "[", place(table.count), "]", table.member}), table.element, type);
    text += cat({any.chance(30) ? cat({"if (", condition(0), ") "}) : "", variable.name, " = "});
    if (type == kBool) text += cat({variable.name, " != ", entry, ";\n"});
    else if (type.kind == Type::Kind::kPlain)
      text += cat({"static_cast<", type.text(), ">(", variable.name, " ^ ", entry, ");\n"});
    else
      text += cat({"wrap<", type.text(), ">(", variable.name, any.of({" + ", " - "}), entry, ");\n"});
  }
  std::swap(any, own_);
  arrays = others;
  return text;
}

}  // namespace hlsgen::test
