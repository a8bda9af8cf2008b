// C++ names for values, from the debug information.
//
//     const auto sum = phase + in.step;        ->  the addition is called "sum"
//     Frequency limit() const { return ... }   ->  what it returns is of "limit"
//
// A variable's name comes first, a parameter's last.  The number library and lambdas give none:
// their parameters say nothing where they were inlined.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Function.h>

#include <map>
#include <string>

namespace hlsgen {

using ValueNames = std::map<const llvm::Value*, std::string>;

ValueNames variable_names(llvm::Function& function);
ValueNames parameter_names(llvm::Function& function);
ValueNames inverse_names(llvm::Function& function);  // variables that hold a bit's inverse

// The function that an instruction was inlined from; empty for tick itself.
std::string function_of(const llvm::Instruction& instruction);

// Whether the value is read outside of that function.
bool is_returned(const llvm::Instruction& instruction);

}  // namespace hlsgen
