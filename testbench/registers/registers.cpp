#include "testbench/registers/registers.hpp"

#include <algorithm>
#include <cctype>

namespace steplock::registers {

const Map& six_step() {
  static constexpr Map map{.fields = kFields,
                           .drive = "six-step",
                           .top = "six_step_axi",
                           .option = "",
                           .stem = "steplock",
                           .prefix = "STEPLOCK_"};
  return map;
}
const Map& sinusoidal() {
  static constexpr Map map{
      .fields = kSinusoidalFields,
      .drive = "sinusoidal",
      .top = "sinusoidal_axi",
      .option = " --sinusoidal",
      .stem = "steplock_sinusoidal",
      .prefix = "STEPLOCK_SINUSOIDAL_"};
  return map;
}

std::vector<Register> registers(const Map& map) {
  std::vector<Register> all;
  for (const Field& f : map.fields) {
    auto r = std::find_if(all.begin(), all.end(), [&](auto& r) { return r.address == f.address; });
    if (r == all.end()) {
      r = all.insert(r, Register{});
      r->name = f.group;
      r->address = f.address;
    }
    if (writable(f.access)) r->access = f.access;
    r->reset |= f.reset << f.lsb;
    r->mask |= mask_of(f);
    r->fields.push_back(f);
  }
  std::sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.address < b.address; });
  for (Register& r : all) {
    std::sort(r.fields.begin(), r.fields.end(), [](auto& a, auto& b) { return a.lsb < b.lsb; });
  }
  return all;
}

std::string page_of(const Map& map) {
  return map.fields.data() == kFields.data() ? "docs/six_step_registers.md" : "docs/sinusoidal_registers.md";
}

const char* access_name(Access a) {
  switch (a) {
    case Access::kReadOnly: return "ro";
    case Access::kReadWrite: return "rw";
    case Access::kShadowed: return "rw, shadowed";
    case Access::kStopped: return "rw, stopped";
    case Access::kKeyed: return "rw, keyed";
    case Access::kWriteOnly: return "wo";
    case Access::kWriteOneToClear: return "w1c";
  }
  return "";
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace steplock::registers
