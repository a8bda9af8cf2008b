#include "testbench/report/word_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace steplock {
namespace {

using Json = nlohmann::ordered_json;

Json finite(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

double error_percent(const design::WordRow& w) {
  return w.wanted != 0 ? 100 * w.error() / w.wanted : 0;
}

}  // namespace

std::string word_table(const std::vector<design::WordRow>& rows) {
  std::string text =
      fmt::format("\nconfiguration words\n  {:<26}{:>10} {:>13} {:>13} {:<10}{:>10}\n", "word", "value",
                  "wanted", "stands for", "unit", "error");
  for (const design::WordRow& w : rows) {
    text += fmt::format("  {:<26}{:>10} {:>13.6g} {:>13.6g} {:<10}{:>8.3f} %\n", w.name, w.word,
                        w.wanted, w.meant, w.unit, error_percent(w));
  }
  return text;
}

Json word_table_json(const std::vector<design::WordRow>& rows) {
  Json json = Json::array();
  for (const design::WordRow& w : rows) {
    json.push_back({{"name", w.name},
                    {"word", w.word},
                    {"unit", w.unit},
                    {"wanted", finite(w.wanted)},
                    {"meant", finite(w.meant)},
                    {"error", finite(w.error())},
                    {"error_percent", finite(error_percent(w))}});
  }
  return json;
}

}  // namespace steplock
