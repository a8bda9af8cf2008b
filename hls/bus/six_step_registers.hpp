// The register map of the six-step drive.  Everything else that knows an address is made of this
// table: the decoder, the C header, the pages, SystemRDL and IP-XACT (steplock registers).
//
//     kSystemFields   identification, control, status, faults, interrupts, telemetry
//     kWordRows       every word of the drive: hls/bus/word_rows.hpp
//     kFields         both, which is the map
//
// Doc: docs/registers.md   Test: tests/hls/register_fields_test.cpp

#pragma once

#include <array>
#include <tuple>

#include "hls/bridge/gate_guard.hpp"
#include "hls/bus/register_fields.hpp"
#include "hls/bus/word_rows.hpp"

namespace steplock {

inline constexpr std::uint32_t kMapId = 0x53544c4b;  // "STLK"
inline constexpr std::uint32_t kMapVersion = 0x000200;
inline constexpr std::uint32_t kLockKey = 0xc0de;
using WatchdogTicks = UInt<12>;

template <int Floor>
consteval int floor_of(const GateGuard<Floor>*) { return Floor; }
inline constexpr std::uint32_t kDeadTimeFloor = floor_of(static_cast<GateGuard<>*>(nullptr));

inline constexpr auto kSystemFields = std::to_array<Field>({
    {"ID", "id", 0x00, 0, 32, Access::kReadOnly, kMapId, "", "The letters STLK."},
    {"VERSION", "patch", 0x04, 0, 8, Access::kReadOnly, kMapVersion & 255, "", "Of this map."},
    {"VERSION", "minor", 0x04, 8, 8, Access::kReadOnly, kMapVersion >> 8 & 255, "",
     "Changes when fields are added."},
    {"VERSION", "major", 0x04, 16, 8, Access::kReadOnly, kMapVersion >> 16, "",
     "Changes when fields move or change their meaning."},
    {"CAPABILITY", "kind", 0x08, 0, 4, Access::kReadOnly, 1, "", "1: six-step drive."},
    {"CAPABILITY", "hall", 0x08, 4, 1, Access::kReadOnly, 1, "", "Has a Hall decoder."},
    {"CAPABILITY", "watchdog", 0x08, 5, 1, Access::kReadOnly, 1, "", "Has a heartbeat watchdog."},
    {"CAPABILITY", "dead_time_floor", 0x08, 8, 8, Access::kReadOnly, kDeadTimeFloor, "clocks",
     "The least dead time, whatever PWM_LIMITS says."},
    {"CAPABILITY", "axes", 0x08, 16, 3, Access::kReadOnly, 1, "",
     "Drives on this bus, this one included: the map of each stands 0x100 behind the one before."},
    {"CONTROL", "configured", 0x0c, 0, 1, Access::kReadWrite, 0, "",
     "The words are valid; while 0 all six gates are off."},
    {"CONTROL", "run", 0x0c, 1, 1, Access::kReadWrite, 0, "",
     "Start, and keep running; 0 stops.  The watchdog clears it."},
    {"CONTROL", "reverse", 0x0c, 2, 1, Access::kReadWrite, 0, "", "Direction of rotation."},
    {"CONTROL", "brake_to_stop", 0x0c, 3, 1, Access::kReadWrite, 0, "",
     "Stop by slowing down and braking; else coast."},
    {"STATUS", "state", 0x10, 0, 4, Access::kReadOnly, 0, "",
     "0 idle, 1 observe, 2 brake, 3 settle, 4 reset, 5 accelerate, 6 pull in, 7 run, 8 slow down, "
     "9 rest, 10 fault."},
    {"STATUS", "reason", 0x10, 4, 4, Access::kReadOnly, 0, "",
     "Of the last failed try: 0 none, 1 fault pin, 2 over-current, 3 step-out, 4 stall, 5 wrong "
     "lock, 6 no lock, 7 cannot stop, 8 Hall code."},
    {"STATUS", "locked", 0x10, 8, 1, Access::kReadOnly, 0, "", "Running under speed control."},
    {"STATUS", "reverse", 0x10, 9, 1, Access::kReadOnly, 0, "", "Direction of this try."},
    {"STATUS", "unlocked", 0x10, 10, 1, Access::kReadOnly, 0, "", "The lock is open."},
    {"STATUS", "stopped", 0x10, 11, 1, Access::kReadOnly, 1, "",
     "Idle or in fault, and run is 0: words may be written."},
    {"STATUS", "no_period", 0x10, 12, 1, Access::kReadOnly, 1, "",
     "PWM.period is 0: all six gates are off, and the drive does not start, whatever CONTROL says."},
    {"FAULT", "drive", 0x14, 0, 1, Access::kWriteOneToClear, 0, "",
     "The drive latched a fault.  A one re-arms it, once run is 0 and the cause is gone."},
    {"FAULT", "watchdog", 0x14, 1, 1, Access::kWriteOneToClear, 0, "",
     "The heartbeat stayed away: gates off until a one is written."},
    {"FAULT", "reason", 0x14, 4, 4, Access::kReadOnly, 0, "",
     "Of the last latched fault, as STATUS.reason; kept when it is cleared."},
    {"INTERRUPT", "fault", 0x18, 0, 1, Access::kWriteOneToClear, 0, "", "FAULT.drive rose."},
    {"INTERRUPT", "watchdog", 0x18, 1, 1, Access::kWriteOneToClear, 0, "", "FAULT.watchdog rose."},
    {"INTERRUPT", "lock", 0x18, 2, 1, Access::kWriteOneToClear, 0, "", "STATUS.locked rose."},
    {"INTERRUPT", "lost", 0x18, 3, 1, Access::kWriteOneToClear, 0, "",
     "The lock was lost: a try failed or a fault latched while running."},
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
    {"TELEMETRY_SPEED", "frequency", 0x30, 0, 26, Access::kReadOnly, 0, "u0.32 turns/clock",
     "VCO frequency."},
    {"TELEMETRY_LOOP", "duty", 0x34, 0, 16, Access::kReadOnly, 0, "u1.15", "Duty."},
    {"TELEMETRY_LOOP", "phase_error", 0x34, 16, 16, Access::kReadOnly, 0, "s0.16 step",
     "Phase error of the last crossing."},
    {"TELEMETRY_CROSSINGS", "crossings", 0x38, 0, 16, Access::kReadOnly, 0, "",
     "Zero crossings since run was obeyed; all counts stop at 65535."},
    {"TELEMETRY_CROSSINGS", "missed", 0x38, 16, 16, Access::kReadOnly, 0, "", "Steps without one."},
    {"TELEMETRY_LIMITS", "freewheel_long", 0x3c, 0, 16, Access::kReadOnly, 0, "",
     "Steps that freewheeled for too long."},
    {"TELEMETRY_LIMITS", "limit_hits", 0x3c, 16, 16, Access::kReadOnly, 0, "",
     "Pulses cut by the current limit."},
    {"TELEMETRY_RETRIES", "retries", 0x40, 0, 16, Access::kReadOnly, 0, "", "Failed tries."},
});

inline constexpr auto kFields = std::apply(
    [](const auto&... rows) {
      std::array<Field, kSystemFields.size() + sizeof...(rows)> all;
      std::size_t i = 0;
      for (const Field& f : kSystemFields) all[i++] = f;
      ((all[i++] = rows), ...);
      return all;
    },
    kWordRows);
static_assert(problem(kFields) == nullptr, "the register map breaks a rule: register_fields.hpp");

Field no_such_field();  // not constexpr, and not defined: a wrong name does not compile

// The field of that name.
consteval Field field(const char* group, const char* name) {
  for (const Field& f : kFields) {
    if (same(group, f.group) && same(name, f.name)) return f;
  }
  return no_such_field();
}
// Word address of a register, within the map.
consteval int index_of(const char* group) {
  for (const Field& f : kFields) {
    if (same(group, f.group)) return f.address / 4;
  }
  return no_such_field().address;
}

// All fields of a register at their reset values.
consteval std::uint32_t reset_of(const char* group) {
  std::uint32_t reset = 0;
  for (const Field& f : kFields) {
    if (same(group, f.group)) reset |= f.reset << f.lsb;
  }
  return reset;
}

}  // namespace steplock
