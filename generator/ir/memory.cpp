#include "generator/ir/memory.hpp"

#include "generator/ir/choices.hpp"
#include "generator/ir/copies.hpp"
#include "generator/ir/guards.hpp"
#include "generator/ir/pipeline.hpp"
#include "generator/ir/split.hpp"

namespace hlsgen {

void simplify_memory(llvm::Function& function) {
  bool changed = true;
  while (changed) {
    run_passes(function, "early-cse,simplifycfg,dce");
    split_copies(function);
    changed = choose_values(function);
    changed |= fold_guards(function);
    changed |= split_variables(function);
  }
}

}  // namespace hlsgen
