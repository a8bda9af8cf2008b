#include "generator/front_end.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/Support/thread.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "generator/cpp/blocks.hpp"
#include "generator/cpp/memory_class.hpp"
#include "generator/dataflow/convert.hpp"
#include "generator/ir/callees.hpp"
#include "generator/ir/expand.hpp"
#include "generator/ir/guards.hpp"
#include "generator/ir/inline.hpp"
#include "generator/ir/instances.hpp"
#include "generator/ir/loops.hpp"
#include "generator/ir/marks.hpp"
#include "generator/ir/memory.hpp"
#include "generator/ir/pipeline.hpp"
#include "generator/ir/step.hpp"
#include "generator/refusal.hpp"

namespace hlsgen {
namespace {

// Readable first, small second: nothing here turns a case into arithmetic on its number.
constexpr const char* kPromote = "early-cse,simplifycfg,instcombine,simplifycfg";
constexpr const char* kSimplify =
    "instcombine,simplifycfg,early-cse,gvn,correlated-propagation,instcombine,simplifycfg,bdce,"
    "instcombine,adce";

// Widths a target is fond of would keep LLVM from narrowing to any other.
void drop_native_widths(llvm::Module& module) {
  std::string layout;
  llvm::SmallVector<llvm::StringRef> parts;
  llvm::StringRef(module.getDataLayoutStr()).split(parts, '-');
  for (const auto part : parts) {
    if (part.startswith("n") && part != "ni") continue;
    layout += (layout.empty() ? "" : "-") + part.str();
  }
  module.setDataLayout(layout);
}

class FrontEnd {
 public:
  explicit FrontEnd(const FrontEndOptions& options)
      : program_(compile(options.compile)),
        opaque_(*program_.module),
        any_clocks_(options.any_clocks) {
    drop_native_widths(*program_.module);
    blocks_ = find_blocks(*program_.module, options.compile.source, options.top);
  }

  FrontEndResult run() {
    for (auto& block : blocks_.order) {
      check_callees(*block.tick, blocks_);
      block.tick->addFnAttr(llvm::Attribute::Convergent);  // a call of it is not to be copied
    }
    check_callees(*blocks_.reset, blocks_);
    find_resets();
    FrontEndResult result;
    for (const auto& block : blocks_.order) {
      if (!block.has_module) continue;
      if (contents_of(block.type) != nullptr) {
        result.design.modules.push_back(memory_of(block));
      } else if (block.sample == nullptr) {
        result.design.modules.push_back(module_of(block));
      } else {
        for (auto& module : scheduled(block, result.schedules))
          result.design.modules.push_back(std::move(module));
      }
    }
    result.read = program_.read;
    return result;
  }

 private:
  void flatten(llvm::Function& function, const llvm::Function* own) {
    inline_calls(function, own, blocks_);
    mark_variables(function, opaque_);
    insert_guards(function, opaque_);
    unroll_loops(function);
  }

  void find_resets() {
    const auto all = whole_state(blocks_.order.back(), blocks_);
    auto step = build_reset(*program_.module, blocks_, all, opaque_);
    flatten(*step.function, nullptr);
    expand_accesses(*step.function, opaque_);
    simplify_memory(*step.function);
    run_passes(*step.function, kPromote);
    refuse_unproved(prove(*step.function));
    run_passes(*step.function, kSimplify);
    check_marks(*step.function, opaque_);

    std::map<std::uint64_t, llvm::APInt> by_offset;
    for (std::size_t i = 0; i < all.leaves.size(); ++i) {
      const auto* store = llvm::cast<llvm::StoreInst>(*step.nexts[i]->user_begin());
      const auto* value = llvm::dyn_cast<llvm::ConstantInt>(store->getValueOperand());
      if (value == nullptr) {
        throw Refusal(all.leaves[i].source,
                      "the default value of '" + all.leaves[i].leaf.name + "' is not a constant",
                      "give it a constexpr one");
      }
      by_offset[all.leaves[i].offset] = value->getValue();
    }
    step.function->eraseFromParent();
    give_resets(blocks_.order.size() - 1, 0, by_offset);
  }

  void give_resets(std::size_t number, std::uint64_t offset,
                   const std::map<std::uint64_t, llvm::APInt>& by_offset) {
    auto& block = blocks_.order[number];
    std::vector<llvm::APInt> reset;
    for (const auto& place : block.state.leaves) {
      reset.push_back(by_offset.at(offset + place.offset));
    }
    if (!block.reset.empty() && block.reset != reset) {
      throw Refusal(block.source,
                    "instances of " + block.cpp_class + " have different default values",
                    "make what differs a template parameter");
    }
    block.reset = reset;
    for (const auto& instance : block.state.instances) {
      give_resets(blocks_.index.at(instance.type), offset + instance.offset, by_offset);
    }
  }

