// The two entry points for people; the plain printer lives apart.  See backend.hpp.

#include "generator/backend.hpp"
#include "generator/machine/memory.hpp"
#include "generator/print/bit_names.hpp"
#include "generator/print/legalise.hpp"
#include "generator/print/prettify.hpp"
#include "generator/print/write_module.hpp"

namespace hlsgen {

std::string print_module(const Design& design, const Module& module) {
  if (is_memory(module)) return print_memory(module);
  syntax::Text text = legalise(design, module);
  prettify(text);
  name_bits(text);
  text.unused = find_unused(text);
  return write_module(text);
}

std::string print_file_list(const Design& design) {
  std::string out;
  for (const Module& m : design.modules) out += "rtl/" + m.name + ".sv\n";
  return out;
}

}  // namespace hlsgen
