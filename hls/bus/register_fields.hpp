// What a register map is made of, and the rules that every map keeps.
//
//     Field    some bits of one 32-bit register: where, how wide, who may write it, what it is
//     problem  the first rule that a list of fields breaks, or nullptr; for static_assert
//
// A register is the fields of one address.  Its writable fields share one kind of access, because a
// write is obeyed or refused as a whole.
//
// Doc: docs/six_step_registers.md   Test: tests/hls/register_fields_test.cpp

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace steplock {

enum class Access : std::uint8_t {
  kReadOnly,
  kReadWrite,
  kShadowed,         // read and write; acts from the next PWM period on
  kStopped,          // read and write; a write is refused unless the drive is stopped
  kKeyed,            // as kStopped, and refused unless the lock is open
  kWriteOnly,        // reads as 0
  kWriteOneToClear,  // a one clears, a zero leaves
};

constexpr bool writable(Access a) { return a != Access::kReadOnly; }

struct Field {
  const char* group = "";     // the register
  const char* name = "";      // unique within it
  int address = 0;            // bytes from the drive's base
  int lsb = 0;
  int width = 1;
  Access access = Access::kReadWrite;
  std::uint32_t reset = 0;
  const char* unit = "";
  const char* prose = "";
};

inline constexpr int kMapBytes = 256;  // a drive's addresses; what lies above is a hole

constexpr std::uint32_t mask_of(const Field& f) {
  return f.width >= 32 ? 0xffffffffU : ((1U << f.width) - 1) << f.lsb;
}

constexpr bool same(const char* a, const char* b) {
  while (*a != 0 && *a == *b) ++a, ++b;
  return *a == *b;
}

// Fields are looked at in their order; the first that breaks a rule tells which.
constexpr const char* problem(std::span<const Field> fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const Field& f = fields[i];
    if (f.address < 0 || f.address % 4 != 0) return "an address is not a multiple of 4";
    if (f.address >= kMapBytes) return "an address lies beyond the map";
    if (f.width < 1 || f.lsb < 0 || f.lsb + f.width > 32) {
      return "a field does not fit its register";
    }
    if (f.width < 32 && (f.reset >> f.width) != 0) return "a reset does not fit its field";
    if (*f.group == 0 || *f.name == 0) {
      return "a field without a name";
    }
    if (*f.prose == 0) return "a field without prose";
    for (std::size_t j = 0; j < i; ++j) {
      const Field& g = fields[j];
      const bool same_group = same(f.group, g.group);
      if (same_group != (f.address == g.address)) {
        return "a register has two addresses, or an address two registers";
      }
      if (!same_group) continue;
      if (same(f.name, g.name)) return "two fields of a register share a name";
      if ((mask_of(f) & mask_of(g)) != 0) return "two fields overlap";
      if (writable(f.access) && writable(g.access) && f.access != g.access) {
        return "a register mixes two kinds of write access";
      }
    }
  }
  return nullptr;
}

}  // namespace steplock
