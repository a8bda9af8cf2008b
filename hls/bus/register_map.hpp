// What the register maps of all drives share: one table each, made of the same rows.
//
//     At             the way to a member of a drive's words
//     word           a row: the field of one word, with width and reset value of the word itself
//     system_fields  identification, control, status, faults, interrupts, watchdog: of every drive
//     field, index_of, reset_of   what a map says, by name
//
// A map is a class like SixStep (hls/bus/six_step_registers.hpp):
//
//     Config, Shown, State, Reason    the drive's words, what it shows, and its enumerations
//     kSystemFields, kWordRows, kFields    the table: both parts, and all of it
//     no_period(words)               the bridge could not be run with these
//     kCopies, telemetry(shown)      the registers that a snapshot copies, from TELEMETRY_SPEED on
//
// Doc: docs/six_step_registers.md   Test: tests/hls/register_fields_test.cpp

#pragma once

#include <algorithm>
#include <array>
#include <tuple>
#include <type_traits>

#include "hls/bridge/gate_guard.hpp"
#include "hls/bus/register_fields.hpp"

namespace steplock {

inline constexpr std::uint32_t kMapId = 0x53544c4b;  // "STLK"
inline constexpr std::uint32_t kMapVersion = 0x000600;
inline constexpr std::uint32_t kLockKey = 0xc0de;
using WatchdogTicks = UInt<12>;
using Kilohertz = UInt<20>;

template <int Floor>
consteval int floor_of(const GateGuard<Floor>*) { return Floor; }
inline constexpr std::uint32_t kDeadTimeFloor = floor_of(static_cast<GateGuard<>*>(nullptr));

// A member of a drive's words, by the members on the way to it.
template <auto First, auto... Rest>
struct At {
  template <class Group>
  static constexpr auto& of(Group& group) {
    if constexpr (sizeof...(Rest) == 0) {
      return group.*First;
    } else {
      return At<Rest...>::of(group.*First);
    }
  }
};

// Bits of a word's type, and its number.
template <class T>
inline constexpr int kBitsOf = T::width;
template <>
inline constexpr int kBitsOf<bool> = 1;

template <class T>
constexpr UInt<32> bits_of(const T& word) {
  if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>) {
    return UInt<32>(int(word));
  } else {
    return UInt<32>(wrap<UInt<T::width>>(word));  // a negative one keeps to its own bits
  }
}
template <class T>
constexpr T word_of(UInt<32> bits) {
  if constexpr (std::is_same_v<T, bool>) {
    return bits.bit(0);
  } else if constexpr (std::is_enum_v<T>) {
    return static_cast<T>(wrap<UInt<kBitsOf<T>>>(bits).raw());
  } else {
    return wrap<T>(bits);
  }
}

template <class Place>
struct WordRow : Field {
  using Word = Place;
};

template <class Class, class Member>
Class class_of(Member Class::*);

template <auto First, auto... Rest>
constexpr WordRow<At<First, Rest...>> word(const char* group, const char* name, int address, int lsb,
                                           Access access, const char* unit, const char* prose) {
  using Place = At<First, Rest...>;
  const decltype(class_of(First)) reset;
  const auto& value = Place::of(reset);
  using Type = std::remove_cvref_t<decltype(value)>;
  return {{group, name, address, lsb, kBitsOf<Type>, access,
           static_cast<std::uint32_t>(bits_of(value).raw()), unit, prose}};
}

// What differs between drives in the fields that all of them have.
struct DriveKind {
  std::uint32_t kind = 0;
  const char* kind_prose = "";
  std::uint32_t hall = 0;      // has a Hall decoder
  std::uint32_t counters = 0;  // has telemetry that a synthesis may leave out
  std::uint32_t ramp = 0;      // starts by alignment and ramp
  std::uint32_t follower = 0;  // starts by following the rotor
  const char* states = "";
  const char* reasons = "";
  const char* no_period = "";
};

