// Prints the mutants of a block's header or of a part of the model: changes of one token, or a statement that is left out.
//
//     draw_mutants FILE...      a line each: FILE <tab> line <tab> column <tab> what stands there <tab> what comes instead
//
// Left alone is what is no behaviour: comments, includes, declarations (a register's value at power-up is the reset's), asserts,
// and the quiet clocks of the fast engine, from `// Quiet clocks` to operator==, which tests/testbench holds to the block.
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Rule {
  std::regex token;  // its first group is replaced
  const char* by;
};

using Tokens = std::vector<std::pair<const char*, const char*>>;

std::vector<Rule> rules_of(const Tokens& tokens) {
  std::vector<Rule> some;
  for (const auto& [token, by] : tokens) some.push_back({std::regex(token), by});
  return some;
}

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = rules_of({
      {" (&&) ", "||"}, {" (\\|\\|) ", "&&"}, {" (==) ", "!="}, {" (!=) ", "=="}, {" (<) ", "<="}, {" (<=) ", "<"}, {" (>) ", ">="},
      {" (>=) ", ">"}, {" (\\+) ", "-"}, {" (-) ", "+"}, {" (\\^) ", "|"}, {"[(&|= ](!)[A-Za-z(]", ""}, {"\\b(true)\\b", "false"},
      {"\\b(false)\\b", "true"}, {"(?:==|!=|<|>|>=|<=|>>|<<|\\+|-) (\\d+)\\b", "+1"}});
  return all;
}

// The model's arithmetic: signs, products and quotients.
const std::vector<Rule>& rules_of_models() {
  static const std::vector<Rule> all = rules_of({
      {" (\\*) ", "/"}, {" (/) ", "*"}, {"(?:= |return |[(,:?] ?)(-)[a-z(]", ""}, {" (\\+=) ", "-="}, {" (-=) ", "+="}});
  return all;
}

// No behaviour of its own.
bool is_declaration(const std::string& code) {
  static const std::regex member(R"(^\s*(static |constexpr |using |enum |struct |class |public:|private:|protected:|template|namespace |#|\}|static_assert|assert))");
  static const std::regex field(R"(^\s*[A-Z]?[\w:]*(<.*>)?[ ]\w+( = [^=;]*| \{.*\})?;\s*$)");
  static const std::regex returns(R"(^\s*(return|const|auto)\b)");
  return std::regex_search(code, member) || (std::regex_search(code, field) && !std::regex_search(code, returns));
}

void print(const std::string& file, std::size_t line, std::size_t column, const std::string& from, const std::string& to) {
  fmt::print("{}\t{}\t{}\t{}\t{}\n", file, line, column, from, to);
}

void draw(const std::string& file) {
  std::ifstream in(file);
  if (!in) {
    fmt::print(stderr, "draw_mutants: {} cannot be read; name a header of hls/ or a source of model/plant\n", file);
    std::exit(2);
  }
  static const std::regex register_takes(R"(^\s*((?:if \(.*\) )?\w+_(?:\.\w+)? = .*;)\s*$)");
  static const std::regex variable_takes(R"(^\s*((?:if \(.*\) )?[\w.\[\]]+ [-+*/]?= [^;]*;)\s*$)");
  const bool model = file.starts_with("model/");
  std::vector<Rule> here = rules();
  if (model) here.insert(here.end(), rules_of_models().begin(), rules_of_models().end());
  bool quiet = false;
  std::string text;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    if (text.find("// Quiet clocks") != std::string::npos) quiet = true;
    if (text.find("operator==") != std::string::npos) quiet = false;
    const std::string code = text.substr(0, text.find("//"));
    if (quiet || code.empty() || code.find("operator") != std::string::npos || is_declaration(code)) continue;
    for (const Rule& rule : here) {
      for (auto it = std::sregex_iterator(code.begin(), code.end(), rule.token); it != std::sregex_iterator(); ++it) {
        const std::string from = (*it)[1];
        const bool number = std::string(rule.by) == "+1";
        print(file, line, static_cast<std::size_t>(it->position(1)) + 1, from, number ? std::to_string(std::stoll(from) + 1) : rule.by);
      }
    }
    std::smatch statement;
    if (std::regex_match(code, statement, model ? variable_takes : register_takes)) {
      print(file, line, static_cast<std::size_t>(statement.position(1)) + 1, statement[1], ";");
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "draw_mutants: no file; write draw_mutants hls/six_step/protection.hpp\n");
    return 2;
  }
  for (int k = 1; k < argc; ++k) draw(argv[k]);
  return 0;
}
