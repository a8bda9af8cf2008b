// Where every word of the sinusoidal drive stands in its register map, and how it may be written.
//
// A sample is computed over many clocks and takes its words where it needs them, so they stand still
// while the drive runs; but for the set-point, which is taken over between two samples.
//
//     kStopped   nearly all      kShadowed  the set-point      kKeyed  protects the hardware
//
// SPEED_TARGET stands where the six-step drive has it: one call of the C driver sets either.
//
// Doc: docs/sinusoidal_registers.md   Test: tests/hls/register_fields_test.cpp

#pragma once

#include <tuple>

#include "hls/bus/register_map.hpp"
#include "hls/sinusoidal/config.hpp"

namespace steplock {

inline constexpr auto kSinusoidalWordRows = std::make_tuple(
    word<&SinusoidalConfig::bridge, &BridgeConfig::period>(
        "PWM", "period", 0x80, 0, Access::kStopped, "clocks",
        "PWM period; too short a one keeps all six gates off, as STATUS.no_period says."),
    word<&SinusoidalConfig::bridge, &BridgeConfig::compensate>(
        "PWM", "compensate", 0x80, 24, Access::kStopped, "",
        "On-times make up for what the dead time takes."),
    word<&SinusoidalConfig::bridge, &BridgeConfig::sine_pwm>(
        "PWM", "sine_pwm", 0x80, 25, Access::kStopped, "",
        "No zero component: sines instead of space vectors."),
    word<&SinusoidalConfig::bridge, &BridgeConfig::minimum>(
        "PWM_LIMITS", "minimum", 0x84, 0, Access::kKeyed, "clocks",
        "Shorter on or off times become 0 or 100 %."),
    word<&SinusoidalConfig::bridge, &BridgeConfig::dead_time>(
        "PWM_LIMITS", "dead_time", 0x84, 16, Access::kKeyed, "clocks",
        "Dead time; not below CAPABILITY.dead_time_floor."),
    word<&SinusoidalConfig::bridge, &BridgeConfig::dead_time_loss>(
        "PWM_DEAD_TIME_LOSS", "loss", 0x88, 0, Access::kStopped, "u8.4 clocks",
        "What a leg loses by its dead time and its diode's drop."),
    word<&SinusoidalConfig::bridge, &BridgeConfig::reciprocal>(
        "PWM_RECIPROCAL", "reciprocal", 0x8c, 0, Access::kStopped, "u0.25",
        "1 / (3 PWM.period)."),
    word<&SinusoidalConfig::estimator, &EstimatorConfig::voltage>(
        "ESTIMATOR", "voltage", 0x90, 0, Access::kStopped, "",
        "Estimate of 0 the current model, 1 the voltage model."),
    word<&SinusoidalConfig::estimator, &EstimatorConfig::average>(
        "ESTIMATOR", "average", 0x90, 1, Access::kStopped, "",
        "Voltage model: the mean of 8 samples."),
    word<&SinusoidalConfig::estimator, &EstimatorConfig::decay>(
        "ESTIMATOR", "decay", 0x90, 16, Access::kStopped, "u0.15 per sample",
        "Of the current, by resistance."),
    word<&SinusoidalConfig::estimator, &EstimatorConfig::gain>(
        "ESTIMATOR_GAIN", "gain", 0x94, 0, Access::kStopped, "u2.13",
        "Current that a voltage makes in a sample."),
    word<&SinusoidalConfig::estimator, &EstimatorConfig::k_theta>(
        "ESTIMATOR_GAIN", "k_theta", 0x94, 16, Access::kStopped, "u1.14",
        "Turns per current; of the voltage model too."),
    word<&SinusoidalConfig::estimator, &EstimatorConfig::k_e>(
        "ESTIMATOR_EMF", "k_e", 0x98, 0, Access::kStopped, "u2.13",
        "Voltage per current."),
    word<&SinusoidalConfig::estimator, &EstimatorConfig::k_emf>(
        "ESTIMATOR_EMF", "k_emf", 0x98, 16, Access::kStopped, "u0.15",
        "Turns per current."),
    word<&SinusoidalConfig::estimator, &EstimatorConfig::k_speed>(
        "ESTIMATOR_SPEED", "k_speed", 0x9c, 0, Access::kStopped, "u-2.17",
        "Turns per voltage."),
    word<&SinusoidalConfig::estimator, &EstimatorConfig::k_si>(
        "ESTIMATOR_SPEED", "k_si", 0x9c, 16, Access::kStopped, "u-8.23",
        "Turns per current."),
    word<&SinusoidalConfig::control, &ControlConfig::set_gamma>(
        "CURRENT", "set_gamma", 0xa0, 0, Access::kStopped, "s0.15",
        "The wanted current along the rotor's field."),
    word<&SinusoidalConfig::control, &ControlConfig::limit>(
        "CURRENT", "limit", 0xa0, 16, Access::kStopped, "u0.15",
        "Of the voltage, as a part of the dc voltage."),
    word<&SinusoidalConfig::control, &ControlConfig::k_p>(
        "CURRENT_GAIN", "k_p", 0xa4, 0, Access::kStopped, "u3.12",
        "Voltage per current."),
    word<&SinusoidalConfig::control, &ControlConfig::k_i>(
        "CURRENT_GAIN", "k_i", 0xa4, 16, Access::kStopped, "u0.15 per sample",
        "Voltage per current."),
    word<&SinusoidalConfig::control, &ControlConfig::inductance>(
        "CURRENT_DECOUPLING", "inductance", 0xa8, 0, Access::kStopped, "u5.10",
        "Voltage per current and speed."),
    word<&SinusoidalConfig::control, &ControlConfig::emf>(
        "CURRENT_DECOUPLING", "emf", 0xa8, 16, Access::kStopped, "u5.10",
        "Voltage per speed."),
    word<&SinusoidalConfig::sequence, &SequenceConfig::arbitrary>(
        "START", "arbitrary", 0xac, 0, Access::kStopped, "",
        "No pattern before the loop is closed."),
    word<&SinusoidalConfig::sequence, &SequenceConfig::pilot>(
        "START", "pilot", 0xac, 1, Access::kStopped, "",
        "Pilot pulses instead of the pattern: a salient rotor."),
    word<&SinusoidalConfig::sequence, &SequenceConfig::retries>(
        "START", "retries", 0xac, 4, Access::kStopped, "",
        "Failed attempts before the fault latches."),
    word<&SinusoidalConfig::sequence, &SequenceConfig::hold_voltage>(
        "START", "hold_voltage", 0xac, 16, Access::kStopped, "u0.15",
        "Of the pattern's leg, or of a pilot pulse's."),
    word<&SinusoidalConfig::sequence, &SequenceConfig::pattern>(
        "START_PATTERN", "pattern", 0xb0, 0, Access::kStopped, "periods",
        "Each third of the pattern; all pilot pulses at most."),
    word<&SinusoidalConfig::sequence, &SequenceConfig::lock>(
        "START_LOCK", "lock", 0xb4, 0, Access::kStopped, "periods",
        "The estimate has to be trusted for so long."),
    word<&SinusoidalConfig::sequence, &SequenceConfig::give_up>(
        "START_GIVE_UP", "give_up", 0xb8, 0, Access::kStopped, "periods",
        "No lock in this time is a failed attempt."),
    word<&SinusoidalConfig::sequence, &SequenceConfig::retry_delay>(
        "START_RETRY", "retry_delay", 0xbc, 0, Access::kStopped, "periods",
        "Gates off between a failure and the next attempt."),
    word<&SinusoidalConfig::sequence, &SequenceConfig::brake>(
        "STOP_BRAKE", "brake", 0xc0, 0, Access::kStopped, "periods",
        "Low sides on at the end of a stop."),
    word<&SinusoidalConfig::pilot, &PilotConfig::short_periods>(
        "PILOT", "short_periods", 0xc4, 0, Access::kStopped, "periods",
        "Of a short pulse; 0 counts as 1."),
    word<&SinusoidalConfig::pilot, &PilotConfig::long_periods>(
        "PILOT", "long_periods", 0xc4, 8, Access::kStopped, "periods",
        "Of a long pulse; 0 counts as 1."),
    word<&SinusoidalConfig::pilot, &PilotConfig::rounds>(
        "PILOT", "rounds", 0xc4, 16, Access::kStopped, "",
        "Of six short pulses; even."),
    word<&SinusoidalConfig::pilot, &PilotConfig::decayed>(
        "PILOT_CURRENTS", "decayed", 0xc8, 0, Access::kStopped, "u0.15",
        "Below, a current is gone."),
    word<&SinusoidalConfig::pilot, &PilotConfig::saliency>(
        "PILOT_CURRENTS", "saliency", 0xc8, 16, Access::kStopped, "u0.15",
        "A smaller sum is no position."),
    word<&SinusoidalConfig::speed, &RegulatorConfig::target>(
        "SPEED_TARGET", "target", 0xcc, 0, Access::kShadowed, "u0.25 of 1/16 turn per sample",
        "The set speed. 0 while running: stop, by slowing down and braking."),
    word<&SinusoidalConfig::speed, &RegulatorConfig::slew>(
        "SPEED_SLEW", "slew", 0xd0, 0, Access::kStopped, "u0.25 per sample",
        "Largest change of the set speed that is followed."),
    word<&SinusoidalConfig::speed, &RegulatorConfig::filter>(
        "SPEED_SLEW", "filter", 0xd0, 16, Access::kStopped, "u0.15 per sample",
        "Of the estimated speed."),
    word<&SinusoidalConfig::speed, &RegulatorConfig::k_p>(
        "SPEED_GAIN", "k_p", 0xd4, 0, Access::kStopped, "u7.8",
        "Current per speed."),
    word<&SinusoidalConfig::speed, &RegulatorConfig::k_i>(
        "SPEED_GAIN", "k_i", 0xd4, 16, Access::kStopped, "u-2.17 per sample",
        "Current per speed."),
    word<&SinusoidalConfig::speed, &RegulatorConfig::limit>(
        "SPEED_CURRENT", "limit", 0xd8, 0, Access::kStopped, "u0.15",
        "Of the wanted current."),
    word<&SinusoidalConfig::speed, &RegulatorConfig::lock>(
        "SPEED_CURRENT", "lock", 0xd8, 16, Access::kStopped, "u0.15 of 1/16 turn per sample",
        "Above this speed the estimate may be trusted."),
    word<&SinusoidalConfig::speed, &RegulatorConfig::slow>(
        "SPEED_STOP", "slow", 0xdc, 0, Access::kStopped, "u0.15 of 1/16 turn per sample",
        "Below, it may not."),
    word<&SinusoidalConfig::speed, &RegulatorConfig::stop>(
        "SPEED_STOP", "stop", 0xdc, 16, Access::kStopped, "u0.15 of 1/16 turn per sample",
        "Below, the drive lets go."),
    word<&SinusoidalConfig::speed, &RegulatorConfig::emf_low>(
        "SPEED_EMF", "emf_low", 0xe0, 0, Access::kStopped, "u2.13",
        "An EMF belongs to the speed if it is above so many times K_E speed,"),
    word<&SinusoidalConfig::speed, &RegulatorConfig::emf_high>(
        "SPEED_EMF", "emf_high", 0xe0, 16, Access::kStopped, "u2.13",
        "and below so many."),
    word<&SinusoidalConfig::pilot, &PilotConfig::polarity>(
        "PILOT_POLARITY", "polarity", 0xe4, 0, Access::kStopped, "u0.15",
        "A smaller difference of the long peaks is no polarity."),
    word<&SinusoidalConfig::fault, &FaultConfig::over_current>(
        "PROTECTION", "over_current", 0xe8, 0, Access::kKeyed, "u0.15",
        "A larger current of any phase latches the fault."),
    word<&SinusoidalConfig::fault, &FaultConfig::lost_samples>(
        "PROTECTION", "lost_samples", 0xe8, 16, Access::kKeyed, "",
        "So many in a row latch the fault; 0: no test."),
    word<&SinusoidalConfig::fault, &FaultConfig::saturated>(
        "PROTECTION_SATURATED", "saturated", 0xec, 0, Access::kKeyed, "periods",
        "A regulator at its limit for more than this; 0: no test."),
    word<&SinusoidalConfig::fault, &FaultConfig::slow>(
        "PROTECTION_SLOW", "slow", 0xf0, 0, Access::kKeyed, "periods",
        "Slow for more than this longer than not; 0: no test."),
    word<&SinusoidalConfig::fault, &FaultConfig::emf>(
        "PROTECTION_EMF", "emf", 0xf4, 0, Access::kKeyed, "periods",
        "An EMF that does not belong to the speed for more; 0: no test."),
    word<&SinusoidalConfig::speed, &RegulatorConfig::start_current>(
        "START_CURRENT", "start_current", 0xf8, 0, Access::kStopped, "u0.15",
        "The wanted current at first, when the loop is closed."));

}  // namespace steplock
