#include "generator/print/identifiers.hpp"

#include "generator/backend.hpp"
#include "generator/names.hpp"

#include <cctype>

namespace hlsgen {
namespace {

std::string lower(std::string s) {
  for (char& c : s) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return s;
}

std::string legal(const std::string& wanted) {
  std::string out;
  for (const char c : flat_name(wanted)) {
    const bool word = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    out += word ? c : '_';
  }
  if (out.empty() || std::isdigit(static_cast<unsigned char>(out[0])) != 0) out = "v" + out;
  if (is_keyword(out)) out += '_';
  return out;
}

}  // namespace

std::string NamePool::take(std::string wanted) {
  wanted = legal(wanted);
  std::string name = wanted;
  for (int i = 2; !taken_.insert(lower(name)).second; ++i) name = wanted + "_" + std::to_string(i);
  return name;
}

bool NamePool::is_free(const std::string& wanted) const {
  return taken_.count(lower(legal(wanted))) == 0;
}

FixedNames::FixedNames(const Design& design, const Module& module) {
  if (is_clocked(design, module)) {
    pool.take(std::string(kClockPort));
    pool.take(std::string(kResetPort));
  }
  for (const Leaf& leaf : module.inputs)
    inputs.push_back(pool.take(port_name(leaf, Direction::kIn)));
  for (const Output& o : module.outputs)
    outputs.push_back(pool.take(port_name(o.leaf, Direction::kOut)));
  for (const Register& r : module.registers) registers.push_back(pool.take(r.leaf.name));
  for (const Instance& i : module.instances) instances.push_back(pool.take(i.name));
}

const Module& module_of(const Design& design, const Instance& instance) {
  for (const Module& m : design.modules)
    if (m.name == instance.module) return m;
  throw NetlistError("instance " + instance.name + " is of unknown module " + instance.module);
}

}  // namespace hlsgen
