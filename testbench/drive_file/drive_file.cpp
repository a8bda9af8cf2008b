#include "testbench/drive_file/drive_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "model/design/believed.hpp"
#include "model/design/settings_keys.hpp"
#include "testbench/drive_file/quantity.hpp"
#include "testbench/drive_file/renamed_keys.hpp"
#include "testbench/drive_file/fitted_defaults.hpp"
#include "testbench/drive_file/sheet_terms.hpp"

namespace steplock {
namespace {

using design::Key;

struct Problem {
  int line;
  std::string text;
};

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

std::string kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "a list";
    case toml::node_type::string: return fmt::format("\"{}\"", **node.as_string());
    case toml::node_type::integer: return fmt::format("the integer {}", **node.as_integer());
    case toml::node_type::floating_point: return fmt::format("the number {}", **node.as_floating_point());
    case toml::node_type::boolean: return **node.as_boolean() ? "true" : "false";
    default: return "a date or time";
  }
}

// The word of a list nearest to a misspelt one, if it is near at all.
template <class Config>
std::string nearest(std::string_view word, const Config& config) {
  const auto distance = [&](std::string_view other) {
    std::vector<std::size_t> row(other.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 0; i < word.size(); ++i) {
      std::size_t diagonal = row[0]++;
      for (std::size_t j = 0; j < other.size(); ++j) {
        const std::size_t change = diagonal + (word[i] != other[j]);
        diagonal = row[j + 1];
        row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, change});
      }
    }
    return row.back();
  };
  // A unit suffix that is wrong (`inductance_uh`) leaves the stem right.
  const auto stem = [](std::string_view s) { return s.substr(0, s.rfind('_')); };
  std::string best;
  std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const auto& candidate : config) {
    const std::size_t d = stem(word) == stem(candidate) ? 1 : distance(candidate);
    if (d < least) least = d, best = candidate;
  }
  return best;
}

class Loader {
 public:
  Loader(const toml::table& root, DriveFile& file) : root_(root), file_(file) {}

  std::vector<Problem> load() {
    for_each_key(file_.settings, [this](const Key& key, auto& value) { take(key, value); });
    SheetTerms terms;
    for_each_term(terms, [this](const Key& key, auto& value) { take(key, value); });
    for (const TermProblem& p : take_terms(terms, file_.settings, file_.line_of)) say_at(file_.line_of.at(p.key), p.text);
    for (const Missing& m : missing_) {
      // What a term tells, or an estimate would, lacks something else, which is named itself.
      const bool told =
          std::ranges::any_of(m.terms, [&](std::string_view term) { return file_.line_of.contains(fmt::format("motor.{}", term)); });
      if (!file_.line_of.contains(m.key) && !told && !(is_estimated(m.key) && !problems_.empty())) problems_.push_back(m.problem);
    }
    find_unknown();
    if (problems_.empty()) fit_defaults(file_.settings, file_.line_of);
    return std::move(problems_);
  }

 private:
  template <class T>
  void take(const Key& key, T& value) {
    const std::string section(key.section), name(key.name);
    const bool first = keys_.try_emplace(section).second;
    keys_[section].push_back(name);
    const toml::node* table = root_.get(section);
    if (first) {
      if (table) file_.line_of[section] = line_of(*table);
      if (table && !table->is_table()) {
        say(*table, "{} is {}; make it a section: [{}]", section, kind_of(*table), section);
      }
    }
    const toml::node* node =
        table && table->is_table() ? table->as_table()->get(name) : nullptr;
    if (!node) {
      if (key.required && !(table && !table->is_table())) {
        const auto terms = terms_of(section, name);
        missing_.push_back({section + "." + name, terms,
                            {table ? line_of(*table) : 1,
                             fmt::format("{}.{} is missing; add it{}: {}{}{}", section, name,
                                         key.unit.empty() ? "" : fmt::format(" in {}", key.unit), key.about,
                                         terms.empty() ? "" : "; or ", fmt::join(terms, " or "))}});
      }
      return;
    }
    where_ = section + "." + name;
    file_.line_of[where_] = line_of(*node);
    read(key, *node, value);
  }

