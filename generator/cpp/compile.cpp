#include "generator/cpp/compile.hpp"

#include <llvm/ADT/StringExtras.h>
#include <llvm/BinaryFormat/Dwarf.h>
#include <llvm/IR/DebugInfo.h>
#include <llvm/IR/InstIterator.h>
#include <llvm/IR/IntrinsicInst.h>
#include <llvm/IRReader/IRReader.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/Path.h>
#include <llvm/Support/Program.h>
#include <llvm/Support/SourceMgr.h>

#include <optional>
#include <regex>

#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

#if defined(__x86_64__)
constexpr const char* kHost = "-D__x86_64__";  // the C library's headers ask for a machine
#elif defined(__aarch64__)
constexpr const char* kHost = "-D__aarch64__";
#else
#error "hlsgen: name the macro by which this machine's C headers know it"
#endif

std::vector<std::string> arguments(const CompileOptions& options, const std::string& clang,
                                   llvm::StringRef output, llvm::StringRef rules) {
  std::vector<std::string> args = {
      clang, "-x", "c++", "-std=c++20", "--target=spir64", "-ffreestanding", kHost, "-D_GNU_SOURCE",
      "-fwrapv",
      "-fno-exceptions", "-fno-rtti", "-fno-strict-aliasing", "-fno-discard-value-names",
      "-fno-threadsafe-statics", "-g", "-gdwarf-5", "-fstandalone-debug", "-O2", "-Xclang",
      "-disable-llvm-passes", "-emit-llvm", "-c", "-fno-color-diagnostics",
      "-fno-caret-diagnostics",
      // Nothing but what makes the hardware differ from the source; style is for the native build.
      "-Wno-everything", "-Werror=uninitialized", "-Werror=sometimes-uninitialized",
      "-Werror=return-type", "-Werror=array-bounds", "-Werror=shift-count-overflow",
      "-Werror=shift-count-negative", "-Werror=division-by-zero", "-Werror=infinite-recursion"};
  for (const auto& directory : options.include_directories) args.push_back("-I" + directory);
  llvm::SmallVector<llvm::StringRef> system;
  llvm::StringRef(HLSGEN_SYSTEM_INCLUDES).split(system, ':', -1, false);
  for (const auto directory : system) {
    args.insert(args.end(), {"-isystem", directory.str()});
  }
  args.insert(args.end(),
              {"-MMD", "-MF", rules.str(), "-MT", "out", options.source, "-o", output.str()});
  return args;
}

std::string mend_for(const std::string& message, const std::string& flag) {
  const auto says = [&](const char* word) { return message.find(word) != std::string::npos; };
  if (flag.find("uninitialized") != std::string::npos) return "give it an initial value";
  if (flag == "array-bounds") return "keep the index inside the array";
  if (flag == "division-by-zero") return "divide by a constant power of two";
  if (flag == "infinite-recursion") return "write it as a loop with a constant bound";
  if (flag == "return-type") return "return a value on every path";
  if (flag.find("shift-count") != std::string::npos) return "shift by less than the width";
  if (says("bit sizes greater than")) return "split it into parts";
  if (says("throw") || says("exceptions")) return "report errors in Out";
  if (says("dynamic_cast") || says("typeid")) return "use types known at compile time";
  return "mend the C++ first";
}

// clang's first error, as one line of ours.
Refusal first_error(const std::string& diagnostics, const std::string& source) {
  static const std::regex pattern(R"((.+?):(\d+):\d+: (?:fatal )?error: (.*?)(?: \[(.*)\])?$)");
  std::istringstream lines(diagnostics);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, pattern)) continue;
    const auto dash = match[4].str().rfind("-W");
    const std::string flag = dash == std::string::npos ? "" : match[4].str().substr(dash + 2);
    llvm::SmallString<128> file(match[1].str());
    llvm::sys::path::remove_dots(file);
    const SourceLine where{file.str().str(), static_cast<unsigned>(std::stoul(match[2]))};
    return {where, match[3], mend_for(match[3], flag)};
  }
  // It crashed, say: its own first line, of many.
  const auto first = diagnostics.find_first_not_of(" \n");
  const std::string said = first == std::string::npos
                               ? "it says nothing"
                               : diagnostics.substr(first, diagnostics.find('\n', first) - first);
  return {{source, 1}, "clang++-16 failed: " + said, "compile the source with it to see all it says"};
}

// Variables of a target with address spaces carry a dereference that says nothing here and would
// keep the variables' names from following their values into registers.
void drop_address_spaces(llvm::Module& module) {
  for (auto& function : module) {
    for (auto& instruction : llvm::instructions(function)) {
      auto* variable = llvm::dyn_cast<llvm::DbgVariableIntrinsic>(&instruction);
      if (variable == nullptr) continue;
      const auto elements = variable->getExpression()->getElements();
      if (!elements.empty() && elements.back() == llvm::dwarf::DW_OP_xderef) {
        variable->setExpression(llvm::DIExpression::get(module.getContext(), {}));
      }
    }
  }
}

struct TemporaryFile {
  explicit TemporaryFile(llvm::StringRef suffix) {
    if (llvm::sys::fs::createTemporaryFile("hlsgen", suffix, path)) {
      throw Refusal({}, "cannot write a temporary file", "free some space or set TMPDIR");
    }
  }
  ~TemporaryFile() { llvm::sys::fs::remove(path); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  llvm::SmallString<128> path;
};

// `out: a.cpp a.hpp \` -> the files, as absolute paths.
std::vector<std::string> prerequisites(llvm::StringRef rules) {
  std::vector<std::string> files;
  auto text = llvm::MemoryBuffer::getFile(rules);
  if (!text) return files;
  llvm::SmallVector<llvm::StringRef> words;
  llvm::SplitString((*text)->getBuffer().split(':').second, words);
  for (const auto word : words) {
    if (word == "\\") continue;
    llvm::SmallString<128> path(word);
    llvm::sys::fs::make_absolute(path);
    llvm::sys::path::remove_dots(path, /*remove_dot_dot=*/true);
    files.push_back(path.str().str());
  }
  return files;
}

}  // namespace

Program compile(const CompileOptions& options) {
  if (!llvm::sys::fs::exists(options.source)) {
    throw Refusal({options.source, 1}, "there is no such file", "check the path");
  }
  auto clang = llvm::sys::findProgramByName("clang++-16");
  if (!clang) {
    throw Refusal({}, "clang++-16 is not installed", "apt-get install clang-16");
  }

  const TemporaryFile output("bc");
  const TemporaryFile diagnostics("txt");
  const TemporaryFile rules("d");

  const auto args = arguments(options, *clang, output.path, rules.path);
  const std::vector<llvm::StringRef> views(args.begin(), args.end());
  const llvm::StringRef nothing;
  std::string failure;
  const int code = llvm::sys::ExecuteAndWait(
      *clang, views, std::nullopt, {nothing, diagnostics.path.str(), diagnostics.path.str()}, 0, 0,
      &failure);
  if (code != 0) {
    auto text = llvm::MemoryBuffer::getFile(diagnostics.path);
    throw first_error(text ? (*text)->getBuffer().str() + failure : failure, options.source);
  }

  Program program;
  program.context = std::make_unique<llvm::LLVMContext>();
  llvm::SMDiagnostic error;
  program.module = llvm::parseIRFile(output.path, error, *program.context);
  if (!program.module) {
    throw Refusal({options.source, 1}, "clang's output cannot be read: " + error.getMessage().str(),
                  "use clang 16 with LLVM 16");
  }
  drop_address_spaces(*program.module);
  program.read = prerequisites(rules.path);
  return program;
}

}  // namespace hlsgen
