#include "testbench/drive_file/quantity.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <span>

namespace steplock {
namespace {

struct Base {
  std::string_view name;
  Unit unit;
  bool prefixes = true;
};

constexpr double kTurn = 2 * std::numbers::pi;

const Base kBases[] = {
    {"m", {1, {1, 0, 0, 0, 0}}},
    {"g", {1e-3, {0, 1, 0, 0, 0}}},
    {"s", {1, {0, 0, 1, 0, 0}}},
    {"A", {1, {0, 0, 0, 1, 0}}},
    {"V", {1, {2, 1, -3, -1, 0}}},
    {"ohm", {1, {2, 1, -3, -2, 0}}},
    {"H", {1, {2, 1, -2, -2, 0}}},
    {"F", {1, {-2, -1, 4, 2, 0}}},
    {"Wb", {1, {2, 1, -2, -1, 0}}},
    {"N", {1, {1, 1, -2, 0, 0}}},
    {"W", {1, {2, 1, -3, 0, 0}}},
    {"J", {1, {2, 1, -2, 0, 0}}},
    {"Hz", {kTurn, {0, 0, -1, 0, 1}}},
    {"rpm", {kTurn / 60, {0, 0, -1, 0, 1}}},
    {"rad", {1, {0, 0, 0, 0, 1}}},
    {"deg", {kTurn / 360, {0, 0, 0, 0, 1}}, false},
    {"turn", {kTurn, {0, 0, 0, 0, 1}}, false},
    {"min", {60, {0, 0, 1, 0, 0}}, false},
    {"%", {0.01, {}}, false},
    {"1", {1, {}}, false},
};

struct Prefix {
  std::string_view name;
  double factor;
};
constexpr Prefix kPrefixes[] = {{"p", 1e-12}, {"n", 1e-9}, {"u", 1e-6}, {"\u00b5", 1e-6},
                                {"m", 1e-3},  {"c", 1e-2}, {"k", 1e3},  {"M", 1e6},
                                {"G", 1e9}};

std::optional<Unit> named(std::string_view name) {
  for (const Base& base : kBases) {
    if (name == base.name) return base.unit;
  }
  for (const Prefix& prefix : kPrefixes) {
    if (!name.starts_with(prefix.name)) continue;
    for (const Base& base : kBases) {
      if (!base.prefixes || name.substr(prefix.name.size()) != base.name) continue;
      Unit unit = base.unit;
      unit.factor *= prefix.factor;
      return unit;
    }
  }
  return std::nullopt;
}

void multiply(Unit& product, const Unit& factor, int power) {
  product.factor *= std::pow(factor.factor, power);
  for (std::size_t i = 0; i < product.exponent.size(); ++i) {
    product.exponent[i] += power * factor.exponent[i];
  }
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) {
    text.remove_prefix(1);
  }
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) {
    text.remove_suffix(1);
  }
  return text;
}

}  // namespace

bool Unit::accepts(const Unit& given) const {
  for (std::size_t i = 0; i < 4; ++i) {
    if (exponent[i] != given.exponent[i]) return false;
  }
  return exponent[4] == given.exponent[4] || (exponent[4] < 0 && given.exponent[4] == 0);
}

std::optional<Unit> parse_unit(std::string_view text) {
  Unit product;
  text = trimmed(text);
  int sign = 1;
  bool want_factor = false;
  while (!text.empty()) {
    const char c = text.front();
    if (c == ' ') {
      text.remove_prefix(1);
      continue;
    }
    if (c == '*' || c == '/') {
      if (want_factor) return std::nullopt;
      sign = c == '/' ? -1 : 1;
      want_factor = true;
      text.remove_prefix(1);
      continue;
    }
    const std::size_t end = text.find_first_of(" */");
    std::string_view factor = text.substr(0, end);
    text.remove_prefix(factor.size());
    int power = 1;
    if (const std::size_t hat = factor.find('^'); hat != factor.npos) {
      const std::string_view digits = factor.substr(hat + 1);
      const auto [stop, error] =
          std::from_chars(digits.data(), digits.data() + digits.size(), power);
      if (error != std::errc() || stop != digits.data() + digits.size()) return std::nullopt;
      factor = factor.substr(0, hat);
    }
    const std::optional<Unit> unit = named(factor);
    if (!unit || power < -9 || power > 9) return std::nullopt;
    multiply(product, *unit, sign * power);
    sign = 1;
    want_factor = false;
  }
  if (want_factor) return std::nullopt;
  return product;
}

std::optional<Quantity> parse_quantity(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  const std::string_view unit_text = trimmed(text.substr(stop - text.data()));
  const std::optional<Unit> unit = parse_unit(unit_text);
  if (!unit) return std::nullopt;
  return Quantity{value * unit->factor, std::string(unit_text), *unit};
}

}  // namespace steplock