consteval auto system_fields(const DriveKind& drive) {
  return std::to_array<Field>({
    {"ID", "id", 0x00, 0, 32, Access::kReadOnly, kMapId, "", "The letters STLK."},
    {"VERSION", "patch", 0x04, 0, 8, Access::kReadOnly, kMapVersion & 255, "", "Of this map."},
    {"VERSION", "minor", 0x04, 8, 8, Access::kReadOnly, kMapVersion >> 8 & 255, "",
     "Changes when fields are added."},
    {"VERSION", "major", 0x04, 16, 8, Access::kReadOnly, kMapVersion >> 16, "",
     "Changes when fields move or change their meaning."},
    {"CAPABILITY", "kind", 0x08, 0, 4, Access::kReadOnly, drive.kind, "", drive.kind_prose},
    {"CAPABILITY", "hall", 0x08, 4, 1, Access::kReadOnly, drive.hall, "", "Has a Hall decoder."},
    {"CAPABILITY", "watchdog", 0x08, 5, 1, Access::kReadOnly, 1, "", "Has a heartbeat watchdog."},
    {"CAPABILITY", "counters", 0x08, 6, 1, Access::kReadOnly, drive.counters, "",
     "Counts crossings, misses, limits and attempts; else these read 0."},
    {"CAPABILITY", "follower", 0x08, 7, 1, Access::kReadOnly, drive.follower, "", "Starts by following the rotor."},
    {"CAPABILITY", "dead_time_floor", 0x08, 8, 8, Access::kReadOnly, kDeadTimeFloor, "clocks",
     "The least dead time, whatever PWM_LIMITS says."},
    {"CAPABILITY", "axes", 0x08, 16, 3, Access::kReadOnly, 1, "",
     "Drives on this bus, this one included: the map of each stands 0x100 behind the one before."},
    {"CAPABILITY", "ramp", 0x08, 19, 1, Access::kReadOnly, drive.ramp, "", "Starts by alignment and ramp."},
    {"CONTROL", "configured", 0x0c, 0, 1, Access::kReadWrite, 0, "",
     "The configuration is valid; while 0 all six gates are off."},
    {"CONTROL", "run", 0x0c, 1, 1, Access::kReadWrite, 0, "",
     "Its rise starts a configured drive, which runs until 0 stops it.  The watchdog clears it."},
    {"CONTROL", "reverse", 0x0c, 2, 1, Access::kReadWrite, 0, "", "Direction of rotation."},
    {"CONTROL", "brake_to_stop", 0x0c, 3, 1, Access::kReadWrite, 0, "",
     "Stop by slowing down and braking; else coast."},
    {"STATUS", "state", 0x10, 0, 4, Access::kReadOnly, 0, "", drive.states},
    {"STATUS", "reason", 0x10, 4, 4, Access::kReadOnly, 0, "", drive.reasons},
    {"STATUS", "locked", 0x10, 8, 1, Access::kReadOnly, 0, "", "Running under speed control."},
    {"STATUS", "reverse", 0x10, 9, 1, Access::kReadOnly, 0, "", "Direction of this attempt."},
    {"STATUS", "unlocked", 0x10, 10, 1, Access::kReadOnly, 0, "", "The lock is open."},
    {"STATUS", "stopped", 0x10, 11, 1, Access::kReadOnly, 1, "",
     "Idle or in fault, and run is 0: the configuration may be written."},
    {"STATUS", "no_period", 0x10, 12, 1, Access::kReadOnly, 1, "", drive.no_period},
    {"FAULT", "drive", 0x14, 0, 1, Access::kWriteOneToClear, 0, "",
     "The drive latched a fault.  A one re-arms it, once run is 0 and the cause is gone, which an over-current is "
     "some clocks after its comparator fell; else it stays, and the write is answered all the same."},
    {"FAULT", "watchdog", 0x14, 1, 1, Access::kWriteOneToClear, 0, "",
     "The heartbeat stayed away: gates off until a one is written."},
    {"FAULT", "reason", 0x14, 4, 4, Access::kReadOnly, 0, "",
     "Of the last latched fault, as STATUS.reason; kept when it is cleared."},
    {"INTERRUPT", "fault", 0x18, 0, 1, Access::kWriteOneToClear, 0, "", "FAULT.drive rose."},
    {"INTERRUPT", "watchdog", 0x18, 1, 1, Access::kWriteOneToClear, 0, "", "FAULT.watchdog rose."},
    {"INTERRUPT", "lock", 0x18, 2, 1, Access::kWriteOneToClear, 0, "", "STATUS.locked rose."},
    {"INTERRUPT", "lost", 0x18, 3, 1, Access::kWriteOneToClear, 0, "",
     "The lock was lost: an attempt failed or a fault latched while running."},
    {"INTERRUPT", "started", 0x18, 4, 1, Access::kWriteOneToClear, 0, "",
     "The first lock since run rose."},
    {"INTERRUPT_ENABLE", "enable", 0x1c, 0, 5, Access::kReadWrite, 0, "",
     "The interrupt pin is high while any enabled bit of INTERRUPT is."},
    {"LOCK", "key", 0x20, 0, 16, Access::kWriteOnly, 0, "",
     "0xc0de opens the lock, anything else closes it."},
    {"WATCHDOG", "period", 0x24, 0, 12, Access::kKeyed, 0, "ticks",
     "Longest time between two heartbeats while configured; 0: no watchdog."},
    {"HEARTBEAT", "beat", 0x28, 0, 1, Access::kWriteOnly, 0, "", "Any write is one."},
    {"SNAPSHOT", "take", 0x2c, 0, 1, Access::kWriteOnly, 0, "",
     "Any write copies the drive into the telemetry registers, all at one instant."},
  });
}

