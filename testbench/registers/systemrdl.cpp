#include <fmt/format.h>

#include "testbench/registers/registers.hpp"

namespace steplock::registers {
namespace {

// Software access; the hardware's side follows from it.
const char* properties(Access a) {
  switch (a) {
    case Access::kReadOnly: return "sw = r; hw = w;";
    case Access::kWriteOnly: return "sw = w; hw = r;";
    case Access::kWriteOneToClear: return "sw = rw; onwrite = woclr; hw = w;";
    default: return "sw = rw; hw = r;";
  }
}

std::string described(const Field& f) {
  std::string text = f.prose;
  if (*f.unit != 0) text += fmt::format("  Unit: {}.", f.unit);
  if (f.access == Access::kStopped || f.access == Access::kKeyed ||
      f.access == Access::kShadowed) {
    text += fmt::format("  Access: {}.", access_name(f.access));
  }
  return text;
}

}  // namespace

std::string systemrdl(const Map& map) {
  std::string text = fmt::format(
      "// The registers of the {0} drive in SystemRDL 2.0.\n"
      "// Printed by `steplock registers{1} --systemrdl`; do not edit.\n\n"
      "addrmap {2} {{\n"
      "  name = \"Steplock {0} drive\";\n"
      "  default regwidth = 32;\n"
      "  default accesswidth = 32;\n",
      map.drive, map.option, map.stem);
  for (const Register& r : registers(map)) {
    text += "\n  reg {\n";
    for (const Field& f : r.fields) {
      text += fmt::format(
          "    field {{\n      desc = \"{}\";\n      {}\n    }} {}_f[{}:{}] = {:#x};\n",
          described(f), properties(f.access), f.name, f.lsb + f.width - 1, f.lsb, f.reset);
    }
    text += fmt::format("  }} {} @ 0x{:02x};\n", r.name, r.address);
  }
  return text + "};\n";
}

}  // namespace steplock::registers