  // What a data sheet prints instead, in [motor] as well.
  static std::vector<std::string_view> terms_of(const std::string& section, const std::string& name) {
    std::vector<std::string_view> terms;
    const SheetTerms none;
    for_each_term(none, [&](const Key& term, const auto&) {
      if (term.section == section && term.about.starts_with(name + ":")) terms.push_back(term.name);
    });
    return terms;
  }

  void read(const Key& key, const toml::node& node, double& value) {
    double x = 0;
    if (const auto number = node.value<double>(); number && node.is_number()) {
      x = *number;
    } else if (const auto text = node.value<std::string>(); text && node.is_string()) {
      if (!convert(key, node, *text, x)) return;
    } else {
      say(node, "{} is {}; give a number{}", where_, kind_of(node),
          key.unit.empty() ? "" : fmt::format(" in {}", key.unit));
      return;
    }
    if (in_range(key, node, x)) value = x;
  }

  bool convert(const Key& key, const toml::node& node, const std::string& text, double& x) {
    const std::string unit(key.unit);
    // "step", a part of a turn, is no unit of the world: such keys take plain numbers only.
    const auto wanted = parse_unit(key.unit);
    const auto given = parse_quantity(text);
    if (!given) {
      say(node, "{} = \"{}\" is no quantity; write a number{}", where_, text,
          unit.empty() ? "" : fmt::format(" in {}", unit));
      return false;
    }
    if (!wanted || !wanted->accepts(given->dimension)) {
      say(node, "{} = \"{}\" has the wrong unit; {}", where_, text,
          unit.empty() ? "it has none, write a plain number" : fmt::format("give it in {}", unit));
      return false;
    }
    x = given->value / wanted->factor;
    return true;
  }

  bool in_range(const Key& key, const toml::node& node, double x) {
    if (x >= key.low && x <= key.high) return true;
    const std::string unit = key.unit.empty() ? "" : " " + std::string(key.unit);
    say(node, "{} is {:g}{}; it must lie in {:g} to {:g}{}", where_, x, unit, key.low, key.high, unit);
    return false;
  }

  void read(const Key& key, const toml::node& node, std::optional<double>& value) {
    double x = 0;
    const std::size_t before = problems_.size();
    read(key, node, x);
    if (problems_.size() == before) value = x;
  }

  void read(const Key& key, const toml::node& node, int& value) {
    if (!node.is_integer()) {
      say(node, "{} is {}; give an integer", where_, kind_of(node));
      return;
    }
    const auto x = static_cast<double>(**node.as_integer());
    if (in_range(key, node, x)) value = static_cast<int>(x);
  }

  void read(const Key&, const toml::node& node, bool& value) {
    if (!node.is_boolean()) {
      say(node, "{} is {}; write true or false", where_, kind_of(node));
      return;
    }
    value = **node.as_boolean();
  }

  void read(const Key& key, const toml::node& node, std::string& value) {
    if (!node.is_string()) {
      say(node, "{} is {}; write a text in quotes", where_, kind_of(node));
      return;
    }
    value = **node.as_string();
    if (key.required && value.empty()) say(node, "{} is empty; {}", where_, key.about);
  }

  template <class E>
    requires std::is_enum_v<E>
  void read(const Key&, const toml::node& node, E& value) {
    const auto config = enum_words(E{});
    std::string all;
    for (const char* word : config) all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", word);
    if (node.is_string()) {
      const std::string& text = **node.as_string();
      for (std::size_t i = 0; i < config.size(); ++i) {
        if (text == config[i]) {
          value = static_cast<E>(i);
          return;
        }
      }
    }
    say(node, "{} is {}; write one of {}", where_, kind_of(node), all);
  }

  template <std::size_t N>
  void read(const Key& key, const toml::node& node, std::array<double, N>& value) {
    if (!node.is_array() || node.as_array()->size() != N) {
      say(node, "{} is {}; give a list of {}", where_, kind_of(node),
          N == 3 ? "three, one per phase" : "two: from, to");
      return;
    }
    for (std::size_t i = 0; i < N; ++i) read(key, *node.as_array()->get(i), value[i]);
  }

  void read(const Key& key, const toml::node& node, std::vector<double>& value) {
    if (!node.is_array()) {
      say(node, "{} is {}; give a list of numbers", where_, kind_of(node));
      return;
    }
    value.clear();  // of a default
    for (const toml::node& element : *node.as_array()) read(key, element, value.emplace_back());
  }

