// Ports of module six_step_top, from hls/six_step/six_step_top.hpp.
// Printed by hlsgen; do not edit.

#pragma once

#include "generator/port_words.hpp"

namespace steplock::ports::six_step_top {

template <class Rtl, class In>
void drive_ports([[maybe_unused]] Rtl& rtl, [[maybe_unused]] const In& in) {
  set_port(rtl.pins_comparator_u_i, word_of(in.pins.comparator_u, 1));
  set_port(rtl.pins_comparator_v_i, word_of(in.pins.comparator_v, 1));
  set_port(rtl.pins_comparator_w_i, word_of(in.pins.comparator_w, 1));
  set_port(rtl.pins_limit_i, word_of(in.pins.limit, 1));
  set_port(rtl.pins_fault_i, word_of(in.pins.fault, 1));
  set_port(rtl.pins_hall_u_i, word_of(in.pins.hall_u, 1));
  set_port(rtl.pins_hall_v_i, word_of(in.pins.hall_v, 1));
  set_port(rtl.pins_hall_w_i, word_of(in.pins.hall_w, 1));
  set_port(rtl.command_configured_i, word_of(in.command.configured, 1));
  set_port(rtl.command_run_i, word_of(in.command.run, 1));
  set_port(rtl.command_reverse_i, word_of(in.command.reverse, 1));
  set_port(rtl.command_brake_to_stop_i, word_of(in.command.brake_to_stop, 1));
  set_port(rtl.command_clear_fault_i, word_of(in.command.clear_fault, 1));
  set_port(rtl.config_pwm_period_i, word_of(in.config.pwm.period, 14));
  set_port(rtl.config_pwm_minimum_i, word_of(in.config.pwm.minimum, 14));
  set_port(rtl.config_pwm_centred_i, word_of(in.config.pwm.centred, 1));
  set_port(rtl.config_pwm_complementary_i, word_of(in.config.pwm.complementary, 1));
  set_port(rtl.config_pwm_dead_time_i, word_of(in.config.pwm.dead_time, 8));
  set_port(rtl.config_pwm_tick_periods_i, word_of(in.config.pwm.tick_periods, 8));
  set_port(rtl.config_limit_blanking_i, word_of(in.config.limit.blanking, 8));
  set_port(rtl.config_limit_off_time_i, word_of(in.config.limit.off_time, 12));
  set_port(rtl.config_bemf_sampling_i, word_of(in.config.bemf.sampling, 2));
  set_port(rtl.config_bemf_blanking_i, word_of(in.config.bemf.blanking, 10));
  set_port(rtl.config_bemf_sample_every_i, word_of(in.config.bemf.sample_every, 8));
  set_port(rtl.config_bemf_samples_i, word_of(in.config.bemf.samples, 4));
  set_port(rtl.config_loop_detector_i, word_of(in.config.loop.detector, 1));
  set_port(rtl.config_loop_bandwidth_i, word_of(in.config.loop.bandwidth, 1));
  set_port(rtl.config_loop_divide_i, word_of(in.config.loop.divide, 2));
  set_port(rtl.config_loop_expected_i, word_of(in.config.loop.expected, 16));
  set_port(rtl.config_loop_lead_error_i, word_of(in.config.loop.lead_error, 16));
  set_port(rtl.config_loop_delay_i, word_of(in.config.loop.delay, 10));
  set_port(rtl.config_loop_ki_i, word_of(in.config.loop.ki, 16));
  set_port(rtl.config_loop_kp_i, word_of(in.config.loop.kp, 16));
  set_port(rtl.config_loop_alpha_i, word_of(in.config.loop.alpha, 16));
  set_port(rtl.config_loop_scale_i, word_of(in.config.loop.scale, 26));
  set_port(rtl.config_loop_minimum_i, word_of(in.config.loop.minimum, 26));
  set_port(rtl.config_loop_maximum_i, word_of(in.config.loop.maximum, 26));
  set_port(rtl.config_start_method_i, word_of(in.config.start.method, 1));
  set_port(rtl.config_start_pre_align_i, word_of(in.config.start.pre_align, 12));
  set_port(rtl.config_start_align_i, word_of(in.config.start.align, 12));
  set_port(rtl.config_start_align_duty_i, word_of(in.config.start.align_duty, 16));
  set_port(rtl.config_start_start_duty_i, word_of(in.config.start.start_duty, 16));
  set_port(rtl.config_start_ramp_i, word_of(in.config.start.ramp, 20));
  set_port(rtl.config_start_look_i, word_of(in.config.start.look, 16));
  set_port(rtl.config_start_probe_i, word_of(in.config.start.probe, 16));
  set_port(rtl.config_start_still_i, word_of(in.config.start.still, 8));
  set_port(rtl.config_start_hand_over_i, word_of(in.config.start.hand_over, 26));
  set_port(rtl.config_start_window_i, word_of(in.config.start.window, 16));
  set_port(rtl.config_start_good_crossings_i, word_of(in.config.start.good_crossings, 6));
  set_port(rtl.config_start_pull_in_i, word_of(in.config.start.pull_in, 12));
  set_port(rtl.config_start_detect_spin_i, word_of(in.config.start.detect_spin, 12));
  set_port(rtl.config_start_slow_down_i, word_of(in.config.start.slow_down, 12));
  set_port(rtl.config_start_brake_i, word_of(in.config.start.brake, 12));
  set_port(rtl.config_start_brake_duty_i, word_of(in.config.start.brake_duty, 16));
  set_port(rtl.config_start_retry_delay_i, word_of(in.config.start.retry_delay, 12));
  set_port(rtl.config_start_retries_i, word_of(in.config.start.retries, 4));
  set_port(rtl.config_speed_target_i, word_of(in.config.speed.target, 26));
  set_port(rtl.config_speed_slew_i, word_of(in.config.speed.slew, 20));
  set_port(rtl.config_speed_shift_i, word_of(in.config.speed.shift, 4));
  set_port(rtl.config_speed_kp_i, word_of(in.config.speed.kp, 16));
  set_port(rtl.config_speed_ki_i, word_of(in.config.speed.ki, 16));
  set_port(rtl.config_speed_bemf_i, word_of(in.config.speed.bemf, 16));
  set_port(rtl.config_speed_loaded_i, word_of(in.config.speed.loaded, 16));
  set_port(rtl.config_speed_minimum_i, word_of(in.config.speed.minimum, 16));
  set_port(rtl.config_speed_maximum_i, word_of(in.config.speed.maximum, 16));
  set_port(rtl.config_speed_duty_slew_i, word_of(in.config.speed.duty_slew, 12));
  set_port(rtl.config_protection_misses_i, word_of(in.config.protection.misses, 6));
  set_port(rtl.config_protection_stall_i, word_of(in.config.protection.stall, 26));
  set_port(rtl.config_protection_slip_i, word_of(in.config.protection.slip, 16));
  set_port(rtl.config_protection_freewheel_i, word_of(in.config.protection.freewheel, 16));
  set_port(rtl.config_protection_wrong_lock_i, word_of(in.config.protection.wrong_lock, 12));
  set_port(rtl.config_protection_over_current_i, word_of(in.config.protection.over_current, 4));
  set_port(rtl.config_source_i, word_of(in.config.source, 1));
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
  if (word_at(rtl.locked_o) != word_of(out.locked, 1)) return "locked_o";
  if (word_at(rtl.reverse_o) != word_of(out.reverse, 1)) return "reverse_o";
  if (word_at(rtl.step_o) != word_of(out.step, 3)) return "step_o";
  if (word_at(rtl.chop_o) != word_of(out.chop, 1)) return "chop_o";
  if (word_at(rtl.commutate_o) != word_of(out.commutate, 1)) return "commutate_o";
  if (word_at(rtl.turn_o) != word_of(out.turn, 1)) return "turn_o";
  if (word_at(rtl.frequency_o) != word_of(out.frequency, 26)) return "frequency_o";
  if (word_at(rtl.step_phase_o) != word_of(out.step_phase, 16)) return "step_phase_o";
  if (word_at(rtl.phase_error_o) != word_of(out.phase_error, 16)) return "phase_error_o";
  if (word_at(rtl.update_o) != word_of(out.update, 1)) return "update_o";
  if (word_at(rtl.crossing_o) != word_of(out.crossing, 1)) return "crossing_o";
  if (word_at(rtl.missed_o) != word_of(out.missed, 1)) return "missed_o";
  if (word_at(rtl.crossing_phase_o) != word_of(out.crossing_phase, 16)) return "crossing_phase_o";
  if (word_at(rtl.freewheel_o) != word_of(out.freewheel, 16)) return "freewheel_o";
  if (word_at(rtl.duty_o) != word_of(out.duty, 16)) return "duty_o";
  if (word_at(rtl.counts_crossings_o) != word_of(out.counts.crossings, 16)) return "counts_crossings_o";
  if (word_at(rtl.counts_missed_o) != word_of(out.counts.missed, 16)) return "counts_missed_o";
  if (word_at(rtl.counts_freewheel_long_o) != word_of(out.counts.freewheel_long, 16)) return "counts_freewheel_long_o";
  if (word_at(rtl.counts_limit_hits_o) != word_of(out.counts.limit_hits, 16)) return "counts_limit_hits_o";
  if (word_at(rtl.counts_retries_o) != word_of(out.counts.retries, 16)) return "counts_retries_o";
  return nullptr;
}

// Stimulus::bits(width) gives a number of so many bits.
template <class In, class Stimulus>
void randomise([[maybe_unused]] In& in, [[maybe_unused]] Stimulus& stimulus) {
  set_number(in.pins.comparator_u, stimulus.bits(1));
  set_number(in.pins.comparator_v, stimulus.bits(1));
  set_number(in.pins.comparator_w, stimulus.bits(1));
  set_number(in.pins.limit, stimulus.bits(1));
  set_number(in.pins.fault, stimulus.bits(1));
  set_number(in.pins.hall_u, stimulus.bits(1));
  set_number(in.pins.hall_v, stimulus.bits(1));
  set_number(in.pins.hall_w, stimulus.bits(1));
  set_number(in.command.configured, stimulus.bits(1));
  set_number(in.command.run, stimulus.bits(1));
  set_number(in.command.reverse, stimulus.bits(1));
  set_number(in.command.brake_to_stop, stimulus.bits(1));
  set_number(in.command.clear_fault, stimulus.bits(1));
  set_number(in.config.pwm.period, stimulus.bits(14));
  set_number(in.config.pwm.minimum, stimulus.bits(14));
  set_number(in.config.pwm.centred, stimulus.bits(1));
  set_number(in.config.pwm.complementary, stimulus.bits(1));
  set_number(in.config.pwm.dead_time, stimulus.bits(8));
  set_number(in.config.pwm.tick_periods, stimulus.bits(8));
  set_number(in.config.limit.blanking, stimulus.bits(8));
  set_number(in.config.limit.off_time, stimulus.bits(12));
  {
    constexpr unsigned long long values[] = {0, 1, 2};
    set_number(in.config.bemf.sampling, values[stimulus.bits(2) % 3]);
  }
  set_number(in.config.bemf.blanking, stimulus.bits(10));
  set_number(in.config.bemf.sample_every, stimulus.bits(8));
  set_number(in.config.bemf.samples, stimulus.bits(4));
  {
    constexpr unsigned long long values[] = {0, 1};
    set_number(in.config.loop.detector, values[stimulus.bits(1) % 2]);
  }
  {
    constexpr unsigned long long values[] = {0, 1};
    set_number(in.config.loop.bandwidth, values[stimulus.bits(1) % 2]);
  }
  set_number(in.config.loop.divide, stimulus.bits(2));
  set_number(in.config.loop.expected, stimulus.bits(16));
  set_number(in.config.loop.lead_error, stimulus.bits(16));
  set_number(in.config.loop.delay, stimulus.bits(10));
  set_number(in.config.loop.ki, stimulus.bits(16));
  set_number(in.config.loop.kp, stimulus.bits(16));
  set_number(in.config.loop.alpha, stimulus.bits(16));
  set_number(in.config.loop.scale, stimulus.bits(26));
  set_number(in.config.loop.minimum, stimulus.bits(26));
  set_number(in.config.loop.maximum, stimulus.bits(26));
  {
    constexpr unsigned long long values[] = {0, 1};
    set_number(in.config.start.method, values[stimulus.bits(1) % 2]);
  }
  set_number(in.config.start.pre_align, stimulus.bits(12));
  set_number(in.config.start.align, stimulus.bits(12));
  set_number(in.config.start.align_duty, stimulus.bits(16));
  set_number(in.config.start.start_duty, stimulus.bits(16));
  set_number(in.config.start.ramp, stimulus.bits(20));
  set_number(in.config.start.look, stimulus.bits(16));
  set_number(in.config.start.probe, stimulus.bits(16));
  set_number(in.config.start.still, stimulus.bits(8));
  set_number(in.config.start.hand_over, stimulus.bits(26));
  set_number(in.config.start.window, stimulus.bits(16));
  set_number(in.config.start.good_crossings, stimulus.bits(6));
  set_number(in.config.start.pull_in, stimulus.bits(12));
  set_number(in.config.start.detect_spin, stimulus.bits(12));
  set_number(in.config.start.slow_down, stimulus.bits(12));
  set_number(in.config.start.brake, stimulus.bits(12));
  set_number(in.config.start.brake_duty, stimulus.bits(16));
  set_number(in.config.start.retry_delay, stimulus.bits(12));
  set_number(in.config.start.retries, stimulus.bits(4));
  set_number(in.config.speed.target, stimulus.bits(26));
  set_number(in.config.speed.slew, stimulus.bits(20));
  set_number(in.config.speed.shift, stimulus.bits(4));
  set_number(in.config.speed.kp, stimulus.bits(16));
  set_number(in.config.speed.ki, stimulus.bits(16));
  set_number(in.config.speed.bemf, stimulus.bits(16));
  set_number(in.config.speed.loaded, stimulus.bits(16));
  set_number(in.config.speed.minimum, stimulus.bits(16));
  set_number(in.config.speed.maximum, stimulus.bits(16));
  set_number(in.config.speed.duty_slew, stimulus.bits(12));
  set_number(in.config.protection.misses, stimulus.bits(6));
  set_number(in.config.protection.stall, stimulus.bits(26));
  set_number(in.config.protection.slip, stimulus.bits(16));
  set_number(in.config.protection.freewheel, stimulus.bits(16));
  set_number(in.config.protection.wrong_lock, stimulus.bits(12));
  set_number(in.config.protection.over_current, stimulus.bits(4));
  {
    constexpr unsigned long long values[] = {0, 1};
    set_number(in.config.source, values[stimulus.bits(1) % 2]);
  }
}

}  // namespace steplock::ports::six_step_top
