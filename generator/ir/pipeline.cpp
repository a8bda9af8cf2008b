#include "generator/ir/pipeline.hpp"

#include <llvm/IR/PassManager.h>
#include <llvm/Passes/PassBuilder.h>

namespace hlsgen {

void run_passes(llvm::Function& function, llvm::StringRef pipeline) {
  llvm::LoopAnalysisManager loops;
  llvm::FunctionAnalysisManager functions;
  llvm::CGSCCAnalysisManager graph;
  llvm::ModuleAnalysisManager modules;
  llvm::PassBuilder builder;
  builder.registerModuleAnalyses(modules);
  builder.registerCGSCCAnalyses(graph);
  builder.registerFunctionAnalyses(functions);
  builder.registerLoopAnalyses(loops);
  builder.crossRegisterProxies(loops, functions, graph, modules);
  llvm::FunctionPassManager passes;
  if (auto error = builder.parsePassPipeline(passes, pipeline)) {
    llvm::report_fatal_error(std::move(error));
  }
  passes.run(function, functions);
}

}  // namespace hlsgen
