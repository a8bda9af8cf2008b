// Rewrites a legal tree into one that reads well and means the same.
//
//     x + 8'd255                   ->  x - 8'd1
//     !(a == b), !(a < b)          ->  a != b, a >= b
//     8'd5 < x                     ->  x > 8'd5
//     !c ? a : b                   ->  c ? b : a
//     {4'd0, 2'd1}                 ->  6'd1
//     {x[7:4], x[3:0]}             ->  x
//     if (c) p; if (c) q;          ->  if (c) { p; q; }
//     two cases over one selector  ->  one case with two targets
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/print/syntax.hpp"

namespace hlsgen {

syntax::Expr prettify(syntax::Expr e);
std::vector<syntax::Statement> prettify(std::vector<syntax::Statement> list);
void prettify(syntax::Text& text);

// Two neighbouring `case` over the same selector and labels become one.
void merge_cases(std::vector<syntax::Item>& items);

// Calls visit(expression) for every expression of the text, outermost ones only; works on const
// trees and on others.
template <class Statement, class Visit>
void for_each_in_statement(Statement& s, const Visit& visit) {
  visit(s.value);
  for (auto& t : s.then) for_each_in_statement(t, visit);
  for (auto& t : s.otherwise) for_each_in_statement(t, visit);
}
template <class Item, class Visit>
void for_each_in_item(Item& item, const Visit& visit) {
  if (auto* wire = std::get_if<syntax::Wire>(&item)) visit(wire->value);
  if (auto* cell = std::get_if<syntax::Cell>(&item))
    for (auto& [port, value] : cell->inputs) visit(value);
  if (auto* c = std::get_if<syntax::Case>(&item)) {
    visit(c->selector);
    for (auto& arm : c->arms) {
      for (auto& label : arm.labels) visit(label);
      for (auto& value : arm.values) visit(value);
    }
  }
}
template <class Text, class Visit>
void for_each_expression(Text& text, const Visit& visit) {
  for (auto& item : text.items) for_each_in_item(item, visit);
  for (auto& s : text.updates) for_each_in_statement(s, visit);
  for (auto& [port, value] : text.assigns) visit(value);
}

}  // namespace hlsgen
