// The register map of the sinusoidal drive: the fields of every drive where every drive has them, its
// own telemetry, and its words.
//
//     kSinusoidalSystemFields   those of every drive (hls/bus/register_map.hpp), and the telemetry
//     kSinusoidalWordRows       every word of the drive: hls/bus/sinusoidal_rows.hpp
//     kSinusoidalFields         both, which is the map; Sinusoidal is its name
//
// Doc: docs/sinusoidal_registers.md   Test: tests/hls/register_fields_test.cpp

#pragma once

#include <array>

#include "hls/bus/register_map.hpp"
#include "hls/bus/sinusoidal_rows.hpp"
#include "hls/sinusoidal/sinusoidal_control.hpp"

namespace steplock {

// The shortest PWM period that is one: a sample fits it, and 1 / (3 period) its word, u0.25.
inline constexpr int kShortestPeriod = SinusoidalLoop::kClocks + 2;
static_assert(kShortestPeriod == 477, "STATUS.no_period says 477");
static_assert((1 << 25) / (3 * kShortestPeriod) < 1 << decltype(BridgeConfig::reciprocal)::width);

inline constexpr auto kSinusoidalSystemFields = joined(joined(
    system_fields(
        {.kind = 2,
         .kind_prose = "2: sinusoidal drive.",
         .hall = 0,
         .counters = 0,
         .ramp = 0,
         .follower = 0,
         .states = "0 idle, 1 calibrate, 2 pilot pulses, 3 pattern, 4 starting, 5 run, 6 slow down, "
                   "7 brake, 8 retry delay, 9 fault.",
         .reasons = "Of the last failed attempt: 0 none, 1 fault pin, 2 over-current, 3 lost sample, "
                    "4 saturated, 5 too slow, 6 EMF, 7 no lock, 8 no decay, 9 no saliency, 10 no polarity.",
         .no_period = "PWM.period is below 477 clocks: all six gates are off, and the drive does not start, "
                      "whatever CONTROL says."}),
    std::to_array<Field>({
        {"TELEMETRY_SPEED", "speed", 0x30, 0, 16, Access::kReadOnly, 0, "s0.15 of 1/16 turn per sample",
         "Estimated, smoothed."},
        {"TELEMETRY_SPEED", "reference", 0x30, 16, 16, Access::kReadOnly, 0,
         "s0.15 of 1/16 turn per sample", "The set speed as it is followed, in the wanted direction."},
        {"TELEMETRY_CURRENT", "i_gamma", 0x34, 0, 16, Access::kReadOnly, 0, "s0.15",
         "Current along the estimated field."},
        {"TELEMETRY_CURRENT", "i_delta", 0x34, 16, 16, Access::kReadOnly, 0, "s0.15",
         "Current across it, which makes torque."},
        {"TELEMETRY_ANGLE", "angle", 0x38, 0, 16, Access::kReadOnly, 0, "u0.16 turns",
         "Estimated electrical angle of the last sample."},
        {"TELEMETRY_ANGLE", "v_dc", 0x38, 16, 12, Access::kReadOnly, 0, "u0.12", "DC voltage."},
        {"TELEMETRY_LEGS", "on_u", 0x3c, 0, 14, Access::kReadOnly, 0, "clocks",
         "On-time of leg u in the next period."},
        {"TELEMETRY_LEGS", "on_v", 0x3c, 16, 14, Access::kReadOnly, 0, "clocks", "Of leg v."},
        {"TELEMETRY_RETRIES", "retries", 0x40, 0, 4, Access::kReadOnly, 0, "",
         "Failed attempts since run was obeyed, but for the one that latched a fault."},
        {"TELEMETRY_RETRIES", "on_w", 0x40, 16, 14, Access::kReadOnly, 0, "clocks", "Of leg w."},
    })), control_fields());

inline constexpr auto kSinusoidalFields =
    joined(kSinusoidalSystemFields, fields_of(kSinusoidalWordRows));
static_assert(problem(kSinusoidalFields) == nullptr,
              "the register map breaks a rule: register_fields.hpp");

struct Sinusoidal {
  using Config = SinusoidalConfig;
  using State = SinusoidalState;
  using Reason = SinusoidalReason;

  static constexpr const auto& kSystemFields = kSinusoidalSystemFields;
  static constexpr const auto& kWordRows = kSinusoidalWordRows;
  static constexpr const auto& kFields = kSinusoidalFields;

  // A sample would not be through before the next one.
  static bool no_period(const Config& config) { return config.bridge.period < kShortestPeriod; }

  struct Shown {
    State state = State::kIdle;
    Reason reason = Reason::kNone;
    bool locked = false;
    bool reverse = false;
    Int<16> speed = 0;      // s0.15
    Int<16> reference = 0;  // s0.15
    Int<16> i_gamma = 0;    // s0.15
    Int<16> i_delta = 0;    // s0.15
    UInt<16> angle = 0;     // u0.16, turns
    UInt<12> v_dc = 0;      // u0.12
    LegClocks on_u = 0;     // clocks
    LegClocks on_v = 0;     // clocks
    LegClocks on_w = 0;     // clocks
    UInt<4> retries = 0;
  };

  static constexpr int kCopies = 5;
  static std::array<UInt<32>, kCopies> telemetry(const Shown& drive) {
    return {both(drive.speed, drive.reference), both(drive.i_gamma, drive.i_delta),
            both(drive.angle, drive.v_dc), both(drive.on_u, drive.on_v),
            both(drive.retries, drive.on_w)};
  }

 private:
  // Two numbers of one register, a negative one within its 16 bits.
  template <class Low, class High>
  static UInt<32> both(Low low, High high) {
    return bits_of(low) | (bits_of(high) << 16);
  }
};

}  // namespace steplock
