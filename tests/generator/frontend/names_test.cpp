#include "generator/names.hpp"

#include <gtest/gtest.h>

namespace hlsgen {
namespace {

TEST(Names, ClassesBecomeSnakeCase) {
  EXPECT_EQ(snake_case("SixStepTop"), "six_step_top");
  EXPECT_EQ(snake_case("PIControl"), "pi_control");
  EXPECT_EQ(snake_case("Uart16550"), "uart16550");
  EXPECT_EQ(snake_case("already_small"), "already_small");
}

TEST(Names, PathsBecomeOneIdentifier) {
  EXPECT_EQ(flat_name("config.kp"), "config_kp");
  EXPECT_EQ(flat_name("history[3]"), "history_3");
  EXPECT_EQ(flat_name("samples_[3].value"), "samples_3_value");
  EXPECT_EQ(flat_name("grid[1][2]"), "grid_1_2");
  EXPECT_EQ(flat_name("phase_"), "phase");
}

TEST(Names, PortsCarryTheirDirection) {
  const Leaf leaf{"config.kp", 16, false, -1, ""};
  EXPECT_EQ(port_name(leaf, Direction::kIn), "config_kp_i");
  EXPECT_EQ(port_name(leaf, Direction::kOut), "config_kp_o");
}

TEST(Names, KeywordsAreKnownInWhateverCase) {
  for (const char* word : {"wire", "Table", "ALWAYS_FF", "accept_on", "xor"}) {
    EXPECT_TRUE(is_keyword(word)) << word;
  }
  for (const char* word : {"phase", "wires", "", "tick"}) EXPECT_FALSE(is_keyword(word)) << word;
}

}  // namespace
}  // namespace hlsgen
