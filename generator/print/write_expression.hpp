// Expressions as text: precedence, parentheses, line breaks.  Decides nothing else.
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/print/syntax.hpp"

#include <string>

namespace hlsgen {

inline constexpr unsigned kColumns = 100;

std::string write_flat(const syntax::Expr& e);

// From `column` on; lines after the first begin at `indent`.
std::string write_wrapped(const syntax::Expr& e, unsigned column, unsigned indent);

// "wire x = value;", broken where it gets too long.  `head` ends in its operator.
std::string write_assignment(unsigned indent, const std::string& head, const syntax::Expr& value,
                             const std::string& comment = "");

// "[7:0] ", or nothing for one bit.
std::string write_range(unsigned width);

// Text for a comment: printable, and what a tool might take for a directive disarmed.
std::string disarm(const std::string& text);

// " // text", or nothing.
std::string write_comment(const std::string& text);

}  // namespace hlsgen