  void read(const Key& key, const toml::node& node, std::vector<std::string>& value) {
    if (!node.is_array()) {
      say(node, "{} is {}; give a list of texts", where_, kind_of(node));
      return;
    }
    for (const toml::node& element : *node.as_array()) read(key, element, value.emplace_back());
  }

  void find_unknown() {
    for (const auto& [section, node] : root_) {
      const auto known = keys_.find(std::string(section.str()));
      if (known == keys_.end()) {
        std::vector<std::string> names;
        for (const auto& [name, keys] : keys_) names.push_back(name);
        const std::string near = nearest(section.str(), names);
        say_at(static_cast<int>(section.source().begin.line),
               fmt::format("{} is no section of a drive file; {}", section.str(),
                           near.empty() ? "remove it" : fmt::format("did you mean [{}]?", near)));
        continue;
      }
      if (!design::belongs(section.str(), file_.settings.drive.kind)) {
        say_at(static_cast<int>(section.source().begin.line),
               fmt::format("[{}] is not for drive.kind = \"{}\"; remove it, or name the other kind",
                           section.str(),
                           enum_words(design::DriveKind{})[static_cast<std::size_t>(
                               file_.settings.drive.kind)]));
        continue;
      }
      if (!node.is_table()) continue;
      for (const auto& [key, value] : *node.as_table()) {
        if (!design::belongs(section.str(), key.str(), file_.settings.drive.kind)) {
          say_at(static_cast<int>(key.source().begin.line),
                 fmt::format("{}.{} is not for drive.kind = \"{}\"; remove it", section.str(), key.str(),
                             enum_words(design::DriveKind{})[static_cast<std::size_t>(
                                 file_.settings.drive.kind)]));
          continue;
        }
        if (std::ranges::find(known->second, key.str()) != known->second.end()) continue;
        const std::string near = nearest(key.str(), known->second);
        const std::string_view now = renamed_key(key.str(), known->second);
        say_at(static_cast<int>(key.source().begin.line),
               !now.empty() ? fmt::format("{}.{} is called {} now; rename it", section.str(), key.str(), now)
                            : fmt::format("{}.{} is an unknown key; {}", section.str(), key.str(),
                                          near.empty() ? "remove it" : fmt::format("did you mean {}?", near)));
      }
    }
  }

  template <class... A>
  void say(const toml::node& node, fmt::format_string<A...> text, A&&... a) {
    say_at(line_of(node), fmt::format(text, std::forward<A>(a)...));
  }
  void say_at(int line, std::string text) { problems_.push_back({line, std::move(text)}); }

  const toml::table& root_;
  DriveFile& file_;
  std::map<std::string, std::vector<std::string>> keys_;
  std::string where_;
  std::vector<Problem> problems_;
  struct Missing {
    std::string key;
    std::vector<std::string_view> terms;
    Problem problem;
  };
  std::vector<Missing> missing_;  // required keys, unless something else tells them
};

[[noreturn]] void refuse(const std::string& path, std::vector<Problem> problems) {
  std::ranges::stable_sort(problems, {}, &Problem::line);
  std::string all;
  for (const Problem& p : problems) {
    all += fmt::format("{}{}:{}: {}", all.empty() ? "" : "\n", path, p.line, p.text);
  }
  throw BadInput(all);
}

}  // namespace

DriveFile parse_drive_file(const std::string& text, const std::string& path) {
  DriveFile file;
  file.path = path;
  toml::table root;
  try {
    root = toml::parse(text, path);
  } catch (const toml::parse_error& e) {
    throw BadInput(fmt::format("{}:{}: {}; mend the TOML syntax there", path, e.source().begin.line,
                               e.description()));
  }
  if (auto problems = Loader(root, file).load(); !problems.empty()) refuse(path, problems);
  // So that each report says it.
  if (const std::string believed = design::beliefs(file.settings); !believed.empty()) file.settings.drive.name += ", " + believed;
  return file;
}

DriveFile load_drive_file(const std::string& path) {
  std::ifstream in(path);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) {
    throw BadInput(fmt::format("{}:1: cannot read this file; check the name", path));
  }
  return parse_drive_file(text.str(), path);
}

}  // namespace steplock
