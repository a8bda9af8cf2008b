// Rewrites a legal tree into one that reads well and means the same.
//
//     x + 8'd255                   ->  x - 8'd1
//     !(a == b), !(a < b)          ->  a != b, a >= b
//     8'd5 < x                     ->  x > 8'd5
//     !c ? a : b                   ->  c ? b : a
//     {4'd0, 2'd1}                 ->  6'd1
//     {x[7:4], x[3:0]}             ->  x
//     if (!c) p; else q;           ->  if (c) q; else p;
//     two cases over one selector  ->  one case with two targets
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/print/syntax.hpp"

namespace hlsgen {

syntax::Expr prettify(syntax::Expr e);
syntax::Block prettify(syntax::Block block);
void prettify(syntax::Text& text);

// Two neighbouring `case` over the same selector and labels become one.
void merge_cases(std::vector<syntax::Item>& items);

// Calls visit(expression) for every expression of the text, outermost ones only; works on const
// trees and on others.
template <class Item, class Visit>
void for_each_in_item(Item& item, const Visit& visit) {
  if (auto* wire = std::get_if<syntax::Wire>(&item)) visit(wire->value);
  if (auto* cell = std::get_if<syntax::Cell>(&item)) {
    for (auto& [parameter, value] : cell->parameters) visit(value);
    for (auto& [port, value] : cell->inputs) visit(value);
  }
  if (auto* c = std::get_if<syntax::Case>(&item)) {
    visit(c->selector);
    for (auto& arm : c->arms) {
      for (auto& label : arm.labels) visit(label);
      for (auto& value : arm.values) visit(value);
    }
  }
}
template <class Block, class Visit>
void for_each_in_block(Block& block, const Visit& visit) {
  for (auto& item : block.locals) for_each_in_item(item, visit);
  for (auto& s : block.statements) {
    visit(s.value);
    for_each_in_block(s.then, visit);
    for_each_in_block(s.otherwise, visit);
    for (auto& arm : s.arms) {
      for (auto& label : arm.labels) visit(label);
      for_each_in_block(arm.block, visit);
    }
  }
}
template <class Text, class Visit>
void for_each_expression(Text& text, const Visit& visit) {
  for (auto& item : text.items) for_each_in_item(item, visit);
  for_each_in_block(text.updates, visit);
  for (auto& [port, value] : text.assigns) visit(value);
}

}  // namespace hlsgen
