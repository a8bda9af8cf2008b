// The tree of a module as text, item by item.
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/print/syntax.hpp"

#include <string>

namespace hlsgen {

std::string write_module(const syntax::Text& text);

}  // namespace hlsgen