// Bits of CONTROL alone: a stop from an interrupt is not undone by a main program that had read CONTROL before it.
consteval auto control_fields() {
  return std::to_array<Field>({
    {"CONTROL_SET", "bits", 0x44, 0, 4, Access::kWriteOnly, 0, "",
     "A one sets this bit of CONTROL, a zero leaves it.  So of two programs none undoes what the other wrote."},
    {"CONTROL_CLEAR", "bits", 0x48, 0, 4, Access::kWriteOnly, 0, "", "A one clears this bit of CONTROL, a zero leaves it."},
    {"CLOCK", "khz", 0x4c, 0, 20, Access::kReadOnly, 0, "kHz",
     "This drive's clock, as its pins `clock_khz` are tied; 0: they tell none.  Words are made for one clock."},
  });
}

// One list of two.
template <std::size_t A, std::size_t B>
consteval std::array<Field, A + B> joined(const std::array<Field, A>& a, const std::array<Field, B>& b) {
  std::array<Field, A + B> all;
  std::copy(b.begin(), b.end(), std::copy(a.begin(), a.end(), all.begin()));
  return all;
}
template <class... Rows>
consteval auto fields_of(const std::tuple<Rows...>& rows) {
  return std::apply([](const auto&... row) { return std::array<Field, sizeof...(Rows)>{row...}; }, rows);
}

struct SixStep;           // the map of the six-step drive, and where no other is named
Field no_such_field();    // not constexpr, and not defined: a wrong name does not compile

// The field of that name.
template <class Map = SixStep>
consteval Field field(const char* group, const char* name) {
  for (const Field& f : Map::kFields) {
    if (same(group, f.group) && same(name, f.name)) return f;
  }
  return no_such_field();
}
// Word address of a register, within the map.
template <class Map = SixStep>
consteval int index_of(const char* group) {
  for (const Field& f : Map::kFields) {
    if (same(group, f.group)) return f.address / 4;
  }
  return no_such_field().address;
}

// All fields of a register at their reset values.
template <class Map = SixStep>
consteval std::uint32_t reset_of(const char* group) {
  std::uint32_t reset = 0;
  for (const Field& f : Map::kFields) {
    if (same(group, f.group)) reset |= f.reset << f.lsb;
  }
  return reset;
}

}  // namespace steplock
