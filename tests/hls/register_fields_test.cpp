// The maps' rules, each broken once; and each map against its drive's printed ports.
#include "hls/bus/register_fields.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <string>

#include "hls/bus/sinusoidal_registers.hpp"
#include "hls/bus/six_step_registers.hpp"

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

template <class Map>
struct RegisterFieldsOf : testing::Test {};
using Maps = testing::Types<SixStep, Sinusoidal>;
TYPED_TEST_SUITE(RegisterFieldsOf, Maps);

TYPED_TEST(RegisterFieldsOf, TheMapBreaksNoRule) { EXPECT_EQ(problem(TypeParam::kFields), nullptr); }

// Bits of every input of the drive whose name begins with `config_`.
std::map<std::string, int> word_ports(const std::string& top) {
  std::ifstream file(STEPLOCK_ROOT "/rtl/" + top + ".sv");
  std::map<std::string, int> ports;
  const std::regex port(R"( *input +logic *(\[(\d+):0\])? *config_(\w+)_i.*)");
  std::smatch found;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_match(line, found, port)) {
      ports[found[3]] = found[2].matched ? std::stoi(found[2]) + 1 : 1;
    }
  }
  return ports;
}

template <class Map>
constexpr int kRowsOf = std::tuple_size_v<std::remove_cvref_t<decltype(Map::kWordRows)>>;

TYPED_TEST(RegisterFieldsOf, EveryWordOfTheDriveHasOnePlaceOfItsWidth) {
  const auto ports = word_ports(std::is_same_v<TypeParam, SixStep> ? "six_step_top" : "sinusoidal_top");
  ASSERT_GT(ports.size(), 50u);
  int bits = 0, map_bits = 0;
  for (const auto& [name, width] : ports) bits += width;
  std::apply([&](const auto&... row) { ((map_bits += row.width), ...); }, TypeParam::kWordRows);
  EXPECT_EQ(std::size_t(kRowsOf<TypeParam>), ports.size());
  EXPECT_EQ(map_bits, bits);
}

// Each row moves a word that no row before it has moved.
TYPED_TEST(RegisterFieldsOf, NoTwoPlacesAreOfOneWord) {
  std::map<const void*, int> seen;
  typename TypeParam::Config config;
  std::apply(
      [&](const auto&... row) {
        ((++seen[static_cast<const void*>(&std::remove_cvref_t<decltype(row)>::Word::of(config))]),
         ...);
      },
      TypeParam::kWordRows);
  for (const auto& [address, times] : seen) EXPECT_EQ(times, 1);
  EXPECT_EQ(seen.size(), std::size_t(kRowsOf<TypeParam>));
}

// What the C driver does with either drive stands in the same place of both maps.
TEST(RegisterFields, WhatEveryDriveHasStandsAtTheSamePlace) {
  int same_places = 0;
  for (const Field& f : kFields) {
    for (const Field& g : kSinusoidalFields) {
      const bool common = f.address < 0x30 || same(f.group, "SPEED_TARGET");
      if (!common || f.address != g.address || f.lsb != g.lsb) continue;
      ++same_places;
      EXPECT_TRUE(same(f.group, g.group) && same(f.name, g.name) && f.access == g.access) << f.group << '.' << f.name;
    }
  }
  EXPECT_EQ(same_places, int(system_fields({}).size()) + 1);
}

// A negative number keeps to its own bits.
TEST(RegisterFields, ANegativeWordIsItsBits) {
  EXPECT_EQ(bits_of(Int<16>(-2)), UInt<32>(0xfffe));
  EXPECT_EQ(word_of<Int<16>>(0x7fff'fffe), Int<16>(-2));
}

TEST(RegisterFields, ResetsAreThoseOfTheWords) {
  EXPECT_EQ(reset_of("PWM"), 1u << 24);
  EXPECT_EQ(reset_of("LOOP_PHASE"), 0x40008000u);
  EXPECT_EQ(reset_of("LOOP"), 3u);  // every step, per step
}

}  // namespace
}  // namespace steplock
