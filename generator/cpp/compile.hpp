// C++ source -> LLVM IR, by clang 16, as a subprocess.
//
// The target is spir64: 64-bit like the native build, and classes travel by address instead of
// being packed into integers as the x86 calling convention would.  No clang optimisation runs; what
// the blocks need is done in generator/ir.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/refusal_test.cpp

#pragma once

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include <memory>
#include <string>
#include <vector>

namespace hlsgen {

struct CompileOptions {
  std::string source;
  std::vector<std::string> include_directories;
};

struct Program {
  std::unique_ptr<llvm::LLVMContext> context;  // outlives the module
  std::unique_ptr<llvm::Module> module;
  std::vector<std::string> read;  // the source and the headers of the project
};

// Throws Refusal with the compiler's first error.
Program compile(const CompileOptions& options);

}  // namespace hlsgen
