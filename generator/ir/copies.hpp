// Copies and fills of memory -> one load and store per number.
//
//     memcpy(&b, &a, 8)     ->     b.x = a.x;  b.y = a.y;
//
// LLVM's own scalar replacement would cut at bytes, and a number of 33 bits is no number of bytes.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/design_test.cpp

#pragma once

#include <llvm/IR/Function.h>

namespace hlsgen {

// Those between objects that are not known yet (before loops are unrolled) stay.
void split_copies(llvm::Function& function);

}  // namespace hlsgen
