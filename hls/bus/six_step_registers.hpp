// The register map of the six-step drive.  Everything else that knows an address is made of this
// table: the decoder, the C header, the pages, SystemRDL and IP-XACT (steplock registers).
//
//     kSystemFields   those of every drive (hls/bus/register_map.hpp), and the telemetry
//     kWordRows       every word of the drive: hls/bus/word_rows.hpp
//     kFields         both, which is the map; SixStep is its name
//
// Doc: docs/six_step_registers.md   Test: tests/hls/register_fields_test.cpp

#pragma once

#include <array>

#include "hls/bus/register_map.hpp"
#include "hls/bus/word_rows.hpp"
#include "hls/six_step/telemetry.hpp"

namespace steplock {

inline constexpr auto kSystemFields = joined(joined(
    system_fields(
        {.kind = 1,
         .kind_prose = "1: six-step drive.",
         .hall = 1,
         .counters = 1,
         .ramp = 1,
         .follower = 1,
         .states = "0 idle, 1 detect spin, 2 brake, 3 pre-align, 4 align, 5 accelerate, 6 pull in, 7 run, "
                   "8 slow down, 9 retry delay, 10 fault.",
         .reasons = "Of the last failed attempt: 0 none, 1 fault pin, 2 over-current, 3 step-out, 4 stall, "
                    "5 wrong lock, 6 no lock, 7 cannot stop, 8 Hall code, 9 blocked.",
         .no_period = "PWM.period is 0: all six gates are off, and the drive does not start, whatever "
                      "CONTROL says."}),
    std::to_array<Field>({
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
        {"TELEMETRY_RETRIES", "retries", 0x40, 0, 16, Access::kReadOnly, 0, "", "Failed attempts."},
    })), control_fields());

inline constexpr auto kFields = joined(kSystemFields, fields_of(kWordRows));
static_assert(problem(kFields) == nullptr, "the register map breaks a rule: register_fields.hpp");

struct SixStep {
  using Config = SixStepConfig;
  using State = steplock::State;
  using Reason = steplock::Reason;

  static constexpr const auto& kSystemFields = steplock::kSystemFields;
  static constexpr const auto& kWordRows = steplock::kWordRows;
  static constexpr const auto& kFields = steplock::kFields;

  // The drive would hold a low side on, and its start would not end.
  static bool no_period(const Config& config) { return config.pwm.period == Clocks(0); }

  struct Shown {
    State state = State::kIdle;
    Reason reason = Reason::kNone;
    bool locked = false;
    bool reverse = false;
    Frequency frequency = 0;     // u0.32
    Duty duty = 0;               // u1.15
    PhaseError phase_error = 0;  // s0.16
    Telemetry::Out counts;
  };

  static constexpr int kCopies = 5;
  static std::array<UInt<32>, kCopies> telemetry(const Shown& drive) {
    return {UInt<32>(drive.frequency),
            both(drive.duty, UInt<16>::of(drive.phase_error.raw())),
            both(drive.counts.crossings, drive.counts.missed),
            both(drive.counts.freewheel_long, drive.counts.limit_hits),
            UInt<32>(drive.counts.retries)};
  }

 private:
  static UInt<32> both(UInt<16> low, UInt<16> high) { return UInt<32>(low) | (UInt<32>(high) << 16); }
};

}  // namespace steplock
