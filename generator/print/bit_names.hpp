// The bits of a set of an enumeration's values (hls/numeric/one_hot.hpp) by those values' names.
//
//     at_bits[7]                       ->  at_bits[State_kRun]
//     at_bits[8:7] != 2'd0             ->  at_bits[State_kSlowDown] || at_bits[State_kRun]
//     (at_bits & 11'h401) == 11'd0     ->  !(at_bits[State_kFault] || at_bits[State_kIdle])
//     at_bits <= c ? 10'd512 : 10'd0;  ->  at_bits <= c ? 10'd1 << State_kRest : 10'd0;
//
// Behind everything that looks at selects: none is joined or taken apart after this.
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/print/syntax.hpp"

namespace hlsgen {

void name_bits(syntax::Text& text);

}  // namespace hlsgen
