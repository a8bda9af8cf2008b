// Names inside one module: legal, unique without regard to case, and a function of the source alone.
//
//     NamePool pool;
//     pool.take("phase")  ->  phase         pool.take("Phase")  ->  Phase_2
//     pool.take("reg")    ->  reg_          (a keyword of Verilog)
//
// Both printers take the names of ports, registers and instances from FixedNames, and agree on
// nothing else.
//
// Test: tests/generator/backend_print_test.cpp

#pragma once

#include "generator/netlist.hpp"

#include <set>
#include <string>
#include <vector>

namespace hlsgen {

class NamePool {
 public:
  // The wanted name if it is free and legal, else the next one that is.
  std::string take(std::string wanted);
  bool is_free(const std::string& wanted) const;

 private:
  std::set<std::string> taken_;  // in lower case
};

struct FixedNames {
  explicit FixedNames(const Design& design, const Module& module);

  NamePool pool;  // holds all of the names below
  std::vector<std::string> inputs, outputs, registers, instances;
};

const Module& module_of(const Design& design, const Instance& instance);

}  // namespace hlsgen
