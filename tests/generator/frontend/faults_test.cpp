// Each way to end without an exception ends in one line.
#include "generator/faults.hpp"

#include <gtest/gtest.h>
#include <llvm/ADT/APInt.h>
#include <llvm/Support/ErrorHandling.h>

#include <csignal>
#include <cstdlib>

namespace hlsgen {
namespace {

// [^\n]* and the end: one line and no other.
std::string line(const std::string& what) {
  return "^hlsgen: internal error: hls/x.cpp: " + what + ", while reading the C..; please report it with this source\n$";
}

void begin() {
  name_faults("hls/x.cpp");
  working_on("reading the C++");
}

TEST(FaultsDeathTest, LlvmsOwnEndHasItsReason) {
  EXPECT_EXIT((begin(), llvm::report_fatal_error("no such thing\nat all", false)), testing::ExitedWithCode(2),
              line("LLVM: no such thing at all"));
}

TEST(FaultsDeathTest, AnAbortIsNamed) {
  EXPECT_EXIT((begin(), std::abort()), testing::ExitedWithCode(2), line("it was aborted"));
}

TEST(FaultsDeathTest, ABrokenPointerIsNamed) {
  EXPECT_EXIT((begin(), std::raise(SIGSEGV)), testing::ExitedWithCode(2), line("it used a bad address"));
}

// The negative control: without the handlers there is no such line.
TEST(FaultsDeathTest, WithoutThemNothingIsSaid) {
  EXPECT_EXIT(std::abort(), testing::KilledBySignal(SIGABRT), "^$");
}

}  // namespace
}  // namespace hlsgen
