// Where every word of the six-step drive stands in its register map, and how it may be written.
//
// A row names a member of SixStepConfig by the way to it; its width and reset value come from there, so
// that the map cannot disagree with the blocks.  A word without a row is found by the test.
//
//     kReadWrite  may be tuned while the motor turns      kStopped  shapes the start or the bridge
//     kShadowed   the set-point                           kKeyed    protects the hardware
//
// Doc: docs/six_step_registers.md   Test: tests/hls/register_fields_test.cpp

#pragma once

#include <tuple>

#include "hls/bus/register_map.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

template <>
inline constexpr int kBitsOf<Sampling> = 2;
template <>
inline constexpr int kBitsOf<Detector> = 1;
template <>
inline constexpr int kBitsOf<Bandwidth> = 1;
template <>
inline constexpr int kBitsOf<Source> = 1;
template <>
inline constexpr int kBitsOf<Method> = 1;

inline constexpr auto kWordRows = std::make_tuple(
    word<&SixStepConfig::pwm, &PwmConfig::period>(
        "PWM", "period", 0x80, 0, Access::kStopped, "clocks",
        "PWM period; 0 keeps all six gates off, as STATUS.no_period says."),
    word<&SixStepConfig::pwm, &PwmConfig::centred>(
        "PWM", "centred", 0x80, 16, Access::kStopped, "",
        "Pulses centred in the period instead of at its start."),
    word<&SixStepConfig::pwm, &PwmConfig::complementary>(
        "PWM", "complementary", 0x80, 17, Access::kStopped, "",
        "The low side of the chopped leg conducts in the off-time."),
    word<&SixStepConfig::pwm, &PwmConfig::tick_periods>(
        "PWM", "tick_periods", 0x80, 24, Access::kStopped, "periods",
        "PWM periods per tick, the time base of all that is slow; 0 counts as 1."),
    word<&SixStepConfig::pwm, &PwmConfig::minimum>(
        "PWM_LIMITS", "minimum", 0x84, 0, Access::kKeyed, "clocks",
        "Shorter on or off times become 0 or 100 %."),
    word<&SixStepConfig::pwm, &PwmConfig::dead_time>(
        "PWM_LIMITS", "dead_time", 0x84, 16, Access::kKeyed, "clocks",
        "Dead time; not below CAPABILITY.dead_time_floor."),
    word<&SixStepConfig::limit, &LimitConfig::blanking>(
        "CURRENT_LIMIT", "blanking", 0x88, 0, Access::kKeyed, "clocks",
        "After switch-on, time in which the limit comparator is not believed."),
    word<&SixStepConfig::limit, &LimitConfig::off_time>(
        "CURRENT_LIMIT", "off_time", 0x88, 16, Access::kKeyed, "clocks",
        "Off-time after a hit; 0 disables the limit. A quarter of it while a hit turns all gates off: until the rotor is followed, and while the drive runs."),
    word<&SixStepConfig::bemf, &BemfConfig::sampling>(
        "BEMF", "sampling", 0x8c, 0, Access::kStopped, "",
        "Comparators are sampled in 0 on-time, 1 off-time, 2 both."),
    word<&SixStepConfig::bemf, &BemfConfig::blanking>(
        "BEMF", "blanking", 0x8c, 4, Access::kStopped, "clocks",
        "After each edge of the chopped gate."),
    word<&SixStepConfig::bemf, &BemfConfig::sample_every>(
        "BEMF", "sample_every", 0x8c, 16, Access::kStopped, "clocks",
        "Between samples; 0 counts as 1."),
    word<&SixStepConfig::bemf, &BemfConfig::samples>(
        "BEMF", "samples", 0x8c, 24, Access::kStopped, "",
        "Of the filter; 0 counts as 1."),
    word<&SixStepConfig::loop, &LoopConfig::detector>(
        "LOOP", "detector", 0x90, 0, Access::kStopped, "",
        "Phase detector: 0 once per turn, 1 every step."),
    word<&SixStepConfig::loop, &LoopConfig::bandwidth>(
        "LOOP", "bandwidth", 0x90, 1, Access::kStopped, "",
        "Of the loop: 0 per second, 1 per step."),
    word<&SixStepConfig::loop, &LoopConfig::divide>(
        "LOOP", "divide", 0x90, 2, Access::kStopped, "",
        "N = 6 * 2^divide VCO turns per electrical turn."),
    word<&SixStepConfig::source>(
        "LOOP", "source", 0x90, 4, Access::kStopped, "",
        "Position from 0 back-EMF, 1 Hall sensors."),
    word<&SixStepConfig::speed, &SpeedConfig::shift>(
        "LOOP", "speed_shift", 0x90, 8, Access::kStopped, "",
        "Speeds are normalised: frequency >> shift fits 15 bits."),
    word<&SixStepConfig::loop, &LoopConfig::delay>(
        "LOOP", "delay", 0x90, 16, Access::kStopped, "clocks",
        "From the crossing at the motor to the sample."),
    word<&SixStepConfig::loop, &LoopConfig::expected>(
        "LOOP_PHASE", "expected", 0x94, 0, Access::kReadWrite, "u0.16 step",
        "The crossing's place in the step: 1/2 + advance / 60 degrees."),
    word<&SixStepConfig::loop, &LoopConfig::lead_error>(
        "LOOP_PHASE", "lead_error", 0x94, 16, Access::kReadWrite, "u0.16 step",
        "Error when the level before the crossing never showed and the rotor led before."),
    word<&SixStepConfig::loop, &LoopConfig::ki>(
        "LOOP_GAIN", "ki", 0x98, 0, Access::kReadWrite, "u2.14",
        "Integral gain."),
    word<&SixStepConfig::loop, &LoopConfig::kp>(
        "LOOP_GAIN", "kp", 0x98, 16, Access::kReadWrite, "u2.14",
        "Proportional gain."),
    word<&SixStepConfig::loop, &LoopConfig::alpha>(
        "LOOP_ALPHA", "alpha", 0x9c, 0, Access::kReadWrite, "u1.15",
        "1 - exp(-omega_p T); 0x8000 is no pole."),
    word<&SixStepConfig::loop, &LoopConfig::scale>(
        "LOOP_SCALE", "scale", 0xa0, 0, Access::kReadWrite, "u0.32 turns/clock",
        "Unit of the gains when they are per second."),
    word<&SixStepConfig::loop, &LoopConfig::minimum>(
        "LOOP_MINIMUM", "minimum", 0xa4, 0, Access::kReadWrite, "u0.32 turns/clock",
        "Least frequency."),
    word<&SixStepConfig::loop, &LoopConfig::maximum>(
        "LOOP_MAXIMUM", "maximum", 0xa8, 0, Access::kReadWrite, "u0.32 turns/clock",
        "Largest frequency."),
    word<&SixStepConfig::start, &StartConfig::pre_align>(
        "START_ALIGN", "pre_align", 0xac, 0, Access::kStopped, "ticks",
        "Of the pattern before the alignment."),
    word<&SixStepConfig::start, &StartConfig::align>(
        "START_ALIGN", "align", 0xac, 16, Access::kStopped, "ticks",
        "Of the alignment pattern."),
    word<&SixStepConfig::start, &StartConfig::align_duty>(
        "START_DUTY", "align_duty", 0xb0, 0, Access::kStopped, "u1.15",
        "Of both alignment patterns; twice that from the third attempt on. Following: until the rotor is followed."),
    word<&SixStepConfig::start, &StartConfig::start_duty>(
        "START_DUTY", "start_duty", 0xb0, 16, Access::kStopped, "u1.15",
        "During acceleration and pull-in, above the back-EMF; twice that from the third attempt on."),
    word<&SixStepConfig::start, &StartConfig::ramp>(
        "START_RAMP", "ramp", 0xb4, 0, Access::kStopped, "u0.32 per tick",
        "Acceleration of the VCO."),
    word<&SixStepConfig::start, &StartConfig::hand_over>(
        "START_HAND_OVER", "hand_over", 0xb8, 0, Access::kStopped, "u0.32 turns/clock",
        "Frequency at the end of the ramp."),
    word<&SixStepConfig::start, &StartConfig::window>(
        "START_LOCK", "window", 0xbc, 0, Access::kStopped, "u0.16 step",
        "A crossing closer than this to its place is a good one."),
    word<&SixStepConfig::start, &StartConfig::good_crossings>(
        "START_LOCK", "good_crossings", 0xbc, 16, Access::kStopped, "",
        "So many in a row are a lock."),
    word<&SixStepConfig::start, &StartConfig::retries>(
        "START_LOCK", "retries", 0xbc, 24, Access::kStopped, "",
        "Failed attempts before the fault latches."),
    word<&SixStepConfig::start, &StartConfig::method>(
        "START_LOCK", "method", 0xbc, 31, Access::kStopped, "",
        "Of the start: 0 alignment and ramp, 1 following the rotor."),
    word<&SixStepConfig::start, &StartConfig::pull_in>(
        "START_TIMES", "pull_in", 0xc0, 0, Access::kStopped, "ticks",
        "Time limit from hand-over to lock."),
    word<&SixStepConfig::start, &StartConfig::retry_delay>(
        "START_TIMES", "retry_delay", 0xc0, 16, Access::kStopped, "ticks",
        "Gates off between a failure and the next attempt."),
    word<&SixStepConfig::start, &StartConfig::detect_spin>(
        "START_SPIN", "detect_spin", 0xc4, 0, Access::kStopped, "ticks",
        "Time to look for a rotor that already spins; 0 skips it."),
    word<&SixStepConfig::start, &StartConfig::slow_down>(
        "START_SPIN", "slow_down", 0xc4, 16, Access::kStopped, "ticks",
        "Time limit for slowing down before a reversal."),
    word<&SixStepConfig::start, &StartConfig::brake>(
        "START_BRAKE", "brake", 0xc8, 0, Access::kStopped, "ticks",
        "One braking interval."),
    word<&SixStepConfig::start, &StartConfig::brake_duty>(
        "START_BRAKE", "brake_duty", 0xc8, 16, Access::kStopped, "u1.15",
        "Duty of braking at standstill, from which the back-EMF's is taken."),
    word<&SixStepConfig::speed, &SpeedConfig::target>(
        "SPEED_TARGET", "target", 0xcc, 0, Access::kShadowed, "u0.32 turns/clock",
        "The set speed. 0 while running: stop, by slowing down and braking."),
    word<&SixStepConfig::speed, &SpeedConfig::slew>(
        "SPEED_SLEW", "slew", 0xd0, 0, Access::kReadWrite, "u0.32 per tick",
        "Largest change of the set speed that is followed."),
    word<&SixStepConfig::speed, &SpeedConfig::kp>(
        "SPEED_GAIN", "kp", 0xd4, 0, Access::kReadWrite, "u4.12",
        "Duty per normalised speed error."),
    word<&SixStepConfig::speed, &SpeedConfig::ki>(
        "SPEED_GAIN", "ki", 0xd4, 16, Access::kReadWrite, "u0.16 per tick",
        "Integral gain."),
    word<&SixStepConfig::speed, &SpeedConfig::bemf>(
        "SPEED_BEMF", "bemf", 0xd8, 0, Access::kReadWrite, "u4.12",
        "Duty whose mean voltage is the back-EMF, per speed."),
    word<&SixStepConfig::speed, &SpeedConfig::loaded>(
        "SPEED_BEMF", "loaded", 0xd8, 16, Access::kReadWrite, "u4.12",
        "The same, and of commutating the largest current."),
    word<&SixStepConfig::speed, &SpeedConfig::minimum>(
        "SPEED_DUTY", "minimum", 0xdc, 0, Access::kReadWrite, "u1.15",
        "Least duty."),
    word<&SixStepConfig::speed, &SpeedConfig::maximum>(
        "SPEED_DUTY", "maximum", 0xdc, 16, Access::kReadWrite, "u1.15",
        "Largest duty."),
    word<&SixStepConfig::speed, &SpeedConfig::duty_slew>(
        "SPEED_DUTY_SLEW", "duty_slew", 0xe0, 0, Access::kReadWrite, "u1.15 per tick",
        "Largest change of the duty."),
    word<&SixStepConfig::protection, &ProtectionConfig::stall>(
        "PROTECTION_STALL", "stall", 0xe4, 0, Access::kKeyed, "u0.32 turns/clock",
        "Slower than this in speed control is a stall."),
    word<&SixStepConfig::protection, &ProtectionConfig::slip>(
        "PROTECTION_DUTY", "slip", 0xe8, 0, Access::kKeyed, "u1.15",
        "Duty above the back-EMF's that no right lock shows."),
    word<&SixStepConfig::protection, &ProtectionConfig::freewheel>(
        "PROTECTION_DUTY", "freewheel", 0xe8, 16, Access::kKeyed, "u0.16 step",
        "Freewheeling for longer than this is wrong."),
    word<&SixStepConfig::protection, &ProtectionConfig::misses>(
        "PROTECTION_LOCK", "misses", 0xec, 0, Access::kKeyed, "",
        "Lost lock: score of missed and far crossings; 0: off."),
    word<&SixStepConfig::protection, &ProtectionConfig::wrong_lock>(
        "PROTECTION_LOCK", "wrong_lock", 0xec, 8, Access::kKeyed, "ticks",
        "Time limit of a wrong lock; 0 disables."),
    word<&SixStepConfig::protection, &ProtectionConfig::over_current>(
        "PROTECTION_LOCK", "over_current", 0xec, 24, Access::kKeyed, "",
        "Limit hits in a row with the comparator never released; 0 disables."),
    word<&SixStepConfig::start, &StartConfig::look>(
        "START_FOLLOW", "look", 0xf0, 0, Access::kStopped, "samples",
        "Gates off before a look, less one, in BEMF.sample_every."),
    word<&SixStepConfig::start, &StartConfig::probe>(
        "START_FOLLOW", "probe", 0xf0, 16, Access::kStopped, "samples",
        "Of a drive between two looks, in BEMF.sample_every."),
    word<&SixStepConfig::start, &StartConfig::still>(
        "START_STILL", "still", 0xf4, 0, Access::kStopped, "",
        "Looks without news after which the step moves on."));

}  // namespace steplock
