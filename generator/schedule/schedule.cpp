#include "generator/schedule/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/backend.hpp"
#include "generator/machine/machine.hpp"
#include "generator/passes/known_bits.hpp"
#include "generator/schedule/split_products.hpp"

namespace hlsgen {
namespace {

void optimise(Module& module) {
  Design design;
  design.modules.push_back(std::move(module));
  optimise(design);
  module = std::move(design.modules[0]);
}

// Bits that each product's factors take, as signed numbers.
std::vector<std::pair<unsigned, unsigned>> needs_of(const Module& m) {
  const auto known = known_bits(m);
  std::vector<std::pair<unsigned, unsigned>> needs(m.nodes.size());
  for (NodeId id = 0; id < m.nodes.size(); ++id) {
    const Node& n = m.nodes[id];
    if (n.op != Op::kMul) continue;
    needs[id] = {std::min(n.width, known[n.in[0]].signed_width()),
                 std::min(n.width, known[n.in[1]].signed_width())};
  }
  return needs;
}

bool computes(const Node& n) {
  return !n.in.empty() && n.op != Op::kSlice && n.op != Op::kConcat && n.op != Op::kZext &&
         n.op != Op::kSext && n.op != Op::kNot;
}

}  // namespace

unsigned count_operations(const Module& module) {
  return static_cast<unsigned>(
      std::count_if(module.nodes.begin(), module.nodes.end(), [](const Node& n) { return computes(n); }));
}

std::vector<std::string> ScheduleReport::lines() const {
  const std::string tables = entries == 0 ? "" : fmt::format(", {} entries of tables", entries);
  if (instructions != 0) {
    return {fmt::format("A sample takes {} clocks, and in no order fewer than {}: {} operations, {} products{}",
                        clocks, bound, operations, products, tables),
            fmt::format("as {} instructions on 1 multiplier of {} x {} bits and one adder of {}; {} register bits,",
                        instructions, budget.width, budget.second_width, sum, registers),
            fmt::format("{} words of memory of {} bits.", cells, word) +
                (early == 0 ? "" : fmt::format(" Early outputs are new after {} clocks.", early))};
  }
  return {
      fmt::format(
          "A sample takes {} clocks, and in no order fewer than {}: {} operations, {} products{}",
          clocks, bound, operations, products, tables),
      fmt::format("on {} multiplier{} of {} x {} bits; {} register bits, {} of them between steps.",
                  budget.multipliers, budget.multipliers == 1 ? "" : "s", budget.width,
                  budget.second_width, registers, kept)};
}

Scheduled schedule(Module sample, const Budget& budget, const scheduling::Frame& frame) {
  if (budget.program) return machine::schedule(std::move(sample), budget, frame);
  optimise(sample);
  if (split_products(sample, budget.width, budget.second_width)) optimise(sample);

  const scheduling::Operations operations(sample, budget);
  const auto order = scheduling::order(operations);
  const auto keeping = scheduling::keep(operations, order);
  const auto binding = scheduling::bind(operations, order, keeping, needs_of(sample));

  Scheduled result;
  result.module = scheduling::build(operations, order, keeping, binding, frame);
  ScheduleReport& report = result.report;
  report.module = sample.name;
  report.source = sample.source;
  report.budget = budget;
  for (NodeId id = 0; id < sample.nodes.size(); ++id) {
    if (!operations.lives[id]) continue;
    report.operations += computes(sample.nodes[id]) ? 1 : 0;
    report.products += operations.kind[id] == scheduling::Kind::kProduct ? 1 : 0;
    report.entries += operations.kind[id] == scheduling::Kind::kEntry ? 1 : 0;
  }
  report.clocks = order.last + 1;
  report.bound = order.bound + 1;
  report.levels = (keeping.longest + scheduling::kQuarters - 1) / scheduling::kQuarters;
  for (const auto& shared : binding.registers) report.kept += shared.width;
  for (const Register& r : result.module.registers) report.registers += r.leaf.width;
  result.module.remarks = report.lines();
  return result;
}

}  // namespace hlsgen
