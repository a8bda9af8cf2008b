#include "testbench/sweep/row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <sstream>
#include <vector>

#include "testbench/drive_file/drive_file.hpp"

namespace steplock {

using sinusoidal::name_of;

namespace {

std::string cell(double x) { return fmt::format("{:.7g}", x); }
std::string cell(const std::optional<double>& x) { return x ? cell(*x) : ""; }
std::string cell(bool x) { return x ? "1" : "0"; }
std::string cell(int x) { return fmt::format("{}", x); }
std::string cell(std::uint64_t x) { return fmt::format("{}", x); }
std::string cell(const std::string& x) { return x; }
std::string cell(Outcome x) { return name_of(x); }
std::string cell(Reason x) { return name_of(x); }
std::string cell(sinusoidal::Reason x) { return name_of(x); }
std::string cell(Trouble x) { return name_of(x); }
std::string cell(Trial x) { return name_of(x); }
std::string cell(After x) { return name_of(x); }

template <class Number>
bool number(const std::string& text, Number& x) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  return error == std::errc() && end == text.data() + text.size();
}

bool parse(const std::string& t, double& x) { return number(t, x); }
bool parse(const std::string& t, int& x) { return number(t, x); }
bool parse(const std::string& t, std::uint64_t& x) { return number(t, x); }
bool parse(const std::string& t, std::optional<double>& x) {
  return t.empty() || number(t, x.emplace());
}
bool parse(const std::string& t, bool& x) {
  x = t == "1";
  return t == "0" || t == "1";
}
bool parse(const std::string& t, std::string& x) {
  x = t;
  return true;
}
template <class E>
  requires std::is_enum_v<E>
bool parse(const std::string& t, E& x, int count) {
  for (int i = 0; i < count; ++i) {
    x = static_cast<E>(i);
    if (t == name_of(x)) return true;
  }
  return false;
}
bool parse(const std::string& t, Outcome& x) {
  return parse(t, x, static_cast<int>(Outcome::kUnfinished) + 1);
}
bool parse(const std::string& t, Reason& x) {
  return parse(t, x, static_cast<int>(Reason::kBlocked) + 1);
}

bool parse(const std::string& t, sinusoidal::Reason& x) {
  return parse(t, x, static_cast<int>(sinusoidal::Reason::kNoPolarity) + 1);
}
bool parse(const std::string& t, Trouble& x) { return parse(t, x, kTroubles); }
bool parse(const std::string& t, Trial& x) { return parse(t, x, kTrials); }
bool parse(const std::string& t, After& x) { return parse(t, x, kAfters); }

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t from = 0;
  for (;;) {
    const std::size_t comma = line.find(',', from);
    cells.push_back(line.substr(from, comma - from));
    if (comma == line.npos) return cells;
    from = comma + 1;
  }
}

}  // namespace

const char* start_reason(const Row& row) {
  return row.table().sinusoidal() ? name_of(row.findings.sinusoidal_reason) : name_of(row.findings.reason);
}

std::string csv_header(const Table& table) {
  std::string text;
  Row row;
  for_each_column(table, row, [&](const char* name, auto&) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", name);
  });
  return text;
}

std::string csv_line(const Row& row) {
  std::string text;
  bool first = true;
  for_each_column(row.table(), row, [&](const char*, const auto& value) {
    text += (first ? "" : ",") + cell(value);
    first = false;
  });
  return text;
}

Row parse_csv_line(const Table& table, const std::string& text, const std::string& path, int line) {
  const std::vector<std::string> cells = split(text);
  Row row;
  row.kind = table.drive;
  std::size_t k = 0;
  for_each_column(table, row, [&](const char* name, auto& value) {
    if (k >= cells.size() || !parse(cells[k], value)) {
      throw BadInput(fmt::format("{}:{}: {} is \"{}\"; remove this line and go on with --resume", path,
                                 line, name, k < cells.size() ? cells[k] : ""));
    }
    ++k;
  });
  if (k != cells.size()) {
    throw BadInput(fmt::format("{}:{}: {} columns instead of {}; remove this line and go on with "
                               "--resume", path, line, cells.size(), k));
  }
  return row;
}

std::vector<Row> read_rows(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw BadInput(fmt::format("{}:1: cannot read this file; check the name", path));
  std::vector<Row> rows;
  std::string text;
  const std::array tables = {Table(Matrix::kStart), Table(Matrix::kDisturb), Table(Matrix::kHard),
                             Table(Matrix::kStart, design::DriveKind::kSinusoidal)};
  auto table = tables.end();
  for (int line = 1; std::getline(in, text) && !in.eof(); ++line) {
    if (line > 1) {
      rows.push_back(parse_csv_line(*table, text, path, line));
    } else if (table = std::ranges::find_if(tables, [&](const Table& t) { return csv_header(t) == text; });
               table == tables.end()) {
      throw BadInput(fmt::format("{}:1: these are not the columns of this version; begin anew in "
                                 "another folder", path));
    }
  }
  return rows;
}

}  // namespace steplock
