// C++ variables' names for values, from the debug information.
//
//     const auto sum = phase + in.step;     ->     the addition is called "sum"
//
// Variables of the block's own header come first; parameters of helpers in other headers say little
// where they were inlined, and are left out.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Function.h>

#include <map>
#include <string>

namespace hlsgen {

std::map<const llvm::Value*, std::string> variable_names(llvm::Function& function,
                                                         const std::string& file);

}  // namespace hlsgen
