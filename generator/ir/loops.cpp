#include "generator/ir/loops.hpp"

#include <llvm/Analysis/AssumptionCache.h>
#include <llvm/Analysis/CFG.h>
#include <llvm/Analysis/LoopInfo.h>
#include <llvm/Analysis/OptimizationRemarkEmitter.h>
#include <llvm/Analysis/ScalarEvolution.h>
#include <llvm/Analysis/TargetLibraryInfo.h>
#include <llvm/Analysis/TargetTransformInfo.h>
#include <llvm/IR/Dominators.h>
#include <llvm/Transforms/Utils/BasicBlockUtils.h>
#include <llvm/Transforms/Utils/LoopSimplify.h>
#include <llvm/Transforms/Utils/LoopUtils.h>
#include <llvm/Transforms/Utils/UnrollLoop.h>

#include <set>

#include "generator/ir/memory.hpp"
#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

constexpr unsigned kMaxInstructions = 400'000;
constexpr std::uint64_t kMaxUnrolled = 100'000;  // of one nest of loops

SourceLine source_of_loop(const llvm::Loop& loop) {
  for (const auto* frame = loop.getStartLoc().get(); frame != nullptr;
       frame = frame->getInlinedAt()) {
    if (frame->getLine() != 0) return source_line(frame->getFile(), frame->getLine());
  }
  return source_of(*loop.getHeader()->getTerminator());
}

struct Analyses {
  explicit Analyses(llvm::Function& function)
      : library(library_impl, &function),
        costs(function.getParent()->getDataLayout()),
        assumptions(function),
        dominators(function),
        loops(dominators),
        evolution(function, library, assumptions, dominators, loops),
        remarks(&function) {}

  llvm::TargetLibraryInfoImpl library_impl;
  llvm::TargetLibraryInfo library;
  llvm::TargetTransformInfo costs;
  llvm::AssumptionCache assumptions;
  llvm::DominatorTree dominators;
  llvm::LoopInfo loops;
  llvm::ScalarEvolution evolution;
  llvm::OptimizationRemarkEmitter remarks;
};

// At most so many times; 0 when there is no telling.
unsigned iterations(const llvm::Loop& loop, Analyses& a) {
  const unsigned count = a.evolution.getSmallConstantMaxTripCount(&loop);
  const auto* latch = loop.getLoopLatch();
  const bool tests_first = latch != nullptr && !loop.isLoopExiting(latch);
  return count != 0 && tests_first ? count - 1 : count;  // the last visit only finds the end
}

// `continue` gives a loop several ways back.  LLVM would take some of them for a loop within, whose
// counter starts anywhere, and find no bound for it.
void join_ways_back(llvm::Loop& loop, Analyses& a) {
  llvm::SmallVector<llvm::BasicBlock*> latches;
  loop.getLoopLatches(latches);
  if (latches.size() < 2) return;
  llvm::SplitBlockPredecessors(loop.getHeader(), latches, ".next", &a.dominators, &a.loops);
}

// Loops within it are unrolled already: what nests multiplies.
void refuse_large(const llvm::Loop& loop, unsigned count) {
  std::uint64_t body = 0;
  for (const auto* block : loop.blocks()) {
    for (const auto& instruction : *block) {
      if (!llvm::isa<llvm::DbgInfoIntrinsic>(instruction)) ++body;
    }
  }
  const std::uint64_t all = body * count;
  if (all <= kMaxUnrolled) return;
  throw Refusal(source_of_loop(loop),
                "the loop and those within it unroll to " + std::to_string(all) +
                    " instructions, more than " + std::to_string(kMaxUnrolled),
                "spread the work over clocks");
}

bool unroll(llvm::Loop& loop, Analyses& a) {
  llvm::simplifyLoop(&loop, &a.dominators, &a.loops, &a.evolution, &a.assumptions, nullptr, false);
  llvm::formLCSSARecursively(loop, a.dominators, &a.loops, &a.evolution);
  const unsigned count = a.evolution.getSmallConstantMaxTripCount(&loop);
  if (count == 0 || iterations(loop, a) > kMaxIterations) return false;
  refuse_large(loop, count);
  llvm::UnrollLoopOptions options{};
  options.Count = count;
  options.Force = true;
  options.ForgetAllSCEV = true;
  const auto result =
      llvm::UnrollLoop(&loop, options, &a.loops, &a.evolution, &a.dominators, &a.assumptions,
                       &a.costs, &a.remarks, /*PreserveLCSSA=*/true);
  return result == llvm::LoopUnrollResult::FullyUnrolled;
}

// Unrolls one loop, the innermost that can be.  True if there was one.
bool unroll_one(llvm::Function& function) {
  Analyses analyses(function);
  auto loops = analyses.loops.getLoopsInPreorder();
  for (auto* loop : loops) join_ways_back(*loop, analyses);  // unrolling touches the outer ones
  for (auto loop = loops.rbegin(); loop != loops.rend(); ++loop) {
    if (unroll(**loop, analyses)) return true;
  }
  return false;
}

void refuse_loops(llvm::Function& function) {
  Analyses analyses(function);
  for (auto* loop : analyses.loops.getLoopsInPreorder()) {
    const unsigned count = iterations(*loop, analyses);
    if (count > kMaxIterations) {
      throw Refusal(source_of_loop(*loop),
                    "the loop may run " + std::to_string(count) + " times, more than " +
                        std::to_string(kMaxIterations),
                    "spread the work over clocks");
    }
    throw Refusal(source_of_loop(*loop), "the loop has no bound that is known at compile time",
                  "count to a constant, or spread the work over clocks");
  }
}

// Loops that jump into their own middle (goto) are no loops to LLVM.
void refuse_cycles(llvm::Function& function) {
  llvm::SmallVector<std::pair<const llvm::BasicBlock*, const llvm::BasicBlock*>> edges;
  llvm::FindFunctionBackedges(function, edges);
  if (edges.empty()) return;
  throw Refusal(source_of(*edges.front().first->getTerminator()), "jumps that form a loop",
                "write it as a for loop with a constant bound");
}

}  // namespace

void unroll_loops(llvm::Function& function) {
  do {
    simplify_memory(function);
    if (function.getInstructionCount() > kMaxInstructions) {
      throw Refusal(source_of(function), "the loops unroll to more than a circuit",
                    "spread the work over clocks");
    }
  } while (unroll_one(function));
  refuse_loops(function);
  refuse_cycles(function);
}

}  // namespace hlsgen
