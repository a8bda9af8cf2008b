// The registers of an idle drive, made of the table alone; and what tests of every bus need beside it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "hls/bus/six_step_registers.hpp"

namespace steplock {

constexpr int address_of(int index) { return 4 * index; }
inline constexpr int kControl = address_of(index_of("CONTROL"));
inline constexpr int kStatus = address_of(index_of("STATUS"));
inline constexpr int kFault = address_of(index_of("FAULT"));
inline constexpr int kPwm = address_of(index_of("PWM"));
inline constexpr int kLock = address_of(index_of("LOCK"));

// What the table says of an idle drive.
class MapModel {
 public:
  bool write(int address, std::uint32_t data, std::uint32_t mask) {
    bool allowed = false;
    for (const Field& f : kFields) {
      if (f.address != address || !writable(f.access)) continue;
      if (f.access == Access::kKeyed && !unlocked_) continue;
      allowed = true;
      const std::uint32_t bits = mask_of(f) & mask;
      if (f.access != Access::kWriteOnly && f.access != Access::kWriteOneToClear) {
        value(address) = (value(address) & ~bits) | (data & bits);
      }
    }
    if (address == kLock) {
      unlocked_ = (data & mask & 0xffff) == kLockKey;
    }
    constexpr Field kUnlocked = field("STATUS", "unlocked"), kNoPeriod = field("STATUS", "no_period");
    const bool no_period = (value(kPwm) & mask_of(field("PWM", "period"))) == 0;
    value(kStatus) = (reset(kStatus) & ~mask_of(kNoPeriod)) |
                     unsigned(unlocked_) << kUnlocked.lsb | unsigned(no_period) << kNoPeriod.lsb;
    return allowed;
  }
  std::optional<std::uint32_t> read(int address) {  // nothing: an error
    for (const Field& f : kFields) {
      if (f.address == address) return value(address);
    }
    return {};
  }

 private:
  static std::uint32_t reset(int address) {
    std::uint32_t bits = 0;
    for (const Field& f : kFields) {
      if (f.address == address) bits |= f.reset << f.lsb;
    }
    return bits;
  }
  std::uint32_t& value(int address) {
    return values_.try_emplace(address, reset(address)).first->second;
  }
  std::map<int, std::uint32_t> values_;
  bool unlocked_ = false;
};

}  // namespace steplock
