#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "testbench/registers/registers.hpp"

namespace steplock::registers {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

}  // namespace

std::string c_header() {
  std::string text =
      "/* The registers of the six-step drive: offsets in bytes, fields by lowest bit and mask.\n"
      " * Printed by `steplock registers --c-header`; do not edit.  See docs/registers.md. */\n"
      "#ifndef STEPLOCK_REGISTERS_H\n#define STEPLOCK_REGISTERS_H\n\n";
  text += fmt::format("#define STEPLOCK_LOCK_KEY 0x{:x}u\n#define STEPLOCK_MAP_BYTES {}u\n",
                      kLockKey, kMapBytes);
  for (const Register& r : registers()) {
    text += fmt::format("\n#define STEPLOCK_{} 0x{:02x}u /* {} */\n", r.name, r.address,
                        access_name(r.access));
    text += fmt::format("#define STEPLOCK_{}_RESET 0x{:08x}u\n", r.name, r.reset);
    for (const Field& f : r.fields) {
      const std::string name = fmt::format("STEPLOCK_{}_{}", r.name, upper(f.name));
      text += fmt::format("#define {}_LSB {}\n#define {}_MASK 0x{:08x}u\n", name, f.lsb, name,
                          mask_of(f));
    }
  }
  return text + "\n#endif\n";
}

std::string words_c_header(const Words& words, const std::string& name, double clock_hz) {
  std::map<int, std::uint32_t> values;
  const auto place = [&](const auto& row) {
    using Word = typename std::remove_cvref_t<decltype(row)>::Word;
    values[row.address] |= static_cast<std::uint32_t>(bits_of(Word::of(words)).raw()) << row.lsb;
  };
  std::apply([&](const auto&... row) { (place(row), ...); }, kWordRows);

  std::string text = fmt::format(
      "/* The words of the drive {0}, for steplock_init().\n"
      " * Printed by `steplock design {0}.toml --c-header`. */\n"
      "#include \"steplock.h\"\n\n"
      "enum {{ {0}_clock_hz = {1:.0f}, {0}_divide = {2} }};\n\n"
      "static const struct steplock_word {0}_words[] = {{\n",
      name, clock_hz, int(words.loop.divide.raw()));
  for (const Register& r : registers()) {
    if (const auto value = values.find(r.address); value != values.end()) {
      text += fmt::format("    {{STEPLOCK_{}, 0x{:08x}u}},\n", r.name, value->second);
    }
  }
  return text + "};\n";
}

}  // namespace steplock::registers
