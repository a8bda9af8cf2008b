// The registers of an idle drive, made of its table alone; and what tests of every bus need beside it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "hls/bus/sinusoidal_registers.hpp"
#include "hls/bus/six_step_registers.hpp"

namespace steplock {

constexpr int address_of(int index) { return 4 * index; }
inline constexpr int kControl = address_of(index_of("CONTROL"));
inline constexpr int kControlSet = address_of(index_of("CONTROL_SET"));
inline constexpr int kControlClear = address_of(index_of("CONTROL_CLEAR"));
inline constexpr int kStatus = address_of(index_of("STATUS"));
inline constexpr int kFault = address_of(index_of("FAULT"));
inline constexpr int kPwm = address_of(index_of("PWM"));
inline constexpr int kLock = address_of(index_of("LOCK"));
inline constexpr int kClock = address_of(index_of("CLOCK"));
inline constexpr int kClockKhz = 0xa'53c9;  // to which random traffic ties a drive's clock_khz
// Where bit 1 makes the drive run.
constexpr bool runs(int address) { return address == kControl || address == kControlSet; }
// Both maps have these where the first one has them.
template <class Map>
constexpr bool kSamePlaces =
    kControl == address_of(index_of<Map>("CONTROL")) && kStatus == address_of(index_of<Map>("STATUS")) &&
    kControlSet == address_of(index_of<Map>("CONTROL_SET")) && kControlClear == address_of(index_of<Map>("CONTROL_CLEAR")) &&
    kFault == address_of(index_of<Map>("FAULT")) && kPwm == address_of(index_of<Map>("PWM")) &&
    kLock == address_of(index_of<Map>("LOCK")) && kClock == address_of(index_of<Map>("CLOCK")) &&
    address_of(index_of("SPEED_TARGET")) == address_of(index_of<Map>("SPEED_TARGET"));
static_assert(kSamePlaces<Sinusoidal>);

// What a test of a bus has to know of the drive behind it: words that move its gates, `kMoves` clocks
// after `run` at the latest; a tick of its watchdog; and its pins, of which an ADC gives no current.
template <class Map>
struct Behind;
template <>
struct Behind<SixStep> {
  static constexpr int kPeriod = 200, kTick = 200, kMoves = 2000;  // clocks
  // A reset pattern that lasts, half of the time on.
  static std::vector<std::pair<int, std::uint32_t>> config() {
    return {{kPwm, 1u << 24 | kPeriod},
            {address_of(index_of("START_ALIGN")), 4095u << 16},
            {address_of(index_of("START_DUTY")), 0x4000},
            {address_of(index_of("SPEED_TARGET")), 0x1000},
            {address_of(index_of("SPEED_DUTY")), 0x8000u << 16},
            {address_of(index_of("SPEED_DUTY_SLEW")), 0xfff}};
  }
  // Registers whose random contents would end the idleness of a drive: its watchdog's period.
  static bool expires(int address) { return address == address_of(index_of("WATCHDOG")); }
  template <class In, class Out>
  static void pins(In& in, const Out&, bool fault) { in.pins.fault = fault; }
};
template <>
struct Behind<Sinusoidal> {
  static constexpr int kPeriod = 700, kTick = 16 * kPeriod, kMoves = 24 * kPeriod;  // clocks
  // A pattern that lasts, a quarter of the voltage; 16 samples are calibrated before.
  static std::vector<std::pair<int, std::uint32_t>> config() {
    return {{kPwm, kPeriod},
            {address_of(index_of<Sinusoidal>("PWM_RECIPROCAL")), (1u << 25) / (3 * kPeriod)},
            {address_of(index_of<Sinusoidal>("START")), 0x1000u << 16},
            {address_of(index_of<Sinusoidal>("SPEED_TARGET")), 1u << 20},
            {address_of(index_of<Sinusoidal>("START_PATTERN")), 0xfffff}};
  }
  // And how many samples may be lost, of which none comes in a test of the bus alone.
  static bool expires(int address) {
    return Behind<SixStep>::expires(address) || address == address_of(index_of<Sinusoidal>("PROTECTION"));
  }
  // Codes come in the clock after the strobe.
  template <class In, class Out>
  static void pins(In& in, const Out& out, bool fault) {
    in.fault = fault;
    in.codes = {.valid = out.sample, .u = 0, .v = 0, .dc = 2700};
  }
};

// What the table says of an idle drive, and its clock.
template <class Map = SixStep>
class MapModel {
 public:
  bool write(int address, std::uint32_t data, std::uint32_t mask) {
    bool allowed = false;
    for (const Field& f : Map::kFields) {
      if (f.address != address || !writable(f.access)) continue;
      if (f.access == Access::kKeyed && !unlocked_) continue;
      allowed = true;
      const std::uint32_t bits = mask_of(f) & mask;
      if (f.access != Access::kWriteOnly && f.access != Access::kWriteOneToClear) {
        value(address) = (value(address) & ~bits) | (data & bits);
      }
    }
    if (address == kControlSet) value(kControl) |= data & mask & 15;
    if (address == kControlClear) value(kControl) &= ~(data & mask & 15);
    if (address == kLock) {
      unlocked_ = (data & mask & 0xffff) == kLockKey;
    }
    constexpr Field kUnlocked = field<Map>("STATUS", "unlocked"), kNoPeriod = field<Map>("STATUS", "no_period");
    const bool no_period = (value(kPwm) & mask_of(field<Map>("PWM", "period"))) < kLeast;
    value(kStatus) = (reset(kStatus) & ~mask_of(kNoPeriod)) |
                     unsigned(unlocked_) << kUnlocked.lsb | unsigned(no_period) << kNoPeriod.lsb;
    return allowed;
  }
  std::optional<std::uint32_t> read(int address) {  // nothing: an error
    for (const Field& f : Map::kFields) {
      if (f.address == address) return address == kClock ? kClockKhz : value(address);
    }
    return {};
  }

 private:
  static constexpr std::uint32_t kLeast = std::is_same_v<Map, Sinusoidal> ? 477 : 1;  // clocks, of a PWM period

  static std::uint32_t reset(int address) {
    std::uint32_t bits = 0;
    for (const Field& f : Map::kFields) {
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
