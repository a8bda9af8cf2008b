// Whether a class is a block under a schedule: steplock::Scheduled<Block, Budget{...}>, known by
// its name and its two template arguments (hls/numeric/scheduled.hpp).
//
// Doc: docs/generator.md   Test: tests/generator/machine_test.cpp

#pragma once

#include <llvm/IR/DebugInfoMetadata.h>

#include <optional>

#include "generator/cpp/layout.hpp"
#include "generator/machine/budget.hpp"

namespace hlsgen {

struct ScheduledClass {
  const llvm::DICompositeType* sample = nullptr;  // the block
  Budget budget;
};

std::optional<ScheduledClass> scheduled_class(const llvm::DICompositeType* type);

// The layout of a block with the registers of blocks within it as its own.
Layout flat_layout(const llvm::DICompositeType* type);

}  // namespace hlsgen