  Module module_of(const Block& block) {
    // Registers whose enumeration does not prove to hold are taken for plain numbers; that may
    // weaken the proof of others, hence the loop.
    std::vector<bool> wide(block.state.leaves.size(), false);
    for (;;) {
      auto step = build_step(*program_.module, block, blocks_, wide, opaque_);
      flatten(*step.function, block.tick);
      cut_instances(step, blocks_, opaque_);
      simplify_memory(*step.function);
      expand_accesses(*step.function, opaque_);
      simplify_memory(*step.function);
      run_passes(*step.function, kPromote);
      const auto failed = prove(*step.function);
      if (widen(block, failed, wide)) {
        step.function->eraseFromParent();
        continue;
      }
      refuse_unproved(failed);
      run_passes(*step.function, kSimplify);
      check_instances(step, block);
      auto module = convert(step, block, opaque_);
      step.function->eraseFromParent();
      return module;
    }
  }

  std::vector<Module> scheduled(const Block& block, std::vector<ScheduleReport>& reports) {
    const auto& sample = blocks_.of(block.sample);
    const auto leaf = [](const Layout& ports, const char* name) {
      const auto named = [&](const LeafPlace& place) { return place.leaf.name == name; };
      return std::find_if(ports.leaves.begin(), ports.leaves.end(), named)->leaf;
    };
    Frame frame{leaf(block.in, "start"), leaf(block.out, "done"),
                            leaf(block.out, "busy"), leaf(block.out, "missed"), {}, {}};
    for (const auto& place : sample.out.leaves) {
      const bool is_early = place.leaf.name.rfind("early.", 0) == 0;
      frame.early.push_back(block.budget.early != 0 && is_early);
      for (std::size_t i = 0; i < block.reset.size(); ++i) {
        const bool is_shown = block.state.leaves[i].leaf.name == "shown_." + place.leaf.name;
        if (is_shown) frame.output_resets.push_back(block.reset[i]);
      }
    }
    auto [memories, module, report] = schedule(module_of(sample), block.budget, frame);
    if (report.clocks != block.budget.clocks && !any_clocks_) {
      throw Refusal(sample.source,
                    "a sample of " + sample.cpp_class + " takes " + std::to_string(report.clocks) +
                        " clocks under its budget, not " + std::to_string(block.budget.clocks),
                    "write .clocks = " + std::to_string(report.clocks));
    }
    if (report.early != block.budget.early && !any_clocks_) {
      throw Refusal(sample.source,
                    "the early outputs of " + sample.cpp_class + " take " +
                        std::to_string(report.early) + " clocks, not " +
                        std::to_string(block.budget.early),
                    "write .early = " + std::to_string(report.early));
    }
    reports.push_back(std::move(report));
    memories.push_back(std::move(module));
    return std::move(memories);
  }

  // An index that proves goes bare, and equal ones become one value; that may prove the next.
  static std::vector<unsigned> prove(llvm::Function& function) {
    auto failed = prove_guards(function);
    for (std::size_t before = failed.size() + 1; !failed.empty() && failed.size() < before;) {
      before = failed.size();
      run_passes(function, kSimplify);
      failed = prove_guards(function);
    }
    return failed;
  }

  bool widen(const Block& block, const std::vector<unsigned>& failed, std::vector<bool>& wide) {
    bool changed = false;
    for (const unsigned id : failed) {
      const auto& site = opaque_.site(id);
      for (std::size_t i = 0; i < wide.size(); ++i) {
        const auto& place = block.state.leaves[i];
        if (site.leaf != place.leaf.name || place.enumeration == nullptr || wide[i]) continue;
        wide[i] = true;
        changed = true;
      }
    }
    return changed;
  }

  void refuse_unproved(const std::vector<unsigned>& failed) const {
    if (failed.empty()) return;
    const auto& site = opaque_.site(failed.front());
    throw Refusal(site.where, site.what, site.mend);
  }

  Program program_;
  Opaque opaque_;
  bool any_clocks_;
  Blocks blocks_;
};

}  // namespace

// On a stack of its own: values are followed from outputs backwards, through all of a tick at once.
FrontEndResult build_design(const FrontEndOptions& options) {
  constexpr unsigned kStack = 1U << 30;  // bytes reserved; only what is touched is taken
  FrontEndResult result;
  std::exception_ptr fault;
  llvm::thread worker(std::optional<unsigned>(kStack), [&] {
    try {
      result = FrontEnd(options).run();
    } catch (...) {
      fault = std::current_exception();
    }
  });
  worker.join();
  if (fault) std::rethrow_exception(fault);
  return result;
}

}  // namespace hlsgen
