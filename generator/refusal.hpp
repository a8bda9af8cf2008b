// What the generator says when it cannot take a source: one line, and nothing is written.
//
//     hls/x.hpp:31: error: the loop has no constant bound; give it one that the compiler can see
//
// Doc: docs/generator.md   Test: tests/generator/frontend/refusal_test.cpp

#pragma once

#include <llvm/IR/DebugInfoMetadata.h>
#include <llvm/IR/Instruction.h>

#include <stdexcept>
#include <string>

#include "generator/netlist.hpp"

namespace hlsgen {

class Refusal : public std::runtime_error {
 public:
  Refusal(const SourceLine& where, const std::string& what, const std::string& mend);
};

// Paths relative to the current directory, without "./" and "x/..".
SourceLine source_line(const llvm::DIFile* file, unsigned line);

// Where an instruction stands in the user's source: the innermost call frame outside the compiler's
// own headers (an index that leaves a std::array is reported where the brackets are).
SourceLine source_of(const llvm::Instruction& instruction);

// The same for the generated module: the innermost frame outside the number library, so that the
// line of an addition is that of the equation and not that of the number class.
SourceLine source_of_equation(const llvm::DILocation* location);

bool is_system_header(const SourceLine& where);
// hls/numeric, or another folder of that name.
bool is_number_library(const SourceLine& where);

// Any line of the function that a caller would recognise, for instructions without one.
SourceLine source_of(const llvm::Function& function);

}  // namespace hlsgen
