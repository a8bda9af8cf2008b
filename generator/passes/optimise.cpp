// The order of the passes.  Each makes work for the others, so they run until none finds anything;
// every rule makes a module smaller or a form more regular, and the bound is a guard, not a plan.

#include "generator/backend.hpp"
#include "generator/machine/memory.hpp"
#include "generator/passes/constant_registers.hpp"
#include "generator/passes/fold_constants.hpp"
#include "generator/passes/narrow_widths.hpp"
#include "generator/passes/remove_dead.hpp"
#include "generator/passes/share_common.hpp"
#include "generator/passes/simplify_compares.hpp"
#include "generator/passes/simplify_counters.hpp"
#include "generator/passes/simplify_muxes.hpp"
#include "generator/passes/simplify_wiring.hpp"
#include "generator/passes/spell_enumerators.hpp"

namespace hlsgen {
namespace {

constexpr int kMostRounds = 100;

using Pass = bool (*)(Module&);
constexpr Pass kPasses[] = {fold_constants,    simplify_wiring,    share_common,
                            simplify_compares, simplify_counters,  simplify_muxes,
                            narrow_widths,     share_common,       constant_registers,
                            remove_dead,       spell_enumerators};

void optimise(Module& module) {
  remove_dead(module);
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    for (const Pass pass : kPasses) changed |= pass(module);
    if (!changed) return;
  }
}

}  // namespace

void optimise(Design& design) {
  for (Module& m : design.modules)
    if (!is_memory(m)) optimise(m);
}

}  // namespace hlsgen
