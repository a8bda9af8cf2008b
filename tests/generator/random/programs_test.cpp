// The random programs of the fixed seeds hold what docs/generator.md says, each often enough.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "tests/generator/random/program.hpp"

namespace hlsgen::test {
namespace {

constexpr int kPrograms = 320;

const std::vector<std::string>& programs() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> texts;
    for (int seed = 1; seed <= kPrograms; ++seed) {
      texts.push_back(Program(static_cast<std::uint64_t>(seed), "Block", true).text());
    }
    return texts;
  }();
  return all;
}

int programs_with(const std::string& pattern) {
  const std::regex expression(pattern);
  return static_cast<int>(std::count_if(programs().begin(), programs().end(), [&](const auto& text) {
    return std::regex_search(text, expression);
  }));
}

// Helpers stand in every program; what is counted is asked of its tick.
TEST(Programs, HoldEachFeatureOften) {
  const std::pair<const char*, const char*> features[] = {
      {"if with else", R"(\} else \{)"},
      {"switch over the enumeration", R"(switch \((mode_|in\.mode)\))"},
      {"switch over a number", R"(switch \(int\()"},
      {"fall-through", R"(\[\[fallthrough\]\])"},
      {"for", R"(for \(int i\d)"},
      {"while", R"(while \(i\d)"},
      {"break out of a loop", R"(\) break;)"},
      {"continue", R"(\) continue;)"},
      {"early return", R"(return out;\n *\}\n)"},
      {"exact product", R"(const auto p\d)"},
      {"saturation", R"(saturate<)"},
      {"variable shift", R"((<<|>>) int\()"},
      {"slice", R"(template slice<)"},
      {"variable index", R"(a\d_\[[^\]0-9])"},
      {"table", R"(kTable\[)"},
      {"two tables of one name and length", R"(Shape<8>::kShape\[[^$]*Shape<\d\d?>::kShape\[)"},
      {"table of structs, two members of it", R"(kRows\[[^;]*\]\.a[^$]*kRows\[[^;]*\]\.b)"},
      {"table of plain integers", R"(kPlain\[[^\]0-9])"},
      {"table with two indices", R"(kGrid\[[^\]0-9])"},
      {"helper with a return from its loop", R"([^ ]mix\()"},
      {"helper that writes through a reference", R"( add\()"},
      {"closure", R"([^ ]pick\()"},
      {"plain integers", R"(std::u?int(8|16|32|64)_t r\d_)"},
      {"gaps in the enumeration", R"(kB = [2-9])"},
      {"struct as a whole", R"(pair_ = )"},
      {"array as a port", R"( list = \{\})"},
      {"child", R"(child_\.tick\()"},
      {"children in an array", R"(child_\[1\]\.tick\()"},
  };
  for (const auto& [name, pattern] : features) {
    EXPECT_GE(programs_with(pattern), kPrograms / 32) << name << ": /" << pattern << "/";
  }
}

TEST(Programs, HoldEveryWidthUpTo64) {
  for (int width = 1; width <= 64; ++width) {
    if (width > 40 && width != 48 && width < 63) continue;  // these come as products and slices only
    const std::string digits = std::to_string(width);
    EXPECT_GT(programs_with("UInt<" + digits + ">"), 0) << width;
    if (width > 1) {
      EXPECT_GT(programs_with("[^U]Int<" + digits + ">"), 0) << width;
    }
  }
}

TEST(Programs, ComeFromTheirSeedAlone) {
  EXPECT_EQ(Program(7, "Block", true).text(), programs()[6]);
  EXPECT_NE(programs()[6], programs()[7]);
}

// The control: what no program holds is not found.
TEST(Programs, LackWhatIsNotDrawn) { EXPECT_EQ(programs_with("goto|float|double"), 0); }

}  // namespace
}  // namespace hlsgen::test
