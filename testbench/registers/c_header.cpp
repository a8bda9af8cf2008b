#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>

#include "testbench/registers/registers.hpp"

namespace steplock::registers {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

// A field whose prose counts its values, "0 idle, 1 detect spin": an enum of them, and their names in order.
std::string values_of(const Map& map, const Field& field) {
  const std::string name = map.prefix + upper(field.name), prose = field.prose;
  std::string values, names;
  const std::regex value("([0-9]+) ([A-Za-z][A-Za-z -]*)");
  for (std::sregex_iterator at(prose.begin(), prose.end(), value), end; at != end; ++at) {
    const std::string word = (*at)[2];
    const std::string constant = std::regex_replace(upper(word), std::regex("[ -]"), "_");
    values += fmt::format("{}\n  {}_{} = {}", values.empty() ? "" : ",", name, constant, (*at)[1].str());
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", word);
  }
  return fmt::format("\nenum {} {{{}\n}};\n#define {}_NAMES {}\n", lower(name), values, name, names);
}

}  // namespace

std::string c_header(const Map& map) {
  const std::string guard = upper(map.stem) + "_REGISTERS_H";
  std::string text = fmt::format(
      "/* The registers of the {0} drive: offsets in bytes, fields by lowest bit and mask.\n"
      " * Printed by `steplock registers{1} --c-header`; do not edit.  See {2}. */\n"
      "#ifndef {3}\n#define {3}\n\n",
      map.drive, map.option, page_of(map), guard);
  text += fmt::format("#define {0}LOCK_KEY 0x{1:x}u\n#define {0}MAP_BYTES {2}u\n", map.prefix,
                      kLockKey, kMapBytes);
  for (const Register& r : registers(map)) {
    text += fmt::format("\n#define {}{} 0x{:02x}u /* {} */\n", map.prefix, r.name, r.address,
                        access_name(r.access));
    text += fmt::format("#define {}{}_RESET 0x{:08x}u\n", map.prefix, r.name, r.reset);
    for (const Field& f : r.fields) {
      const std::string name = fmt::format("{}{}_{}", map.prefix, r.name, upper(f.name));
      text += fmt::format("#define {}_LSB {}\n#define {}_MASK 0x{:08x}u\n", name, f.lsb, name,
                          mask_of(f));
    }
  }
  for (const Field& f : map.fields) {
    if (std::string(f.group) == "STATUS" && (std::string(f.name) == "state" || std::string(f.name) == "reason")) {
      text += values_of(map, f);
    }
  }
  return text + "\n#endif\n";
}

namespace {

// `constants`: what else the program wants to know of the drive, each with its value.  The first word is the clock.
std::string config_text(const Map& map, const std::map<int, std::uint32_t>& values, const std::string& name,
                       const std::string& constants, double clock_hz) {
  std::string text = fmt::format(
      "/* The configuration of the drive {0}, for steplock_init().\n"
      " * Printed by `steplock design {0}.toml --c-header`. */\n"
      "#include \"{1}.h\"\n\n"
      "enum {{ {2} }};\n\n"
      "static const struct steplock_word {0}_config[] = {{\n",
      name, map.stem, constants);
  text += fmt::format("    {{{}CLOCK, {}u}},\n", map.prefix, std::llround(clock_hz / 1e3));
  for (const Register& r : registers(map)) {
    if (const auto value = values.find(r.address); value != values.end()) {
      text += fmt::format("    {{{}{}, 0x{:08x}u}},\n", map.prefix, r.name, value->second);
    }
  }
  return text + "};\n";
}

std::string list_text(const Map& map, const std::map<int, std::uint32_t>& values, const std::string& name,
                      const std::string& constants) {
  std::string text = fmt::format(
      "// The words of the drive {0}, for $readmemh: offset and value of a register, to be written behind the lock.\n"
      "// Printed by `steplock design {0}.toml --mem`.  {1}\n",
      name, constants);
  for (const Register& r : registers(map)) {
    if (const auto value = values.find(r.address); value != values.end()) {
      text += fmt::format("{:08x}_{:08x}  // {}\n", r.address, value->second, r.name);
    }
  }
  return text;
}

}  // namespace

std::string config_c_header(const SixStepConfig& config, const std::string& name, double clock_hz) {
  return config_text(six_step(), values_of<SixStep>(config), name,
                    fmt::format("{0}_clock_hz = {1:.0f}, {0}_divide = {2}", name, clock_hz,
                                int(config.loop.divide.raw())), clock_hz);
}
std::string config_c_header(const SinusoidalConfig& config, const std::string& name, double clock_hz) {
  return config_text(sinusoidal(), values_of<Sinusoidal>(config), name,
                    fmt::format("{0}_clock_hz = {1:.0f}, {0}_period = {2}", name, clock_hz,
                                int(config.bridge.period.raw())), clock_hz);
}

std::string config_mem(const SixStepConfig& config, const std::string& name, double clock_hz) {
  return list_text(six_step(), values_of<SixStep>(config), name,
                   fmt::format("Clock: {:.0f} Hz; LOOP.divide: {}.", clock_hz, int(config.loop.divide.raw())));
}
std::string config_mem(const SinusoidalConfig& config, const std::string& name, double clock_hz) {
  return list_text(sinusoidal(), values_of<Sinusoidal>(config), name,
                   fmt::format("Clock: {:.0f} Hz; PWM.period: {} clocks.", clock_hz, int(config.bridge.period.raw())));
}

}  // namespace steplock::registers
