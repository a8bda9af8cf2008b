// Every file in tests/generator/refuse is refused: exit code 1, one line `file:line: error: what;
// how to mend` at the line and with the words that its own comment `// refused: words` gives,
// nothing written.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Result {
  int code = -1;
  std::string errors;
};

Result run_hlsgen(const std::string& source, const fs::path& out) {
  const std::string command = std::string(HLSGEN_PROGRAM) + " " + source + " -o " + out.string() +
                              "/rtl --ports " + out.string() + "/ports --plain " + out.string() +
                              "/plain --depfile " + out.string() + "/deps.d 2>&1 >/dev/null";
  Result result;
  FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 256> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) result.errors += buffer.data();
  const int status = ::pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

struct Expected {
  int line = 0;
  std::string words;
};

Expected expected_of(const std::string& source) {
  constexpr std::string_view kMark = "// refused: ";
  std::ifstream stream(source);
  std::string text;
  for (int line = 1; std::getline(stream, text); ++line) {
    const auto mark = text.find(kMark);
    if (mark != std::string::npos) return {line, text.substr(mark + kMark.size())};
  }
  return {};
}

std::vector<std::string> sources() {
  fs::current_path(HLSGEN_ROOT);  // messages name files relative to it
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator("tests/generator/refuse")) {
    names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class Refusal : public testing::TestWithParam<std::string> {};

TEST_P(Refusal, NamesLineReasonAndMendAndWritesNothing) {
  fs::current_path(HLSGEN_ROOT);
  const std::string source = "tests/generator/refuse/" + GetParam() + ".cpp";
  const auto expected = expected_of(source);
  ASSERT_NE(expected.line, 0) << "the test source has no `// refused: words`";
  const fs::path out = fs::path(testing::TempDir()) / ("hlsgen_refuse_" + GetParam());
  fs::remove_all(out);

  const auto result = run_hlsgen(source, out);

  EXPECT_EQ(result.code, 1);
  const std::string start = source + ":" + std::to_string(expected.line) + ": error: ";
  EXPECT_EQ(result.errors.substr(0, start.size()), start) << result.errors;
  EXPECT_NE(result.errors.find(expected.words), std::string::npos) << result.errors;
  EXPECT_NE(result.errors.find("; "), std::string::npos) << "no mend in: " << result.errors;
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
  EXPECT_FALSE(fs::exists(out)) << "something was written";
}

INSTANTIATE_TEST_SUITE_P(Of, Refusal, testing::ValuesIn(sources()),
                         [](const auto& info) { return info.param; });

// The manual's list is printed from these sources; HLSGEN_PRINT=1 prints it anew.
TEST(RefusalControl, TheManualListsEveryRefusal) {
  fs::current_path(HLSGEN_ROOT);
  std::string page =
      "# What hlsgen refuses\n\nPrinted from tests/generator/refuse by refusal_test; do not edit.\n\n"
      "| test source | what it says |\n|---|---|\n";
  for (const auto& name : sources()) {
    const std::string source = "tests/generator/refuse/" + name + ".cpp";
    auto errors = run_hlsgen(source, fs::path(testing::TempDir()) / "hlsgen_refuse_list").errors;
    const auto start = errors.find("error: ");
    ASSERT_NE(start, std::string::npos) << errors;
    errors = errors.substr(start + 7);
    errors.pop_back();
    page += "| [" + name + "](../" + source + ") | " + errors + " |\n";
  }
  const std::string manual = "docs/generator_refusals.md";
  if (std::getenv("HLSGEN_PRINT") != nullptr) std::ofstream(manual) << page;
  std::ostringstream present;
  present << std::ifstream(manual).rdbuf();
  EXPECT_EQ(present.str(), page) << "run HLSGEN_PRINT=1 refusal_test and look at the change";
}

// The control: the same program takes a source without a fault.
TEST(RefusalControl, ASoundSourceIsTaken) {
  fs::current_path(HLSGEN_ROOT);
  const fs::path out = fs::path(testing::TempDir()) / "hlsgen_refuse_control";
  fs::remove_all(out);
  const auto result = run_hlsgen("tests/generator/frontend/blocks.cpp --top sector_counter", out);
  EXPECT_EQ(result.code, 0) << result.errors;
  EXPECT_TRUE(fs::exists(out / "rtl/sector_counter.sv"));
  fs::remove_all(out);
}

TEST(RefusalControl, AMissingFileIsSaidInOneLine) {
  const auto result = run_hlsgen("tests/generator/refuse/nowhere.cc", "nowhere");
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.errors,
            "tests/generator/refuse/nowhere.cc:1: error: there is no such file; check the path\n");
}

}  // namespace
