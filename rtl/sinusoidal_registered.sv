// sinusoidal_registered: steplock::SinusoidalRegistered, printed by hlsgen from hls/bus/sinusoidal_registered.hpp:27.
// Do not edit: change the C++ and print again.

module sinusoidal_registered (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        fault_i,  // asynchronous pin, active high
    input  logic        codes_valid_i,  // one clock: the codes are of a new sample
    input  logic [11:0] codes_u_i,  // s0.11, current of phase u
    input  logic [11:0] codes_v_i,  // s0.11, current of phase v
    input  logic [11:0] codes_dc_i,  // u0.12, dc voltage
    input  logic        request_write_i,
    input  logic        request_read_i,
    input  logic [9:0]  request_index_i,
    input  logic [31:0] request_data_i,
    input  logic [3:0]  request_strobes_i,  // bytes of `data` that count
    output logic        gates_uh_o,  // phase U, high side
    output logic        gates_ul_o,  // phase U, low side
    output logic        gates_vh_o,  // phase V, high side
    output logic        gates_vl_o,  // phase V, low side
    output logic        gates_wh_o,  // phase W, high side
    output logic        gates_wl_o,  // phase W, low side
    output logic        sample_o,  // strobe: hold currents and dc voltage now
    output logic        interrupt_o,  // level
    output logic        locked_o,  // running, the estimate is claimed to be right
    output logic        fault_o,  // the drive's fault is latched
    output logic [31:0] data_o,  // of the last read
    output logic        read_error_o,  // it was of a hole
    output logic        write_error_o  // the last write was refused
);
  logic command_configured;  // the words are valid; until then all six gates are off
  logic command_run;
  logic command_reverse;
  logic command_brake_to_stop;  // else coast
  logic command_clear_fault;  // a rising edge re-arms, once `run` is low and the cause is gone
  logic stopped;
  logic busy;  // a sample is under way, as the drive says
  logic [3:0] periods;  // begun, of a tick

  wire [13:0] words_words_bridge_period;
  wire [13:0] words_words_bridge_minimum;
  wire [7:0] words_words_bridge_dead_time;
  wire [11:0] words_words_bridge_lost;
  wire words_words_bridge_compensate;
  wire words_words_bridge_sine;
  wire [14:0] words_words_bridge_inverse;
  wire words_words_estimator_voltage;
  wire words_words_estimator_average;
  wire [14:0] words_words_estimator_decay;
  wire [14:0] words_words_estimator_gain;
  wire [14:0] words_words_estimator_k_theta;
  wire [14:0] words_words_estimator_k_e;
  wire [14:0] words_words_estimator_k_speed;
  wire [14:0] words_words_estimator_k_emf;
  wire [14:0] words_words_estimator_k_si;
  wire [24:0] words_words_speed_target;
  wire [14:0] words_words_speed_slew;
  wire [14:0] words_words_speed_filter;
  wire [14:0] words_words_speed_k_p;
  wire [14:0] words_words_speed_k_i;
  wire [14:0] words_words_speed_limit;
  wire [14:0] words_words_speed_lock;
  wire [14:0] words_words_speed_slow;
  wire [14:0] words_words_speed_stop;
  wire [14:0] words_words_speed_emf_low;
  wire [14:0] words_words_speed_emf_high;
  wire [15:0] words_words_control_set_gamma;
  wire [14:0] words_words_control_k_p;
  wire [14:0] words_words_control_k_i;
  wire [14:0] words_words_control_inductance;
  wire [14:0] words_words_control_emf;
  wire [14:0] words_words_control_limit;
  wire words_words_sequence_arbitrary;
  wire words_words_sequence_pilot;
  wire [14:0] words_words_sequence_hold_voltage;
  wire [19:0] words_words_sequence_pattern;
  wire [19:0] words_words_sequence_lock;
  wire [19:0] words_words_sequence_give_up;
  wire [19:0] words_words_sequence_brake;
  wire [19:0] words_words_sequence_rest;
  wire [3:0] words_words_sequence_retries;
  wire [5:0] words_words_pilot_short_periods;
  wire [5:0] words_words_pilot_long_periods;
  wire [4:0] words_words_pilot_rounds;
  wire [14:0] words_words_pilot_decayed;
  wire [14:0] words_words_pilot_saliency;
  wire [14:0] words_words_pilot_polarity;
  wire [14:0] words_words_fault_over_current;
  wire [19:0] words_words_fault_saturated;
  wire [19:0] words_words_fault_slow;
  wire [19:0] words_words_fault_emf;
  wire [3:0] words_words_fault_lost_samples;
  wire [31:0] words_data;
  wire words_hole;
  wire words_refused;
  wire words_unlocked;
  wire words_no_period;
  word_registers_sinusoidal words (
      .clk(clk),
      .rst(rst),
      .request_write_i(request_write_i),
      .request_read_i(request_read_i),
      .request_index_i(request_index_i),
      .request_data_i(request_data_i),
      .request_strobes_i(request_strobes_i),
      .stopped_i(stopped),
      .boundary_i(codes_valid_i && !busy),
      .words_bridge_period_o(words_words_bridge_period),
      .words_bridge_minimum_o(words_words_bridge_minimum),
      .words_bridge_dead_time_o(words_words_bridge_dead_time),
      .words_bridge_lost_o(words_words_bridge_lost),
      .words_bridge_compensate_o(words_words_bridge_compensate),
      .words_bridge_sine_o(words_words_bridge_sine),
      .words_bridge_inverse_o(words_words_bridge_inverse),
      .words_estimator_voltage_o(words_words_estimator_voltage),
      .words_estimator_average_o(words_words_estimator_average),
      .words_estimator_decay_o(words_words_estimator_decay),
      .words_estimator_gain_o(words_words_estimator_gain),
      .words_estimator_k_theta_o(words_words_estimator_k_theta),
      .words_estimator_k_e_o(words_words_estimator_k_e),
      .words_estimator_k_speed_o(words_words_estimator_k_speed),
      .words_estimator_k_emf_o(words_words_estimator_k_emf),
      .words_estimator_k_si_o(words_words_estimator_k_si),
      .words_speed_target_o(words_words_speed_target),
      .words_speed_slew_o(words_words_speed_slew),
      .words_speed_filter_o(words_words_speed_filter),
      .words_speed_k_p_o(words_words_speed_k_p),
      .words_speed_k_i_o(words_words_speed_k_i),
      .words_speed_limit_o(words_words_speed_limit),
      .words_speed_lock_o(words_words_speed_lock),
      .words_speed_slow_o(words_words_speed_slow),
      .words_speed_stop_o(words_words_speed_stop),
      .words_speed_emf_low_o(words_words_speed_emf_low),
      .words_speed_emf_high_o(words_words_speed_emf_high),
      .words_control_set_gamma_o(words_words_control_set_gamma),
      .words_control_k_p_o(words_words_control_k_p),
      .words_control_k_i_o(words_words_control_k_i),
      .words_control_inductance_o(words_words_control_inductance),
      .words_control_emf_o(words_words_control_emf),
      .words_control_limit_o(words_words_control_limit),
      .words_sequence_arbitrary_o(words_words_sequence_arbitrary),
      .words_sequence_pilot_o(words_words_sequence_pilot),
      .words_sequence_hold_voltage_o(words_words_sequence_hold_voltage),
      .words_sequence_pattern_o(words_words_sequence_pattern),
      .words_sequence_lock_o(words_words_sequence_lock),
      .words_sequence_give_up_o(words_words_sequence_give_up),
      .words_sequence_brake_o(words_words_sequence_brake),
      .words_sequence_rest_o(words_words_sequence_rest),
      .words_sequence_retries_o(words_words_sequence_retries),
      .words_pilot_short_periods_o(words_words_pilot_short_periods),
      .words_pilot_long_periods_o(words_words_pilot_long_periods),
      .words_pilot_rounds_o(words_words_pilot_rounds),
      .words_pilot_decayed_o(words_words_pilot_decayed),
      .words_pilot_saliency_o(words_words_pilot_saliency),
      .words_pilot_polarity_o(words_words_pilot_polarity),
      .words_fault_over_current_o(words_words_fault_over_current),
      .words_fault_saturated_o(words_words_fault_saturated),
      .words_fault_slow_o(words_words_fault_slow),
      .words_fault_emf_o(words_words_fault_emf),
      .words_fault_lost_samples_o(words_words_fault_lost_samples),
      .data_o(words_data),
      .hole_o(words_hole),
      .refused_o(words_refused),
      .unlocked_o(words_unlocked),
      .no_period_o(words_no_period)
  );

  wire drive_gates_uh;
  wire drive_gates_ul;
  wire drive_gates_vh;
  wire drive_gates_vl;
  wire drive_gates_wh;
  wire drive_gates_wl;
  wire [3:0] drive_state;
  wire [3:0] drive_reason;
  wire drive_sample;
  wire drive_locked;
  wire unused_drive_estimating;
  wire unused_drive_done;
  wire drive_busy;
  wire drive_reverse;
  wire [3:0] drive_tries;
  wire [23:0] drive_angle;
  wire [23:0] unused_drive_initial;
  wire [15:0] drive_speed;
  wire [15:0] drive_reference;
  wire [15:0] drive_i_gamma;
  wire [15:0] drive_i_delta;
  wire [15:0] unused_drive_wanted;
  wire [11:0] drive_v_dc;
  wire [13:0] drive_on_u;
  wire [13:0] drive_on_v;
  wire [13:0] drive_on_w;
  sinusoidal_top drive (
      .clk(clk),
      .rst(rst),
      .fault_i(fault_i),
      .codes_valid_i(codes_valid_i),
      .codes_u_i(codes_u_i),
      .codes_v_i(codes_v_i),
      .codes_dc_i(codes_dc_i),
      .command_configured_i(command_configured),
      .command_run_i(command_run),
      .command_reverse_i(command_reverse),
      .command_brake_to_stop_i(command_brake_to_stop),
      .command_clear_fault_i(command_clear_fault),
      .words_bridge_period_i(words_words_bridge_period),
      .words_bridge_minimum_i(words_words_bridge_minimum),
      .words_bridge_dead_time_i(words_words_bridge_dead_time),
      .words_bridge_lost_i(words_words_bridge_lost),
      .words_bridge_compensate_i(words_words_bridge_compensate),
      .words_bridge_sine_i(words_words_bridge_sine),
      .words_bridge_inverse_i(words_words_bridge_inverse),
      .words_estimator_voltage_i(words_words_estimator_voltage),
      .words_estimator_average_i(words_words_estimator_average),
      .words_estimator_decay_i(words_words_estimator_decay),
      .words_estimator_gain_i(words_words_estimator_gain),
      .words_estimator_k_theta_i(words_words_estimator_k_theta),
      .words_estimator_k_e_i(words_words_estimator_k_e),
      .words_estimator_k_speed_i(words_words_estimator_k_speed),
      .words_estimator_k_emf_i(words_words_estimator_k_emf),
      .words_estimator_k_si_i(words_words_estimator_k_si),
      .words_speed_target_i(words_words_speed_target),
      .words_speed_slew_i(words_words_speed_slew),
      .words_speed_filter_i(words_words_speed_filter),
      .words_speed_k_p_i(words_words_speed_k_p),
      .words_speed_k_i_i(words_words_speed_k_i),
      .words_speed_limit_i(words_words_speed_limit),
      .words_speed_lock_i(words_words_speed_lock),
      .words_speed_slow_i(words_words_speed_slow),
      .words_speed_stop_i(words_words_speed_stop),
      .words_speed_emf_low_i(words_words_speed_emf_low),
      .words_speed_emf_high_i(words_words_speed_emf_high),
      .words_control_set_gamma_i(words_words_control_set_gamma),
      .words_control_k_p_i(words_words_control_k_p),
      .words_control_k_i_i(words_words_control_k_i),
      .words_control_inductance_i(words_words_control_inductance),
      .words_control_emf_i(words_words_control_emf),
      .words_control_limit_i(words_words_control_limit),
      .words_sequence_arbitrary_i(words_words_sequence_arbitrary),
      .words_sequence_pilot_i(words_words_sequence_pilot),
      .words_sequence_hold_voltage_i(words_words_sequence_hold_voltage),
      .words_sequence_pattern_i(words_words_sequence_pattern),
      .words_sequence_lock_i(words_words_sequence_lock),
      .words_sequence_give_up_i(words_words_sequence_give_up),
      .words_sequence_brake_i(words_words_sequence_brake),
      .words_sequence_rest_i(words_words_sequence_rest),
      .words_sequence_retries_i(words_words_sequence_retries),
      .words_pilot_short_periods_i(words_words_pilot_short_periods),
      .words_pilot_long_periods_i(words_words_pilot_long_periods),
      .words_pilot_rounds_i(words_words_pilot_rounds),
      .words_pilot_decayed_i(words_words_pilot_decayed),
      .words_pilot_saliency_i(words_words_pilot_saliency),
      .words_pilot_polarity_i(words_words_pilot_polarity),
      .words_fault_over_current_i(words_words_fault_over_current),
      .words_fault_saturated_i(words_words_fault_saturated),
      .words_fault_slow_i(words_words_fault_slow),
      .words_fault_emf_i(words_words_fault_emf),
      .words_fault_lost_samples_i(words_words_fault_lost_samples),
      .gates_uh_o(drive_gates_uh),
      .gates_ul_o(drive_gates_ul),
      .gates_vh_o(drive_gates_vh),
      .gates_vl_o(drive_gates_vl),
      .gates_wh_o(drive_gates_wh),
      .gates_wl_o(drive_gates_wl),
      .state_o(drive_state),
      .reason_o(drive_reason),
      .sample_o(drive_sample),
      .locked_o(drive_locked),
      .estimating_o(unused_drive_estimating),
      .done_o(unused_drive_done),
      .busy_o(drive_busy),
      .reverse_o(drive_reverse),
      .tries_o(drive_tries),
      .angle_o(drive_angle),
      .initial_o(unused_drive_initial),
      .speed_o(drive_speed),
      .reference_o(drive_reference),
      .i_gamma_o(drive_i_gamma),
      .i_delta_o(drive_i_delta),
      .wanted_o(unused_drive_wanted),
      .v_dc_o(drive_v_dc),
      .on_u_o(drive_on_u),
      .on_v_o(drive_on_v),
      .on_w_o(drive_on_w)
  );

  wire registers_command_configured;
  wire registers_command_run;
  wire registers_command_reverse;
  wire registers_command_brake_to_stop;
  wire registers_command_clear_fault;
  wire registers_stopped;
  wire [31:0] registers_data;
  wire registers_read_error;
  wire registers_write_error;
  wire registers_interrupt;
  drive_registers_sinusoidal registers (
      .clk(clk),
      .rst(rst),
      .request_write_i(request_write_i),
      .request_read_i(request_read_i),
      .request_index_i(request_index_i),
      .request_data_i(request_data_i),
      .request_strobes_i(request_strobes_i),
      .word_i(words_data),
      .hole_i(words_hole),
      .refused_i(words_refused),
      .unlocked_i(words_unlocked),
      .no_period_i(words_no_period),
      .tick_i(drive_sample && periods == 4'd0),
      .drive_state_i(drive_state),
      .drive_reason_i(drive_reason),
      .drive_locked_i(drive_locked),
      .drive_reverse_i(drive_reverse),
      .drive_speed_i(drive_speed),
      .drive_reference_i(drive_reference),
      .drive_i_gamma_i(drive_i_gamma),
      .drive_i_delta_i(drive_i_delta),
      .drive_angle_i(drive_angle[23:8]),
      .drive_v_dc_i(drive_v_dc),
      .drive_on_u_i(drive_on_u),
      .drive_on_v_i(drive_on_v),
      .drive_on_w_i(drive_on_w),
      .drive_retries_i(drive_tries),
      .command_configured_o(registers_command_configured),
      .command_run_o(registers_command_run),
      .command_reverse_o(registers_command_reverse),
      .command_brake_to_stop_o(registers_command_brake_to_stop),
      .command_clear_fault_o(registers_command_clear_fault),
      .stopped_o(registers_stopped),
      .data_o(registers_data),
      .read_error_o(registers_read_error),
      .write_error_o(registers_write_error),
      .interrupt_o(registers_interrupt)
  );

  always_ff @(posedge clk) begin
    command_configured <= registers_command_configured;
    command_run <= registers_command_run;
    command_reverse <= registers_command_reverse;
    command_brake_to_stop <= registers_command_brake_to_stop;
    command_clear_fault <= registers_command_clear_fault;
    stopped <= registers_stopped && !(command_run || registers_command_run);  // line 76
    busy <= drive_busy;
    if (drive_sample) begin
      periods <= periods + 4'd1;
    end
    if (rst) begin
      command_configured <= 1'b0;
      command_run <= 1'b0;
      command_reverse <= 1'b0;
      command_brake_to_stop <= 1'b0;
      command_clear_fault <= 1'b0;
      stopped <= 1'b1;
      busy <= 1'b0;
      periods <= 4'd0;
    end
  end

  assign gates_uh_o = drive_gates_uh;
  assign gates_ul_o = drive_gates_ul;
  assign gates_vh_o = drive_gates_vh;
  assign gates_vl_o = drive_gates_vl;
  assign gates_wh_o = drive_gates_wh;
  assign gates_wl_o = drive_gates_wl;
  assign sample_o = drive_sample;
  assign interrupt_o = registers_interrupt;
  assign locked_o = drive_locked;
  assign fault_o = drive_state == 4'd9;
  assign data_o = registers_data;
  assign read_error_o = registers_read_error;
  assign write_error_o = registers_write_error;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, drive_angle[7:0]};
endmodule
