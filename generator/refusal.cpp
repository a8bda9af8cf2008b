#include "generator/refusal.hpp"

#include <llvm/ADT/SmallString.h>
#include <llvm/IR/DebugLoc.h>
#include <llvm/IR/Function.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/Path.h>

namespace hlsgen {
namespace {

std::string in_words(const SourceLine& where) {
  if (where.file.empty()) return "hlsgen";
  return where.file + ":" + std::to_string(where.line);
}

}  // namespace

// Headers that came with the compiler are found by absolute paths outside the tree.
bool is_system_header(const SourceLine& where) { return llvm::sys::path::is_absolute(where.file); }

bool is_number_library(const SourceLine& where) {
  return llvm::sys::path::filename(llvm::sys::path::parent_path(where.file)) == "numeric";
}

Refusal::Refusal(const SourceLine& where, const std::string& what, const std::string& mend)
    : std::runtime_error(in_words(where) + ": error: " + what + "; " + mend) {}

SourceLine source_line(const llvm::DIFile* file, unsigned line) {
  if (file == nullptr) return {};
  llvm::SmallString<256> path(file->getFilename());
  if (!llvm::sys::path::is_absolute(path)) {
    path = file->getDirectory();
    llvm::sys::path::append(path, file->getFilename());
  }
  llvm::sys::path::remove_dots(path, /*remove_dot_dot=*/true);
  llvm::SmallString<256> root;
  llvm::sys::fs::current_path(root);
  llvm::StringRef relative(path);
  if (relative.consume_front(root)) relative.consume_front("/");
  return {relative.str(), line};
}

SourceLine source_of(const llvm::Instruction& instruction) {
  SourceLine found;
  for (const llvm::DILocation* at = instruction.getDebugLoc(); at != nullptr;
       at = at->getInlinedAt()) {
    if (at->getLine() == 0) continue;  // made by the compiler; the frame around it says more
    found = source_line(at->getFile(), at->getLine());
    if (!is_system_header(found)) return found;
  }
  return found.file.empty() ? source_of(*instruction.getFunction()) : found;
}

SourceLine source_of_equation(const llvm::DILocation* location) {
  SourceLine found;
  for (; location != nullptr; location = location->getInlinedAt()) {
    if (location->getLine() == 0) continue;
    found = source_line(location->getFile(), location->getLine());
    if (!is_system_header(found) && !is_number_library(found)) break;
  }
  return found;
}

SourceLine source_of(const llvm::Function& function) {
  if (const auto* subprogram = function.getSubprogram()) {
    return source_line(subprogram->getFile(), subprogram->getLine());
  }
  return {};
}

}  // namespace hlsgen
