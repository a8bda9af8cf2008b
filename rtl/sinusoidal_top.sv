// sinusoidal_top: steplock::SinusoidalTop, printed by hlsgen from hls/sinusoidal/sinusoidal_top.hpp:37.
// Do not edit: change the C++ and print again.

module sinusoidal_top (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        fault_i,  // asynchronous pin, active high
    input  logic        codes_valid_i,  // one clock: the codes are of a new sample
    input  logic [11:0] codes_u_i,  // s0.11, current of phase u
    input  logic [11:0] codes_v_i,  // s0.11, current of phase v
    input  logic [11:0] codes_dc_i,  // u0.12, dc voltage
    input  logic        command_configured_i,  // the words are valid; until then all six gates are off
    input  logic        command_run_i,
    input  logic        command_reverse_i,
    input  logic        command_brake_to_stop_i,  // else coast
    input  logic        command_clear_fault_i,  // a rising edge re-arms, once `run` is low and the cause is gone
    input  logic [13:0] words_bridge_period_i,  // clocks; 478 at least, a sample's
    input  logic [13:0] words_bridge_minimum_i,  // clocks; shorter on or off times become 0 % or 100 %
    input  logic [7:0]  words_bridge_dead_time_i,  // clocks; the guard's floor wins
    input  logic [11:0] words_bridge_lost_i,  // u8.4 clocks that a leg loses by it, with its diode's drop
    input  logic        words_bridge_compensate_i,  // the on-times make up for it
    input  logic        words_bridge_sine_i,  // no zero component
    input  logic [14:0] words_bridge_inverse_i,  // u0.25: 1 / (3 period)
    input  logic        words_estimator_voltage_i,  // the voltage model's estimate, else the current model's
    input  logic        words_estimator_average_i,  // voltage model: the mean of 8 samples
    input  logic [14:0] words_estimator_decay_i,  // u0.15, per sample
    input  logic [14:0] words_estimator_gain_i,  // u2.13, current per voltage
    input  logic [14:0] words_estimator_k_theta_i,  // u1.14, turns per current; K_SP L of the voltage model is the same
    input  logic [14:0] words_estimator_k_e_i,  // u2.13, voltage per current
    input  logic [14:0] words_estimator_k_speed_i,  // u-2.17, turns per voltage
    input  logic [14:0] words_estimator_k_emf_i,  // u0.15, turns per current
    input  logic [14:0] words_estimator_k_si_i,  // u-8.23, turns per current
    input  logic [24:0] words_speed_target_i,  // u0.25
    input  logic [14:0] words_speed_slew_i,  // u0.25, per sample
    input  logic [14:0] words_speed_filter_i,  // u0.15, per sample
    input  logic [14:0] words_speed_k_p_i,  // u7.8
    input  logic [14:0] words_speed_k_i_i,  // u-2.17, per sample
    input  logic [14:0] words_speed_limit_i,  // u0.15, of the current
    input  logic [14:0] words_speed_lock_i,  // u0.15: above, the estimate may be trusted
    input  logic [14:0] words_speed_slow_i,  // u0.15: below, it may not
    input  logic [14:0] words_speed_stop_i,  // u0.15: below, the drive lets go
    input  logic [14:0] words_speed_emf_low_i,  // u2.13
    input  logic [14:0] words_speed_emf_high_i,  // u2.13
    input  logic [15:0] words_control_set_gamma_i,  // s0.15
    input  logic [14:0] words_control_k_p_i,  // u3.12
    input  logic [14:0] words_control_k_i_i,  // u0.15, per sample
    input  logic [14:0] words_control_inductance_i,  // u5.10, voltage per current and speed
    input  logic [14:0] words_control_emf_i,  // u5.10, voltage per speed
    input  logic [14:0] words_control_limit_i,  // u0.15, of the dc voltage
    input  logic        words_sequence_arbitrary_i,  // no pattern before the loop is closed
    input  logic        words_sequence_pilot_i,  // pilot pulses instead of the pattern: a salient rotor
    input  logic [14:0] words_sequence_hold_voltage_i,  // u0.15, of the pattern's leg, or of a pilot pulse's
    input  logic [19:0] words_sequence_pattern_i,  // each of its two halves; all pilot pulses at most
    input  logic [19:0] words_sequence_lock_i,  // the estimate has to be trusted for so long
    input  logic [19:0] words_sequence_give_up_i,  // no lock in this time is a failed try
    input  logic [19:0] words_sequence_brake_i,
    input  logic [19:0] words_sequence_rest_i,
    input  logic [3:0]  words_sequence_retries_i,
    input  logic [5:0]  words_pilot_short_periods_i,  // 0 counts as 1
    input  logic [5:0]  words_pilot_long_periods_i,  // 0 counts as 1
    input  logic [4:0]  words_pilot_rounds_i,  // of six short pulses; even
    input  logic [14:0] words_pilot_decayed_i,  // u0.15: below, a current is gone
    input  logic [14:0] words_pilot_saliency_i,  // u0.15: a smaller sum is no position
    input  logic [14:0] words_pilot_polarity_i,  // u0.15: a smaller difference of the long peaks is no polarity
    input  logic [14:0] words_fault_over_current_i,  // u0.15, any phase
    input  logic [19:0] words_fault_saturated_i,  // a regulator at its limit for more than this; 0: no test
    input  logic [19:0] words_fault_slow_i,  // slow for more than this longer than not; 0: no test
    input  logic [19:0] words_fault_emf_i,  // an EMF that does not belong to the speed for more; 0: no test
    input  logic [3:0]  words_fault_lost_samples_i,  // in a row; 0: no test
    output logic        gates_uh_o,  // phase U, high side
    output logic        gates_ul_o,  // phase U, low side
    output logic        gates_vh_o,  // phase V, high side
    output logic        gates_vl_o,  // phase V, low side
    output logic        gates_wh_o,  // phase W, high side
    output logic        gates_wl_o,  // phase W, low side
    output logic [3:0]  state_o,
    output logic [3:0]  reason_o,
    output logic        sample_o,  // strobe: hold currents and dc voltage now
    output logic        locked_o,  // running, the estimate is claimed to be right
    output logic        estimating_o,  // the loop is closed
    output logic        done_o,  // strobe: a sample is worked through
    output logic        busy_o,  // one is under way: codes of the next clock are not taken
    output logic        reverse_o,  // the wanted direction
    output logic [3:0]  tries_o,  // that failed and were followed by another one, since `run` was obeyed
    output logic [23:0] angle_o,  // u0.24, electrical turns, at the last sample
    output logic [23:0] initial_o,  // u0.24, where the estimate begins: once found, by pilot pulses
    output logic [15:0] speed_o,  // s0.15 of 1/16 turn per sample, smoothed
    output logic [15:0] reference_o,  // the same, slewed, in the wanted direction
    output logic [15:0] i_gamma_o,  // s0.15
    output logic [15:0] i_delta_o,  // s0.15
    output logic [15:0] wanted_o,  // s0.15, i_delta*
    output logic [11:0] v_dc_o,  // u0.12, of the last sample
    output logic [13:0] on_u_o,  // clocks, of the next period
    output logic [13:0] on_v_o,
    output logic [13:0] on_w_o
);
  logic orders_reverse;  // the wanted direction
  logic orders_calibrate;
  logic orders_pilot;  // pulses are wanted
  logic orders_hold;  // one leg alone
  logic orders_hold_v;  // that is v
  logic orders_regulate;  // the loop is closed
  logic orders_estimate;  // the estimator has seen a whole period of it
  logic orders_slow_down;
  logic orders_locked;
  logic [13:0] running_on_u;  // clocks
  logic [13:0] running_on_v;  // clocks
  logic [13:0] running_on_w;  // clocks
  logic [13:0] ended_on_u;  // clocks
  logic [13:0] ended_on_v;  // clocks
  logic [13:0] ended_on_w;  // clocks
  logic seen_period;
  logic seen_taken;
  logic seen_sampled;
  logic seen_over;
  logic [15:0] seen_i_gamma;  // s0.15
  logic seen_backward;
  logic busy;  // a sample is under way
  logic restart;
  logic waiting;  // for the current to decay

  wire both_74 = codes_valid_i && !busy;  // line 74

  wire pilot_pulse;
  wire pilot_high_u;
  wire pilot_high_v;
  wire pilot_high_w;
  wire pilot_waiting;
  wire pilot_search;
  wire [15:0] pilot_a;
  wire [15:0] pilot_b;
  wire [23:0] pilot_angle;
  wire pilot_found;
  wire [3:0] pilot_failed;
  pilot_pulses pilot (
      .clk(clk),
      .rst(rst),
      .rest_i(orders_calibrate),
      .enable_i(orders_pilot),
      .period_i(seen_period),
      .taken_i(seen_taken),
      .sampled_i(seen_sampled),
      .over_i(seen_over),
      .i_gamma_i(seen_i_gamma),
      .backward_i(seen_backward),
      .words_short_periods_i(words_pilot_short_periods_i),
      .words_long_periods_i(words_pilot_long_periods_i),
      .words_rounds_i(words_pilot_rounds_i),
      .words_decayed_i(words_pilot_decayed_i),
      .words_saliency_i(words_pilot_saliency_i),
      .words_polarity_i(words_pilot_polarity_i),
      .pulse_o(pilot_pulse),
      .high_u_o(pilot_high_u),
      .high_v_o(pilot_high_v),
      .high_w_o(pilot_high_w),
      .waiting_o(pilot_waiting),
      .search_o(pilot_search),
      .a_o(pilot_a),
      .b_o(pilot_b),
      .angle_o(pilot_angle),
      .found_o(pilot_found),
      .failed_o(pilot_failed)
  );

  wire sense_taken;
  wire sense_measured;
  wire sense_over;
  wire [15:0] sense_i_u;
  wire [15:0] sense_i_v;
  wire [11:0] sense_v_dc;
  current_sense sense (
      .clk(clk),
      .rst(rst),
      .codes_valid_i(both_74),
      .codes_u_i(codes_u_i),
      .codes_v_i(codes_v_i),
      .codes_dc_i(codes_dc_i),
      .calibrate_i(orders_calibrate),
      .over_current_i(waiting ? words_pilot_decayed_i : words_fault_over_current_i),
      .taken_o(sense_taken),
      .measured_o(sense_measured),
      .over_o(sense_over),
      .i_u_o(sense_i_u),
      .i_v_o(sense_i_v),
      .v_dc_o(sense_v_dc)
  );

  wire [13:0] control_early_on_u;
  wire [13:0] control_early_on_v;
  wire [13:0] control_early_on_w;
  wire [23:0] control_angle;
  wire [15:0] control_i_gamma;
  wire [15:0] control_i_delta;
  wire control_limited;
  wire [15:0] control_speed_current;
  wire [15:0] control_speed_speed;
  wire [15:0] control_speed_reference;
  wire control_speed_saturated;
  wire control_speed_fast;
  wire control_speed_slow;
  wire control_speed_stopping;
  wire control_speed_plausible;
  wire control_done;
  wire unused_control_busy;
  wire unused_control_missed;
  sinusoidal_control control (
      .clk(clk),
      .rst(rst),
      .estimate_i(orders_estimate),
      .regulate_i(orders_regulate),
      .locked_i(orders_locked),
      .reverse_i(orders_reverse),
      .slow_down_i(orders_slow_down),
      .hold_i(orders_hold),
      .hold_v_i(orders_hold_v),
      .pilot_i(orders_pilot),
      .search_i(pilot_search),
      .a_i(pilot_a),
      .b_i(pilot_b),
      .initial_i(pilot_angle),
      .i_u_i(sense_i_u),
      .i_v_i(sense_i_v),
      .v_dc_i(sense_v_dc),
      .ended_on_u_i(ended_on_u),
      .ended_on_v_i(ended_on_v),
      .ended_on_w_i(ended_on_w),
      .bridge_period_i(words_bridge_period_i),
      .bridge_minimum_i(words_bridge_minimum_i),
      .bridge_dead_time_i(words_bridge_dead_time_i),
      .bridge_lost_i(words_bridge_lost_i),
      .bridge_compensate_i(words_bridge_compensate_i),
      .bridge_sine_i(words_bridge_sine_i),
      .bridge_inverse_i(words_bridge_inverse_i),
      .estimator_voltage_i(words_estimator_voltage_i),
      .estimator_average_i(words_estimator_average_i),
      .estimator_decay_i(words_estimator_decay_i),
      .estimator_gain_i(words_estimator_gain_i),
      .estimator_k_theta_i(words_estimator_k_theta_i),
      .estimator_k_e_i(words_estimator_k_e_i),
      .estimator_k_speed_i(words_estimator_k_speed_i),
      .estimator_k_emf_i(words_estimator_k_emf_i),
      .estimator_k_si_i(words_estimator_k_si_i),
      .speed_target_i(words_speed_target_i),
      .speed_slew_i(words_speed_slew_i),
      .speed_filter_i(words_speed_filter_i),
      .speed_k_p_i(words_speed_k_p_i),
      .speed_k_i_i(words_speed_k_i_i),
      .speed_limit_i(words_speed_limit_i),
      .speed_lock_i(words_speed_lock_i),
      .speed_slow_i(words_speed_slow_i),
      .speed_stop_i(words_speed_stop_i),
      .speed_emf_low_i(words_speed_emf_low_i),
      .speed_emf_high_i(words_speed_emf_high_i),
      .control_set_gamma_i(words_control_set_gamma_i),
      .control_k_p_i(words_control_k_p_i),
      .control_k_i_i(words_control_k_i_i),
      .control_inductance_i(words_control_inductance_i),
      .control_emf_i(words_control_emf_i),
      .control_limit_i(words_control_limit_i),
      .hold_voltage_i(words_sequence_hold_voltage_i),
      .start_i(sense_taken),
      .early_on_u_o(control_early_on_u),
      .early_on_v_o(control_early_on_v),
      .early_on_w_o(control_early_on_w),
      .angle_o(control_angle),
      .i_gamma_o(control_i_gamma),
      .i_delta_o(control_i_delta),
      .limited_o(control_limited),
      .speed_current_o(control_speed_current),
      .speed_speed_o(control_speed_speed),
      .speed_reference_o(control_speed_reference),
      .speed_saturated_o(control_speed_saturated),
      .speed_fast_o(control_speed_fast),
      .speed_slow_o(control_speed_slow),
      .speed_stopping_o(control_speed_stopping),
      .speed_plausible_o(control_speed_plausible),
      .done_o(control_done),
      .busy_o(unused_control_busy),
      .missed_o(unused_control_missed)
  );

  wire pwm_u_on;
  wire pwm_u_start;
  wire unused_pwm_u_tick;
  pwm_generator pwm_u (
      .clk(clk),
      .rst(rst),
      .on_clocks_i(control_early_on_u),
      .period_i(words_bridge_period_i),
      .minimum_i(words_bridge_minimum_i),
      .centred_i(1'b1),
      .tick_periods_i(8'd1),
      .on_o(pwm_u_on),
      .start_o(pwm_u_start),
      .tick_o(unused_pwm_u_tick)
  );

  wire unused_synchroniser_comparator_u;
  wire unused_synchroniser_comparator_v;
  wire unused_synchroniser_comparator_w;
  wire unused_synchroniser_limit;
  wire synchroniser_fault;
  wire unused_synchroniser_hall_u;
  wire unused_synchroniser_hall_v;
  wire unused_synchroniser_hall_w;
  synchroniser synchroniser (
      .clk(clk),
      .rst(rst),
      .comparator_u_i(1'b0),
      .comparator_v_i(1'b0),
      .comparator_w_i(1'b0),
      .limit_i(1'b0),
      .fault_i(fault_i),
      .hall_u_i(1'b0),
      .hall_v_i(1'b0),
      .hall_w_i(1'b0),
      .comparator_u_o(unused_synchroniser_comparator_u),
      .comparator_v_o(unused_synchroniser_comparator_v),
      .comparator_w_o(unused_synchroniser_comparator_w),
      .limit_o(unused_synchroniser_limit),
      .fault_o(synchroniser_fault),
      .hall_u_o(unused_synchroniser_hall_u),
      .hall_v_o(unused_synchroniser_hall_v),
      .hall_w_o(unused_synchroniser_hall_w)
  );

  wire [3:0] protection_fatal;
  wire [3:0] protection_failed;
  drive_protection protection (
      .clk(clk),
      .rst(rst),
      .restart_i(restart),
      .period_i(pwm_u_start && command_configured_i),
      .sampled_i(control_done),
      .over_current_i(sense_over && !waiting && command_configured_i),
      .regulating_i(orders_regulate),
      .saturated_i(control_limited || control_speed_saturated),
      .locked_i(orders_locked),
      .fast_i(control_speed_fast),
      .slow_i(control_speed_slow),
      .plausible_i(control_speed_plausible),
      .words_over_current_i(words_fault_over_current_i),
      .words_saturated_i(words_fault_saturated_i),
      .words_slow_i(words_fault_slow_i),
      .words_emf_i(words_fault_emf_i),
      .words_lost_samples_i(words_fault_lost_samples_i),
      .fatal_o(protection_fatal),
      .failed_o(protection_failed)
  );

  wire [3:0] sequence__state;
  wire [3:0] sequence__reason;
  wire sequence__entered;
  wire sequence__reverse;
  wire sequence__calibrate;
  wire sequence__pilot;
  wire sequence__hold;
  wire sequence__hold_v;
  wire sequence__regulate;
  wire sequence__estimate;
  wire sequence__modulate;
  wire sequence__brake;
  wire sequence__slow_down;
  wire sequence__locked;
  wire [3:0] sequence__tries;
  sinusoidal_sequence sequence_ (
      .clk(clk),
      .rst(rst),
      .command_configured_i(command_configured_i),
      .command_run_i(command_run_i),
      .command_reverse_i(command_reverse_i),
      .command_brake_to_stop_i(command_brake_to_stop_i),
      .command_clear_fault_i(command_clear_fault_i),
      .fault_pin_i(synchroniser_fault),
      .period_i(pwm_u_start),
      .sampled_i(control_done),
      .measured_i(sense_measured),
      .fast_i(control_speed_fast),
      .plausible_i(control_speed_plausible),
      .stopping_i(control_speed_stopping),
      .found_i(pilot_found),
      .fatal_i(protection_fatal),
      .failed_i(orders_pilot ? pilot_failed : protection_failed),
      .words_arbitrary_i(words_sequence_arbitrary_i),
      .words_pilot_i(words_sequence_pilot_i),
      .words_hold_voltage_i(words_sequence_hold_voltage_i),
      .words_pattern_i(words_sequence_pattern_i),
      .words_lock_i(words_sequence_lock_i),
      .words_give_up_i(words_sequence_give_up_i),
      .words_brake_i(words_sequence_brake_i),
      .words_rest_i(words_sequence_rest_i),
      .words_retries_i(words_sequence_retries_i),
      .state_o(sequence__state),
      .reason_o(sequence__reason),
      .entered_o(sequence__entered),
      .reverse_o(sequence__reverse),
      .calibrate_o(sequence__calibrate),
      .pilot_o(sequence__pilot),
      .hold_o(sequence__hold),
      .hold_v_o(sequence__hold_v),
      .regulate_o(sequence__regulate),
      .estimate_o(sequence__estimate),
      .modulate_o(sequence__modulate),
      .brake_o(sequence__brake),
      .slow_down_o(sequence__slow_down),
      .locked_o(sequence__locked),
      .tries_o(sequence__tries)
  );

  wire either_144 = sequence__modulate || (sequence__pilot && pilot_pulse);  // line 144
  wire choice_145 = sequence__pilot ? pilot_high_u && pwm_u_on : pwm_u_on;  // line 145

  wire pwm_v_on;
  wire unused_pwm_v_start;
  wire unused_pwm_v_tick;
  pwm_generator pwm_v (
      .clk(clk),
      .rst(rst),
      .on_clocks_i(control_early_on_v),
      .period_i(words_bridge_period_i),
      .minimum_i(words_bridge_minimum_i),
      .centred_i(1'b1),
      .tick_periods_i(8'd1),
      .on_o(pwm_v_on),
      .start_o(unused_pwm_v_start),
      .tick_o(unused_pwm_v_tick)
  );

  wire choice_146 = sequence__pilot ? pilot_high_v && pwm_u_on : pwm_v_on;  // line 146

  wire pwm_w_on;
  wire unused_pwm_w_start;
  wire unused_pwm_w_tick;
  pwm_generator pwm_w (
      .clk(clk),
      .rst(rst),
      .on_clocks_i(control_early_on_w),
      .period_i(words_bridge_period_i),
      .minimum_i(words_bridge_minimum_i),
      .centred_i(1'b1),
      .tick_periods_i(8'd1),
      .on_o(pwm_w_on),
      .start_o(unused_pwm_w_start),
      .tick_o(unused_pwm_w_tick)
  );

  wire choice_147 = sequence__pilot ? pilot_high_w && pwm_u_on : pwm_w_on;  // line 147

  wire guard_uh;
  wire guard_ul;
  wire guard_vh;
  wire guard_vl;
  wire guard_wh;
  wire guard_wl;
  gate_guard guard (
      .clk(clk),
      .rst(rst),
      .request_uh_i(either_144 && choice_145),
      .request_ul_i(sequence__brake || (either_144 && !choice_145)),
      .request_vh_i(either_144 && choice_146),
      .request_vl_i(sequence__brake || (either_144 && !choice_146)),
      .request_wh_i(either_144 && choice_147),
      .request_wl_i(sequence__brake || (either_144 && !choice_147)),
      .enable_i(command_configured_i),
      .fault_i(synchroniser_fault),
      .dead_time_i(words_bridge_dead_time_i),
      .minimum_i(8'd0),
      .uh_o(guard_uh),
      .ul_o(guard_ul),
      .vh_o(guard_vh),
      .vl_o(guard_vl),
      .wh_o(guard_wh),
      .wl_o(guard_wl)
  );

  wire busy_next = (busy || codes_valid_i) && !control_done;  // line 167

  always_ff @(posedge clk) begin
    if (both_74) begin
      orders_reverse <= sequence__reverse;
      orders_calibrate <= sequence__calibrate;
      orders_pilot <= sequence__pilot;
      orders_hold <= sequence__hold;
      orders_hold_v <= sequence__hold_v;
      orders_regulate <= sequence__regulate;
      orders_estimate <= sequence__estimate;
      orders_slow_down <= sequence__slow_down;
      orders_locked <= sequence__locked;
    end
    if (pwm_u_start) begin
      running_on_u <= control_early_on_u;
      running_on_v <= control_early_on_v;
      running_on_w <= control_early_on_w;
      ended_on_u <= running_on_u;
      ended_on_v <= running_on_v;
      ended_on_w <= running_on_w;
    end
    seen_period <= pwm_u_start;
    seen_taken <= sense_taken;
    seen_sampled <= control_done;
    seen_over <= sense_over;
    seen_i_gamma <= control_i_gamma;
    seen_backward <= control_i_delta[15];  // line 165
    busy <= busy_next;  // line 167
    restart <= sequence__entered;
    waiting <= pilot_waiting;
    if (rst) begin
      orders_reverse <= 1'b0;
      orders_calibrate <= 1'b0;
      orders_pilot <= 1'b0;
      orders_hold <= 1'b0;
      orders_hold_v <= 1'b0;
      orders_regulate <= 1'b0;
      orders_estimate <= 1'b0;
      orders_slow_down <= 1'b0;
      orders_locked <= 1'b0;
      running_on_u <= 14'd0;
      running_on_v <= 14'd0;
      running_on_w <= 14'd0;
      ended_on_u <= 14'd0;
      ended_on_v <= 14'd0;
      ended_on_w <= 14'd0;
      seen_period <= 1'b0;
      seen_taken <= 1'b0;
      seen_sampled <= 1'b0;
      seen_over <= 1'b0;
      seen_i_gamma <= 16'sd0;
      seen_backward <= 1'b0;
      busy <= 1'b0;
      restart <= 1'b0;
      waiting <= 1'b0;
    end
  end

  assign gates_uh_o = guard_uh;
  assign gates_ul_o = guard_ul;
  assign gates_vh_o = guard_vh;
  assign gates_vl_o = guard_vl;
  assign gates_wh_o = guard_wh;
  assign gates_wl_o = guard_wl;
  assign state_o = sequence__state;
  assign reason_o = sequence__reason;
  assign sample_o = pwm_u_start;
  assign locked_o = sequence__locked;
  assign estimating_o = sequence__regulate;
  assign done_o = control_done;
  assign busy_o = busy_next;
  assign reverse_o = sequence__reverse;
  assign tries_o = sequence__tries;
  assign angle_o = control_angle;
  assign initial_o = pilot_angle;
  assign speed_o = control_speed_speed;
  assign reference_o = control_speed_reference;
  assign i_gamma_o = control_i_gamma;
  assign i_delta_o = control_i_delta;
  assign wanted_o = control_speed_current;
  assign v_dc_o = sense_v_dc;
  assign on_u_o = control_early_on_u;
  assign on_v_o = control_early_on_v;
  assign on_w_o = control_early_on_w;
endmodule
