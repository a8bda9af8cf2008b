// Functions that the optimiser cannot see through.  They carry what LLVM's own rules would lose:
//
//     hlsgen.undefined.iW(site)         a value nobody has written.  LLVM's `undef` may become
//     anything;
//                                       this stays, and is refused if an output depends on it
//     hlsgen.index.iW(value, count)     the value, which must prove to lie below count
//     hlsgen.table.N.iA.iW(address)     entry of constant table N
//
// Doc: docs/generator.md   Test: tests/generator/frontend/refusal_test.cpp

#pragma once

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>

#include <string>
#include <vector>

#include "generator/netlist.hpp"

namespace hlsgen {

// What to say when an opaque call turns out to be fatal.
struct Site {
  SourceLine where;
  std::string what;
  std::string mend;
  std::string leaf = {};  // the register concerned, if one is
};

class Opaque {
 public:
  explicit Opaque(llvm::Module& module) : module_(module) {}

  llvm::CallInst* undefined(llvm::IRBuilder<>& builder, llvm::Type* type, Site site);
  llvm::CallInst* index(llvm::IRBuilder<>& builder, llvm::Value* value, std::uint64_t count,
                        Site site);
  // Tables of equal name, width and entries are one.
  llvm::CallInst* table(llvm::IRBuilder<>& builder, llvm::Value* address, Table table);

  const Site& site(unsigned id) const { return sites_[id]; }
  const std::vector<Table>& tables() const { return tables_; }

 private:
  llvm::FunctionCallee declare(const std::string& name, llvm::Type* result,
                               llvm::ArrayRef<llvm::Type*> parameters);
  llvm::ConstantInt* add(Site site);

  llvm::Module& module_;
  std::vector<Site> sites_;
  std::vector<Table> tables_;
};

// What a value is a call of, if it is one of ours.
enum class OpaqueKind { kNone, kUndefined, kIndex, kTable };
OpaqueKind opaque_kind(const llvm::Value* value);

// Operands, by name.
unsigned site_of(const llvm::CallInst* call);        // kUndefined, kIndex
std::uint64_t count_of(const llvm::CallInst* call);  // kIndex; 0: must become a constant
unsigned table_of(const llvm::CallInst* call);       // kTable

}  // namespace hlsgen
