#include "tests/generator/random/program.hpp"

namespace hlsgen::test {
namespace {

std::string each(const std::string& calls) {
  return cat({"template <class F>\nvoid each(F f) {\n", calls, "}\n"});
}

}  // namespace

Program::Program(std::uint64_t seed, const std::string& name, bool may_have_child, bool products)
    : Tables(seed), name_(name), has_products_(products) {
  draw_enumeration();
  draw_in();
  draw_out();
  draw_state();
  if (may_have_child && any.chance(30)) draw_child(seed + 1'000'000'000);
  finish = "out.mode = mode_;\nreturn out;\n";
}

void Program::draw_enumeration() {
  const int count = any.between(2, 6);
  const bool has_gaps = any.chance(20);
  int value = 0;
  for (int i = 0; i < count; ++i, value += has_gaps ? any.between(1, 3) : 1) {
    enumerators.push_back(std::string("k") + static_cast<char>('A' + i));
    enumeration_ += cat({i == 0 ? "" : ", ", enumerators.back(),
                         has_gaps ? " = " + std::to_string(value) : ""});
  }
  pair_ = cat({"struct Pair {\n", draw_bits(any).text(), " a = 1;\n", draw_type(any).text(),
               " b = 0;\n", each("f(a);\nf(b);\n"), "};\n"});
}

std::string Program::port(const std::string& name, Type type) {
  return cat({type.text(), " ", name, " = 0;\n"});
}

void Program::draw_in() {
  for (int i = 0, n = any.between(2, 4); i < n; ++i) {
    given_.push_back({"x" + std::to_string(i), draw_type(any)});
    variables.push_back({"in." + given_.back().name, given_.back().type, false});
    in_ += port(given_.back().name, given_.back().type);
    in_each_ += cat({"f(", given_.back().name, ");\n"});
  }
  if (any.chance(30)) {
    const Array list{"in.list", draw_bits(any), any.between(2, 5), false};
    in_ += cat({"std::array<", list.element.text(), ", ", std::to_string(list.count),
                "> list = {};\n"});
    in_each_ += "for (auto& element : list) f(element);\n";
    arrays.push_back(list);
  }
  if (any.chance(30)) {
    in_ += "Pair pair;\n";
    in_each_ += "pair.each(f);\n";
    pairs.push_back("in.pair");
  }
  in_ += cat({"Mode mode = ", enumerator(), ";\n"});
  in_each_ += "f(mode);\n";
  modes.push_back("in.mode");
}

void Program::draw_out() {
  for (int i = 0, n = any.between(1, 3); i < n; ++i) {
    gives_.push_back({"y" + std::to_string(i), draw_type(any)});
    variables.push_back({"out." + gives_.back().name, gives_.back().type, true});
    out_ += port(gives_.back().name, gives_.back().type);
    out_each_ += cat({"f(", gives_.back().name, ");\n"});
  }
  if (any.chance(25)) {
    out_ += "Pair pair;\n";
    out_each_ += "pair.each(f);\n";
    pairs.push_back("out.pair");
    written_pairs.push_back("out.pair");
  }
  out_ += cat({"Mode mode = ", enumerator(), ";\n"});
  out_each_ += "f(mode);\n";
}

void Program::draw_state() {
  for (int i = 0, n = any.between(1, 4); i < n; ++i) {
    const Variable kept{cat({"r", std::to_string(i), "_"}), draw_type(any), true};
    const int reset = kept.type == kBool ? any.below(2) : any.below(120);
    state_ += cat({kept.type.text(), " ", kept.name, " = ", std::to_string(reset), ";\n"});
    variables.push_back(kept);
  }
  for (int i = 0, n = any.below(3); i < n; ++i) {
    const Array kept{cat({"a", std::to_string(i), "_"}), draw_type(any), any.between(2, 7), true};
    state_ += cat({"std::array<", kept.element.text(), ", ", std::to_string(kept.count), "> ",
                   kept.name, " = {};\n"});
    arrays.push_back(kept);
  }
  if (!pairs.empty()) {
    state_ += "Pair pair_;\n";
    pairs.push_back("pair_");
    written_pairs.push_back("pair_");
  }
  state_ += cat({"Mode mode_ = ", enumerator(), ";\n"});
  modes.push_back("mode_");
  written_modes.push_back("mode_");
}

void Program::draw_child(std::uint64_t seed) {
  Program child(seed, name_ + "Child", false);
  child_ = child.text();
  child_given_ = child.given_;
  child_gives_ = child.gives_;
  children_ = any.chance(30) ? 2 : 1;
  state_ += children_ == 1 ? cat({name_, "Child child_;\n"})
                           : cat({"std::array<", name_, "Child, 2> child_;\n"});
}

// Ticked in every clock; what it gives is read from then on.
std::string Program::tick_of_child(int number) {
  const std::string n = std::to_string(number);
  std::string text = cat({name_, "Child::In in", n, ";\n"});
  for (const auto& member : child_given_) {
    if (any.chance(20)) continue;
    text += cat({"in", n, ".", member.name, " = ", expression(member.type, 2), ";\n"});
  }
  text += cat({"const auto out", n, " = child_", children_ == 1 ? "" : "[" + n + "]", ".tick(in", n,
               ");\n"});
  for (const auto& member : child_gives_) {
    variables.push_back({cat({"out", n, ".", member.name}), member.type, false});
  }
  return text;
}

std::string Program::helpers() {
  std::string entries;
  for (int i = 0, n = any.between(5, 15); i < n; ++i) {
    entries += cat({i == 0 ? "" : ", ", std::to_string(any.between(-200, 200))});
  }
  std::string following = "static Mode following(Mode mode) {\nswitch (mode) {\n";
  for (const auto& from : enumerators) {
    if (any.chance(20)) continue;
    following += cat({"case Mode::", from, ": return ", enumerator(), ";\n"});
  }
  following += cat({"default: return ", enumerator(), ";\n}\n}\n"});
  return cat(
      {"static constexpr auto kTable = std::to_array<Int<9>>({", entries, "});\n", following,
       "template <std::size_t N, int W>\nstatic UInt<W> below(UInt<W> x) {\n",
       "return x < static_cast<int>(N) ? x : UInt<W>(", std::to_string(any.below(2)), ");\n}\n",
       "template <class T>\nstatic void add(T& sum, const Int<8>& x) {\nsum = wrap<T>(sum + x);\n}\n",
       "static UInt<16> mix(const UInt<16>& a, Int<9> b) {\nUInt<16> sum = ",
       std::to_string(any.below(999)), ";\nfor (int i = 0; i < ", std::to_string(any.between(1, 5)),
       "; ++i) {\nif (b.bit(i)) sum = wrap<UInt<16>>(sum + (a << i));\n",
       any.chance(60) ? cat({"if (sum.raw() == ", std::to_string(any.below(64)), ") return a;\n"})
                      : "",
       "}\nreturn sum", any.chance(50) ? " ^ a" : "", ";\n}\n"});
}

std::string Program::body() {
  std::string text = "Out out;\n";
  // A reference and a lambda, so that pointers to registers have to be followed.
  text += cat({"const auto pick = [&](bool first, const Int<24>& x) {\nreturn first ? x : ",
               expression(bits(24, true), 0), ";\n};\n"});
  may_return = children_ == 0;  // children are ticked in every clock
  text += statements(any.between(0, 3), 3);
  for (int i = 0; i < children_; ++i) text += tick_of_child(i);
  may_return = true;
  text += statements(any.between(3, 6), 3);
  return cat({text, last_writes(), has_products_ ? products() : "", reads_of_tables(), finish});
}

// Most ports and registers end with something that was computed, or little of it would be seen.
std::string Program::last_writes() {
  std::string text;
  for (const auto& variable : std::vector(variables)) {
    const bool is_local = !variable.name.starts_with("out.") && !variable.name.ends_with("_");
    if (!variable.is_writable || is_local || any.chance(40)) continue;
    text += cat({variable.name, " = ", expression(variable.type, 2), ";\n"});
  }
  return text;
}

// Some hang on others; sums of two go to ports and registers, under conditions or not.
std::string Program::products() {
  std::string text;
  std::vector<Variable> made;
  for (int i = 0, n = any.between(1, 9); i < n; ++i) {
    const Type left = bits(any.between(3, 30), any.chance(60));
    const Type right = bits(any.between(3, 30), any.chance(60));
    const std::string own = "m" + std::to_string(i);
    const Variable& one = made.empty() || any.chance(60) ? any.of(variables) : made.back();
    const Variable& two = any.of(variables);
    text += cat({"const auto ", own, " = ", converted(one.name, one.type, left), " * ",
                 converted(two.name, two.type, right), ";\n"});
    made.push_back({own, bits(left.width + right.width, left.is_signed || right.is_signed), false});
  }
  for (const auto& variable : std::vector(variables)) {
    const bool is_local = !variable.name.starts_with("out.") && !variable.name.ends_with("_");
    if (!variable.is_writable || is_local || variable.type == kBool || any.chance(30)) continue;
    const Variable& one = any.of(made);
    const Variable& two = any.of(made);
    const Type wide = bits(62, true);
    text += cat({any.chance(40) ? cat({"if (", condition(0), ") "}) : "", variable.name, " = ",
                 converted(cat({"wrap<", wide.text(), ">(", converted(one.name, one.type, wide),
                                any.of({" + ", " - "}), converted(two.name, two.type, wide), ")"}),
                           wide, variable.type),
                 ";\n"});
  }
  return text;
}

std::string Program::text() {
  const std::string tick = body();
  return child_ + formatted(cat(
      {"class ", name_, " {\npublic:\nenum class Mode : std::uint8_t { ", enumeration_, " };\n",
       pair_, "struct In {\n", in_, each(in_each_), "};\nstruct Out {\n", out_, each(out_each_),
       "};\nOut tick(const In& in) {\n", tick, "}\n\nprivate:\n", helpers(), tables(), state_, "};\n\n"}));
}

// Indented by the braces.
std::string Program::formatted(const std::string& text) const {
  std::string out;
  int indent = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    const bool opens = line.ends_with("{");
    if (line.starts_with("}")) --indent;
    if (!line.empty()) out += std::string(static_cast<std::size_t>(2 * indent), ' ');
    out += line + "\n";
    if (opens) ++indent;
  }
  return out;
}

namespace {

// A class whose members are the blocks <kind><first> ...
std::string group_of(const std::string& name, const std::string& kind, int first, int count,
                     const std::vector<std::string>& more_in,
                     const std::vector<std::string>& more_out) {
  std::string in, out, calls, members, each_in, each_out;
  for (int i = first; i < first + count; ++i) {
    const std::string n = std::to_string(i);
    in += cat({"    ", kind, n, "::In p", n, ";\n"});
    out += cat({"    ", kind, n, "::Out p", n, ";\n"});
    each_in += cat({"      p", n, ".each(f);\n"});
    each_out += cat({"      p", n, ".each(f);\n"});
    for (const auto& port : more_in) each_in += cat({"      f(p", n, ".", port, ");\n"});
    for (const auto& port : more_out) each_out += cat({"      f(p", n, ".", port, ");\n"});
    calls += cat({"    out.p", n, " = block", n, "_.tick(in.p", n, ");\n"});
    members += cat({"  ", kind, n, " block", n, "_;\n"});
  }
  const std::string each = "    template <class F>\n    void each(F f) {\n";
  return cat({"class ", name, " {\n public:\n  struct In {\n", in, each, each_in,
              "    }\n  };\n  struct Out {\n", out, each, each_out,
              "    }\n  };\n  Out tick(const In& in) {\n    Out out;\n", calls,
              "    return out;\n  }\n\n private:\n", members, "};\n\n"});
}

}  // namespace

std::string group_text(const std::string& name, int first, int count) {
  return group_of(name, "Random", first, count, {}, {});
}

std::string compiled_group_text(const std::string& name, int first,
                                const std::vector<int>& clocks) {
  // A program's inputs are to be held from start to done.
  std::string blocks = R"(template <class Schedule, class Block>
class Held {
 public:
  using In = typename Schedule::In;
  using Out = typename Schedule::Out;
  Out tick(const In& in) {
    In given;
    static_cast<typename Block::In&>(given) = sample_;
    given.start = start_;
    const Out out = schedule_.tick(given);
    const bool taken = in.start && !out.busy && !start_;
    if (taken) sample_ = in;
    start_ = taken;
    return out;
  }

 private:
  Schedule schedule_;
  typename Block::In sample_;
  bool start_ = false;
};

)";
  for (std::size_t i = 0; i < clocks.size(); ++i) {
    const int seed = first + static_cast<int>(i);
    const std::string n = std::to_string(seed);
    Draw any(static_cast<std::uint64_t>(seed) + 3'000'000'000);
    blocks += cat({"using Compiled", n, " = Held<Scheduled<Random", n, ", Budget{.width = ",
                   any.of({"6", "16", "18", "35"}), ", .second_width = ",
                   any.of({"7", "16", "18", "25"}), ", .clocks = ", std::to_string(clocks[i]), "}>, Random", n, ">;\n"});
  }
  return blocks + "\n" +
         group_of(name, "Compiled", first, static_cast<int>(clocks.size()), {"start"},
                  {"done", "busy", "missed"});
}

}  // namespace hlsgen::test
