// The map's rules, each broken once; and the map against the drive's printed ports.
#include "hls/bus/six_step_registers.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <string>

namespace steplock {
namespace {

constexpr Field kGood{"A", "a", 0, 0, 8, Access::kReadWrite, 255, "", "prose"};

// The rule that a second field beside kGood breaks.
constexpr std::string_view broken(const Field& second) {
  const std::array fields = {kGood, second};
  const char* what = problem(fields);
  return what == nullptr ? "" : what;
}

// At compile time, as in the map itself.
static_assert(broken({"A", "b", 0, 8, 1, Access::kReadWrite, 1, "", "p"}) == "");
static_assert(broken({"A", "b", 0, 7, 1, Access::kReadWrite, 0, "", "p"}) == "two fields overlap");
static_assert(broken({"A", "b", 0, 31, 2, Access::kReadWrite, 0, "", "p"}) ==
              "a field does not fit its register");
static_assert(broken({"A", "b", 0, 8, 0, Access::kReadWrite, 0, "", "p"}) ==
              "a field does not fit its register");
static_assert(broken({"A", "b", 0, 8, 2, Access::kReadWrite, 4, "", "p"}) ==
              "a reset does not fit its field");
static_assert(broken({"A", "a", 0, 8, 2, Access::kReadWrite, 0, "", "p"}) ==
              "two fields of a register share a name");
static_assert(broken({"A", "b", 0, 8, 2, Access::kStopped, 0, "", "p"}) ==
              "a register mixes two kinds of write access");
static_assert(broken({"A", "b", 0, 8, 2, Access::kReadOnly, 0, "", "p"}) == "");
static_assert(broken({"B", "b", 0, 8, 2, Access::kReadWrite, 0, "", "p"}) ==
              "a register has two addresses, or an address two registers");
static_assert(broken({"A", "b", 4, 8, 2, Access::kReadWrite, 0, "", "p"}) ==
              "a register has two addresses, or an address two registers");
static_assert(broken({"B", "b", 6, 0, 1, Access::kReadWrite, 0, "", "p"}) ==
              "an address is not a multiple of 4");
static_assert(broken({"B", "b", kMapBytes, 0, 1, Access::kReadWrite, 0, "", "p"}) ==
              "an address lies beyond the map");
static_assert(broken({"B", "", 4, 0, 1, Access::kReadWrite, 0, "", "p"}) ==
              "a field without a name");
static_assert(broken({"B", "b", 4, 0, 1, Access::kReadWrite, 0, "", ""}) ==
              "a field without prose");

TEST(RegisterFields, TheMapBreaksNoRule) { EXPECT_EQ(problem(kFields), nullptr); }

// Bits of every input of the drive whose name begins with `words_`.
std::map<std::string, int> word_ports() {
  std::ifstream file(STEPLOCK_ROOT "/rtl/six_step_top.sv");
  std::map<std::string, int> ports;
  const std::regex port(R"( *input +logic *(\[(\d+):0\])? *words_(\w+)_i.*)");
  std::smatch found;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_match(line, found, port)) {
      ports[found[3]] = found[2].matched ? std::stoi(found[2]) + 1 : 1;
    }
  }
  return ports;
}

TEST(RegisterFields, EveryWordOfTheDriveHasOnePlaceOfItsWidth) {
  const auto ports = word_ports();
  ASSERT_GT(ports.size(), 50u);
  int bits = 0, map_bits = 0;
  for (const auto& [name, width] : ports) bits += width;
  std::apply([&](const auto&... row) { ((map_bits += row.width), ...); }, kWordRows);
  EXPECT_EQ(std::tuple_size_v<std::remove_cv_t<decltype(kWordRows)>>, ports.size());
  EXPECT_EQ(map_bits, bits);
}

// Each row moves a word that no row before it has moved.
TEST(RegisterFields, NoTwoPlacesAreOfOneWord) {
  std::map<const void*, int> seen;
  Words words;
  std::apply(
      [&](const auto&... row) {
        ((++seen[static_cast<const void*>(&std::remove_cvref_t<decltype(row)>::Word::of(words))]),
         ...);
      },
      kWordRows);
  for (const auto& [address, times] : seen) EXPECT_EQ(times, 1);
  EXPECT_EQ(seen.size(), std::tuple_size_v<std::remove_cv_t<decltype(kWordRows)>>);
}

TEST(RegisterFields, ResetsAreThoseOfTheWords) {
  EXPECT_EQ(reset_of("PWM"), 1u << 24);
  EXPECT_EQ(reset_of("LOOP_PLACE"), 0x40008000u);
  EXPECT_EQ(reset_of("LOOP"), 3u);  // every step, per step
}

}  // namespace
}  // namespace steplock
