#include "testbench/registers/registers.hpp"

#include <algorithm>
#include <cctype>

namespace steplock::registers {

std::vector<Register> registers() {
  std::vector<Register> all;
  for (const Field& f : kFields) {
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
