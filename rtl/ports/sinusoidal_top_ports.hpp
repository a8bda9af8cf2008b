// Ports of module sinusoidal_top, from hls/sinusoidal/sinusoidal_top.hpp.
// Printed by hlsgen; do not edit.

#pragma once

#include "generator/port_words.hpp"

namespace steplock::ports::sinusoidal_top {

template <class Rtl, class In>
void drive_ports([[maybe_unused]] Rtl& rtl, [[maybe_unused]] const In& in) {
  set_port(rtl.fault_i, word_of(in.fault, 1));
  set_port(rtl.codes_valid_i, word_of(in.codes.valid, 1));
  set_port(rtl.codes_u_i, word_of(in.codes.u, 12));
  set_port(rtl.codes_v_i, word_of(in.codes.v, 12));
  set_port(rtl.codes_dc_i, word_of(in.codes.dc, 12));
  set_port(rtl.command_configured_i, word_of(in.command.configured, 1));
  set_port(rtl.command_run_i, word_of(in.command.run, 1));
  set_port(rtl.command_reverse_i, word_of(in.command.reverse, 1));
  set_port(rtl.command_brake_to_stop_i, word_of(in.command.brake_to_stop, 1));
  set_port(rtl.command_clear_fault_i, word_of(in.command.clear_fault, 1));
  set_port(rtl.config_bridge_period_i, word_of(in.config.bridge.period, 14));
  set_port(rtl.config_bridge_minimum_i, word_of(in.config.bridge.minimum, 14));
  set_port(rtl.config_bridge_dead_time_i, word_of(in.config.bridge.dead_time, 8));
  set_port(rtl.config_bridge_dead_time_loss_i, word_of(in.config.bridge.dead_time_loss, 12));
  set_port(rtl.config_bridge_compensate_i, word_of(in.config.bridge.compensate, 1));
  set_port(rtl.config_bridge_sine_pwm_i, word_of(in.config.bridge.sine_pwm, 1));
  set_port(rtl.config_bridge_reciprocal_i, word_of(in.config.bridge.reciprocal, 15));
  set_port(rtl.config_estimator_voltage_i, word_of(in.config.estimator.voltage, 1));
  set_port(rtl.config_estimator_average_i, word_of(in.config.estimator.average, 1));
  set_port(rtl.config_estimator_decay_i, word_of(in.config.estimator.decay, 15));
  set_port(rtl.config_estimator_gain_i, word_of(in.config.estimator.gain, 15));
  set_port(rtl.config_estimator_k_theta_i, word_of(in.config.estimator.k_theta, 15));
  set_port(rtl.config_estimator_k_e_i, word_of(in.config.estimator.k_e, 15));
  set_port(rtl.config_estimator_k_speed_i, word_of(in.config.estimator.k_speed, 15));
  set_port(rtl.config_estimator_k_emf_i, word_of(in.config.estimator.k_emf, 15));
  set_port(rtl.config_estimator_k_si_i, word_of(in.config.estimator.k_si, 15));
  set_port(rtl.config_speed_target_i, word_of(in.config.speed.target, 25));
  set_port(rtl.config_speed_slew_i, word_of(in.config.speed.slew, 15));
  set_port(rtl.config_speed_filter_i, word_of(in.config.speed.filter, 15));
  set_port(rtl.config_speed_k_p_i, word_of(in.config.speed.k_p, 15));
  set_port(rtl.config_speed_k_i_i, word_of(in.config.speed.k_i, 15));
  set_port(rtl.config_speed_limit_i, word_of(in.config.speed.limit, 15));
  set_port(rtl.config_speed_start_current_i, word_of(in.config.speed.start_current, 15));
  set_port(rtl.config_speed_lock_i, word_of(in.config.speed.lock, 15));
  set_port(rtl.config_speed_slow_i, word_of(in.config.speed.slow, 15));
  set_port(rtl.config_speed_stop_i, word_of(in.config.speed.stop, 15));
  set_port(rtl.config_speed_emf_low_i, word_of(in.config.speed.emf_low, 15));
  set_port(rtl.config_speed_emf_high_i, word_of(in.config.speed.emf_high, 15));
  set_port(rtl.config_control_set_gamma_i, word_of(in.config.control.set_gamma, 16));
  set_port(rtl.config_control_k_p_i, word_of(in.config.control.k_p, 15));
  set_port(rtl.config_control_k_i_i, word_of(in.config.control.k_i, 15));
  set_port(rtl.config_control_inductance_i, word_of(in.config.control.inductance, 15));
  set_port(rtl.config_control_emf_i, word_of(in.config.control.emf, 15));
  set_port(rtl.config_control_limit_i, word_of(in.config.control.limit, 15));
  set_port(rtl.config_sequence_arbitrary_i, word_of(in.config.sequence.arbitrary, 1));
  set_port(rtl.config_sequence_pilot_i, word_of(in.config.sequence.pilot, 1));
  set_port(rtl.config_sequence_hold_voltage_i, word_of(in.config.sequence.hold_voltage, 15));
  set_port(rtl.config_sequence_pattern_i, word_of(in.config.sequence.pattern, 20));
  set_port(rtl.config_sequence_lock_i, word_of(in.config.sequence.lock, 20));
  set_port(rtl.config_sequence_give_up_i, word_of(in.config.sequence.give_up, 20));
  set_port(rtl.config_sequence_brake_i, word_of(in.config.sequence.brake, 20));
  set_port(rtl.config_sequence_retry_delay_i, word_of(in.config.sequence.retry_delay, 20));
  set_port(rtl.config_sequence_retries_i, word_of(in.config.sequence.retries, 4));
  set_port(rtl.config_pilot_short_periods_i, word_of(in.config.pilot.short_periods, 6));
  set_port(rtl.config_pilot_long_periods_i, word_of(in.config.pilot.long_periods, 6));
  set_port(rtl.config_pilot_rounds_i, word_of(in.config.pilot.rounds, 5));
  set_port(rtl.config_pilot_decayed_i, word_of(in.config.pilot.decayed, 15));
  set_port(rtl.config_pilot_saliency_i, word_of(in.config.pilot.saliency, 15));
  set_port(rtl.config_pilot_polarity_i, word_of(in.config.pilot.polarity, 15));
  set_port(rtl.config_fault_over_current_i, word_of(in.config.fault.over_current, 15));
  set_port(rtl.config_fault_saturated_i, word_of(in.config.fault.saturated, 20));
  set_port(rtl.config_fault_slow_i, word_of(in.config.fault.slow, 20));
  set_port(rtl.config_fault_emf_i, word_of(in.config.fault.emf, 20));
  set_port(rtl.config_fault_lost_samples_i, word_of(in.config.fault.lost_samples, 4));
}

// The first output port that differs, or null.
template <class Rtl, class Out>
const char* differs([[maybe_unused]] const Rtl& rtl, [[maybe_unused]] const Out& out) {
  if (word_at(rtl.gates_uh_o) != word_of(out.gates.uh, 1)) return "gates_uh_o";
  if (word_at(rtl.gates_ul_o) != word_of(out.gates.ul, 1)) return "gates_ul_o";
  if (word_at(rtl.gates_vh_o) != word_of(out.gates.vh, 1)) return "gates_vh_o";
  if (word_at(rtl.gates_vl_o) != word_of(out.gates.vl, 1)) return "gates_vl_o";
  if (word_at(rtl.gates_wh_o) != word_of(out.gates.wh, 1)) return "gates_wh_o";
  if (word_at(rtl.gates_wl_o) != word_of(out.gates.wl, 1)) return "gates_wl_o";
  if (word_at(rtl.state_o) != word_of(out.state, 4)) return "state_o";
  if (word_at(rtl.reason_o) != word_of(out.reason, 4)) return "reason_o";
  if (word_at(rtl.sample_o) != word_of(out.sample, 1)) return "sample_o";
  if (word_at(rtl.locked_o) != word_of(out.locked, 1)) return "locked_o";
  if (word_at(rtl.estimating_o) != word_of(out.estimating, 1)) return "estimating_o";
  if (word_at(rtl.done_o) != word_of(out.done, 1)) return "done_o";
  if (word_at(rtl.busy_o) != word_of(out.busy, 1)) return "busy_o";
  if (word_at(rtl.reverse_o) != word_of(out.reverse, 1)) return "reverse_o";
  if (word_at(rtl.retries_o) != word_of(out.retries, 4)) return "retries_o";
  if (word_at(rtl.angle_o) != word_of(out.angle, 24)) return "angle_o";
  if (word_at(rtl.initial_o) != word_of(out.initial, 24)) return "initial_o";
  if (word_at(rtl.speed_o) != word_of(out.speed, 16)) return "speed_o";
  if (word_at(rtl.reference_o) != word_of(out.reference, 16)) return "reference_o";
  if (word_at(rtl.i_gamma_o) != word_of(out.i_gamma, 16)) return "i_gamma_o";
  if (word_at(rtl.i_delta_o) != word_of(out.i_delta, 16)) return "i_delta_o";
  if (word_at(rtl.wanted_o) != word_of(out.wanted, 16)) return "wanted_o";
  if (word_at(rtl.v_dc_o) != word_of(out.v_dc, 12)) return "v_dc_o";
  if (word_at(rtl.on_u_o) != word_of(out.on_u, 14)) return "on_u_o";
  if (word_at(rtl.on_v_o) != word_of(out.on_v, 14)) return "on_v_o";
  if (word_at(rtl.on_w_o) != word_of(out.on_w, 14)) return "on_w_o";
  return nullptr;
}

// Stimulus::bits(width) gives a number of so many bits.
template <class In, class Stimulus>
void randomise([[maybe_unused]] In& in, [[maybe_unused]] Stimulus& stimulus) {
  set_number(in.fault, stimulus.bits(1));
  set_number(in.codes.valid, stimulus.bits(1));
  set_number(in.codes.u, stimulus.bits(12));
  set_number(in.codes.v, stimulus.bits(12));
  set_number(in.codes.dc, stimulus.bits(12));
  set_number(in.command.configured, stimulus.bits(1));
  set_number(in.command.run, stimulus.bits(1));
  set_number(in.command.reverse, stimulus.bits(1));
  set_number(in.command.brake_to_stop, stimulus.bits(1));
  set_number(in.command.clear_fault, stimulus.bits(1));
  set_number(in.config.bridge.period, stimulus.bits(14));
  set_number(in.config.bridge.minimum, stimulus.bits(14));
  set_number(in.config.bridge.dead_time, stimulus.bits(8));
  set_number(in.config.bridge.dead_time_loss, stimulus.bits(12));
  set_number(in.config.bridge.compensate, stimulus.bits(1));
  set_number(in.config.bridge.sine_pwm, stimulus.bits(1));
  set_number(in.config.bridge.reciprocal, stimulus.bits(15));
  set_number(in.config.estimator.voltage, stimulus.bits(1));
  set_number(in.config.estimator.average, stimulus.bits(1));
  set_number(in.config.estimator.decay, stimulus.bits(15));
  set_number(in.config.estimator.gain, stimulus.bits(15));
  set_number(in.config.estimator.k_theta, stimulus.bits(15));
  set_number(in.config.estimator.k_e, stimulus.bits(15));
  set_number(in.config.estimator.k_speed, stimulus.bits(15));
  set_number(in.config.estimator.k_emf, stimulus.bits(15));
  set_number(in.config.estimator.k_si, stimulus.bits(15));
  set_number(in.config.speed.target, stimulus.bits(25));
  set_number(in.config.speed.slew, stimulus.bits(15));
  set_number(in.config.speed.filter, stimulus.bits(15));
  set_number(in.config.speed.k_p, stimulus.bits(15));
  set_number(in.config.speed.k_i, stimulus.bits(15));
  set_number(in.config.speed.limit, stimulus.bits(15));
  set_number(in.config.speed.start_current, stimulus.bits(15));
  set_number(in.config.speed.lock, stimulus.bits(15));
  set_number(in.config.speed.slow, stimulus.bits(15));
  set_number(in.config.speed.stop, stimulus.bits(15));
  set_number(in.config.speed.emf_low, stimulus.bits(15));
  set_number(in.config.speed.emf_high, stimulus.bits(15));
  set_number(in.config.control.set_gamma, stimulus.bits(16));
  set_number(in.config.control.k_p, stimulus.bits(15));
  set_number(in.config.control.k_i, stimulus.bits(15));
  set_number(in.config.control.inductance, stimulus.bits(15));
  set_number(in.config.control.emf, stimulus.bits(15));
  set_number(in.config.control.limit, stimulus.bits(15));
  set_number(in.config.sequence.arbitrary, stimulus.bits(1));
  set_number(in.config.sequence.pilot, stimulus.bits(1));
  set_number(in.config.sequence.hold_voltage, stimulus.bits(15));
  set_number(in.config.sequence.pattern, stimulus.bits(20));
  set_number(in.config.sequence.lock, stimulus.bits(20));
  set_number(in.config.sequence.give_up, stimulus.bits(20));
  set_number(in.config.sequence.brake, stimulus.bits(20));
  set_number(in.config.sequence.retry_delay, stimulus.bits(20));
  set_number(in.config.sequence.retries, stimulus.bits(4));
  set_number(in.config.pilot.short_periods, stimulus.bits(6));
  set_number(in.config.pilot.long_periods, stimulus.bits(6));
  set_number(in.config.pilot.rounds, stimulus.bits(5));
  set_number(in.config.pilot.decayed, stimulus.bits(15));
  set_number(in.config.pilot.saliency, stimulus.bits(15));
  set_number(in.config.pilot.polarity, stimulus.bits(15));
  set_number(in.config.fault.over_current, stimulus.bits(15));
  set_number(in.config.fault.saturated, stimulus.bits(20));
  set_number(in.config.fault.slow, stimulus.bits(20));
  set_number(in.config.fault.emf, stimulus.bits(20));
  set_number(in.config.fault.lost_samples, stimulus.bits(4));
}

}  // namespace steplock::ports::sinusoidal_top
