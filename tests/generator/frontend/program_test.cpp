// The program hlsgen: the same source gives the same bytes, and nothing else has a say in them.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> files_below(const fs::path& directory) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (!entry.is_regular_file()) continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    files[fs::relative(entry.path(), directory).string()] = text.str();
  }
  return files;
}

// What a run writes, into a folder of the test's own since tests run side by side, and in an environment of its own, so
// that addresses differ.
std::map<std::string, std::string> print(const std::string& arguments, const std::string& name) {
  fs::current_path(HLSGEN_ROOT);
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const fs::path out = fs::path(testing::TempDir()) / ("hlsgen_" + test + "_" + name);
  fs::remove_all(out);
  const std::string command = "PADDING=" + std::string(name.size() * 997 % 4096, 'x') + " " +
                              HLSGEN_PROGRAM + " " + arguments + " -o " + out.string() +
                              " --ports " + out.string() + " --plain " + out.string() + "/plain";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  auto files = files_below(out);
  fs::remove_all(out);
  return files;
}

TEST(Program, TwoRunsGiveTheSameBytes) {
  const std::string arguments = "tests/generator/frontend/blocks.cpp --top hierarchy";
  const auto first = print(arguments, "first");
  EXPECT_EQ(first, print(arguments, "the_second"));
  EXPECT_EQ(first.size(), 13U) << "4 modules, 4 plain, 4 headers, 1 list";
}

TEST(Program, TwoRunsGiveTheSameSchedule) {
  const std::string arguments = "tests/generator/frontend/blocks.cpp --top held_cascade_18_18_66";
  const auto first = print(arguments, "first");
  EXPECT_EQ(first, print(arguments, "the_second"));
  EXPECT_EQ(first.size(), 13U) << "two modules, program and numbers, four plain, four headers, a list";
}

TEST(Program, OtherBlocksInTheSourceDoNotChangeAModule) {
  auto among = print("tests/generator/frontend/blocks.cpp --top state_machine", "among");
  auto alone = print("tests/generator/frontend/alone.cpp", "alone");
  ASSERT_FALSE(alone["state_machine.sv"].empty());
  EXPECT_EQ(among["state_machine.sv"], alone["state_machine.sv"]);
  EXPECT_EQ(among["state_machine_ports.hpp"], alone["state_machine_ports.hpp"]);
}

TEST(Program, TheListNamesChildrenFirst) {
  auto files = print("tests/generator/frontend/blocks.cpp --top hierarchy", "list");
  EXPECT_EQ(files["blocks.f"],
            "rtl/delay_8.sv\nrtl/middle.sv\nrtl/phase_accumulator_12.sv\nrtl/hierarchy.sv\n");
}

}  // namespace
