#include "generator/machine/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/machine/build.hpp"
#include "generator/machine/fuse.hpp"
#include "generator/machine/lower.hpp"
#include "generator/machine/shifts.hpp"
#include "generator/passes/fold_constants.hpp"
#include "generator/passes/remove_dead.hpp"
#include "generator/passes/share_common.hpp"
#include "generator/passes/simplify_muxes.hpp"
#include "generator/passes/simplify_wiring.hpp"

namespace hlsgen {
namespace {

using namespace machine;

// Those passes that keep numbers in one piece: what is narrower or a slice is no gain here.
void simplify(Module& sample) {
  remove_dead(sample);
  for (bool changed = true; changed;) {
    changed = fold_constants(sample);
    changed |= share_common(sample);
    changed |= remove_dead(sample);
  }
}

// Nodes that compute: no wiring.
unsigned count_operations(const Module& module) {
  return static_cast<unsigned>(std::count_if(module.nodes.begin(), module.nodes.end(), [](const Node& n) {
    return !n.in.empty() && n.op != Op::kSlice && n.op != Op::kConcat && n.op != Op::kZext && n.op != Op::kSext &&
           n.op != Op::kNot;
  }));
}

}  // namespace

std::vector<std::string> ScheduleReport::lines() const {
  const std::string tables = entries == 0 ? "" : fmt::format(", {} entries of tables", entries);
  return {fmt::format("A sample takes {} clocks, and in no order fewer than {}: {} operations, {} products{}", clocks, bound,
                      operations, products, tables),
          fmt::format("as {} instructions on 1 multiplier of {} x {} bits and one adder of {}; {} register bits,", instructions,
                      budget.width, budget.second_width, sum, registers),
          fmt::format("{} words of memory of {} bits.", cells, word) +
              (early == 0 ? "" : fmt::format(" Early outputs are new after {} clocks.", early))};
}

Scheduled schedule(Module sample, const Budget& budget, const Frame& frame) {
  simplify(sample);
  expand_shifts(sample);
  simplify(sample);
  machine::Program program = lower(sample, budget.width, budget.second_width);
  program.early = frame.early;
  program.early.resize(program.outputs.size(), false);
  fuse(program);
  legalise(program);
  const machine::Order placed = machine::order(program);
  program.measure();
  Built built = machine::build(program, placed, frame);

  Scheduled result;
  result.memories = std::move(built.memories);
  result.module = std::move(built.module);
  ScheduleReport& report = result.report;
  report.module = sample.name;
  report.source = sample.source;
  report.budget = budget;
  report.operations = count_operations(sample);
  report.instructions = static_cast<unsigned>(program.instructions.size());
  for (const Instruction& i : program.instructions) {
    report.products += i.has_product() ? 1 : 0;
    report.entries += i.has_entry() ? 1 : 0;
  }
  report.clocks = placed.clocks;
  report.early = placed.early;
  report.bound = std::max(placed.bound, report.instructions + 5);
  report.word = program.word;
  report.sum = program.sum;
  report.cells = placed.cells;
  for (const Register& r : result.module.registers) report.registers += r.leaf.width;
  result.module.remarks = report.lines();
  return result;
}

}  // namespace hlsgen
