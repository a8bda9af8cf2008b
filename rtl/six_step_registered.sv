// six_step_registered: steplock::SixStepRegistered, printed by hlsgen from hls/bus/six_step_registered.hpp:23.
// Do not edit: change the C++ and print again.

module six_step_registered #(
    parameter logic WITH_HALL_DECODER = 1'b1,  // for Hall sensors, and to catch a rotor that turns
    parameter logic WITH_TELEMETRY = 1'b1  // its counters
) (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        pins_comparator_u_i,  // terminal U above the reference
    input  logic        pins_comparator_v_i,  // terminal V above the reference
    input  logic        pins_comparator_w_i,  // terminal W above the reference
    input  logic        pins_limit_i,  // shunt current above the limit
    input  logic        pins_fault_i,  // external fault, active high
    input  logic        pins_hall_u_i,  // Hall sensor U
    input  logic        pins_hall_v_i,  // Hall sensor V
    input  logic        pins_hall_w_i,  // Hall sensor W
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
    output logic        interrupt_o,  // level
    output logic        locked_o,  // running under speed control
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
  logic boundary;
  logic read_capability;

  wire [13:0] words_words_pwm_period;
  wire [13:0] words_words_pwm_minimum;
  wire words_words_pwm_centred;
  wire words_words_pwm_complementary;
  wire [7:0] words_words_pwm_dead_time;
  wire [7:0] words_words_pwm_tick_periods;
  wire [7:0] words_words_limit_blanking;
  wire [11:0] words_words_limit_off_time;
  wire [1:0] words_words_bemf_sampling;
  wire [9:0] words_words_bemf_blanking;
  wire [7:0] words_words_bemf_sample_every;
  wire [3:0] words_words_bemf_samples;
  wire words_words_loop_detector;
  wire words_words_loop_bandwidth;
  wire [1:0] words_words_loop_divide;
  wire [15:0] words_words_loop_expected;
  wire [15:0] words_words_loop_lead_error;
  wire [9:0] words_words_loop_delay;
  wire [15:0] words_words_loop_ki;
  wire [15:0] words_words_loop_kp;
  wire [15:0] words_words_loop_pole;
  wire [25:0] words_words_loop_scale;
  wire [25:0] words_words_loop_minimum;
  wire [25:0] words_words_loop_maximum;
  wire [11:0] words_words_start_settle;
  wire [11:0] words_words_start_reset;
  wire [15:0] words_words_start_reset_duty;
  wire [15:0] words_words_start_start_duty;
  wire [19:0] words_words_start_ramp;
  wire [25:0] words_words_start_hand_over;
  wire [15:0] words_words_start_window;
  wire [5:0] words_words_start_good_crossings;
  wire [11:0] words_words_start_pull_in;
  wire [11:0] words_words_start_observe;
  wire [11:0] words_words_start_slow_down;
  wire [11:0] words_words_start_brake;
  wire [15:0] words_words_start_brake_duty;
  wire [11:0] words_words_start_rest;
  wire [3:0] words_words_start_retries;
  wire [25:0] words_words_speed_target;
  wire [19:0] words_words_speed_slew;
  wire [3:0] words_words_speed_shift;
  wire [15:0] words_words_speed_kp;
  wire [15:0] words_words_speed_ki;
  wire [15:0] words_words_speed_bemf;
  wire [15:0] words_words_speed_loaded;
  wire [15:0] words_words_speed_minimum;
  wire [15:0] words_words_speed_maximum;
  wire [11:0] words_words_speed_duty_slew;
  wire [5:0] words_words_protection_misses;
  wire [25:0] words_words_protection_stall;
  wire [15:0] words_words_protection_slip;
  wire [15:0] words_words_protection_freewheel;
  wire [11:0] words_words_protection_wrong_lock;
  wire [3:0] words_words_protection_over_current;
  wire words_words_source;
  wire [31:0] words_data;
  wire words_hole;
  wire words_refused;
  wire words_unlocked;
  wire words_no_period;
  word_registers words (
      .clk(clk),
      .rst(rst),
      .request_write_i(request_write_i),
      .request_read_i(request_read_i),
      .request_index_i(request_index_i),
      .request_data_i(request_data_i),
      .request_strobes_i(request_strobes_i),
      .stopped_i(stopped),
      .boundary_i(boundary),
      .words_pwm_period_o(words_words_pwm_period),
      .words_pwm_minimum_o(words_words_pwm_minimum),
      .words_pwm_centred_o(words_words_pwm_centred),
      .words_pwm_complementary_o(words_words_pwm_complementary),
      .words_pwm_dead_time_o(words_words_pwm_dead_time),
      .words_pwm_tick_periods_o(words_words_pwm_tick_periods),
      .words_limit_blanking_o(words_words_limit_blanking),
      .words_limit_off_time_o(words_words_limit_off_time),
      .words_bemf_sampling_o(words_words_bemf_sampling),
      .words_bemf_blanking_o(words_words_bemf_blanking),
      .words_bemf_sample_every_o(words_words_bemf_sample_every),
      .words_bemf_samples_o(words_words_bemf_samples),
      .words_loop_detector_o(words_words_loop_detector),
      .words_loop_bandwidth_o(words_words_loop_bandwidth),
      .words_loop_divide_o(words_words_loop_divide),
      .words_loop_expected_o(words_words_loop_expected),
      .words_loop_lead_error_o(words_words_loop_lead_error),
      .words_loop_delay_o(words_words_loop_delay),
      .words_loop_ki_o(words_words_loop_ki),
      .words_loop_kp_o(words_words_loop_kp),
      .words_loop_pole_o(words_words_loop_pole),
      .words_loop_scale_o(words_words_loop_scale),
      .words_loop_minimum_o(words_words_loop_minimum),
      .words_loop_maximum_o(words_words_loop_maximum),
      .words_start_settle_o(words_words_start_settle),
      .words_start_reset_o(words_words_start_reset),
      .words_start_reset_duty_o(words_words_start_reset_duty),
      .words_start_start_duty_o(words_words_start_start_duty),
      .words_start_ramp_o(words_words_start_ramp),
      .words_start_hand_over_o(words_words_start_hand_over),
      .words_start_window_o(words_words_start_window),
      .words_start_good_crossings_o(words_words_start_good_crossings),
      .words_start_pull_in_o(words_words_start_pull_in),
      .words_start_observe_o(words_words_start_observe),
      .words_start_slow_down_o(words_words_start_slow_down),
      .words_start_brake_o(words_words_start_brake),
      .words_start_brake_duty_o(words_words_start_brake_duty),
      .words_start_rest_o(words_words_start_rest),
      .words_start_retries_o(words_words_start_retries),
      .words_speed_target_o(words_words_speed_target),
      .words_speed_slew_o(words_words_speed_slew),
      .words_speed_shift_o(words_words_speed_shift),
      .words_speed_kp_o(words_words_speed_kp),
      .words_speed_ki_o(words_words_speed_ki),
      .words_speed_bemf_o(words_words_speed_bemf),
      .words_speed_loaded_o(words_words_speed_loaded),
      .words_speed_minimum_o(words_words_speed_minimum),
      .words_speed_maximum_o(words_words_speed_maximum),
      .words_speed_duty_slew_o(words_words_speed_duty_slew),
      .words_protection_misses_o(words_words_protection_misses),
      .words_protection_stall_o(words_words_protection_stall),
      .words_protection_slip_o(words_words_protection_slip),
      .words_protection_freewheel_o(words_words_protection_freewheel),
      .words_protection_wrong_lock_o(words_words_protection_wrong_lock),
      .words_protection_over_current_o(words_words_protection_over_current),
      .words_source_o(words_words_source),
      .data_o(words_data),
      .hole_o(words_hole),
      .refused_o(words_refused),
      .unlocked_o(words_unlocked),
      .no_period_o(words_no_period)
  );

  wire unused_pwm_on;
  wire pwm_start;
  wire pwm_tick;
  pwm_generator pwm (
      .clk(clk),
      .rst(rst),
      .on_clocks_i(14'd0),
      .period_i(words_words_pwm_period),
      .minimum_i(14'd0),
      .centred_i(1'b0),
      .tick_periods_i(words_words_pwm_tick_periods),
      .on_o(unused_pwm_on),
      .start_o(pwm_start),
      .tick_o(pwm_tick)
  );

  wire drive_gates_uh;
  wire drive_gates_ul;
  wire drive_gates_vh;
  wire drive_gates_vl;
  wire drive_gates_wh;
  wire drive_gates_wl;
  wire [3:0] drive_state;
  wire [3:0] drive_reason;
  wire drive_locked;
  wire drive_reverse;
  wire [2:0] unused_drive_step;
  wire unused_drive_chop;
  wire unused_drive_commutate;
  wire unused_drive_turn;
  wire [25:0] drive_frequency;
  wire [15:0] unused_drive_step_phase;
  wire [15:0] drive_phase_error;
  wire unused_drive_update;
  wire unused_drive_crossing;
  wire unused_drive_missed;
  wire [15:0] unused_drive_crossing_phase;
  wire [15:0] unused_drive_freewheel;
  wire [15:0] drive_duty;
  wire [15:0] drive_counts_crossings;
  wire [15:0] drive_counts_missed;
  wire [15:0] drive_counts_freewheel_long;
  wire [15:0] drive_counts_limit_hits;
  wire [15:0] drive_counts_retries;
  six_step_top #(.WITH_HALL_DECODER(WITH_HALL_DECODER), .WITH_TELEMETRY(WITH_TELEMETRY)) drive (
      .clk(clk),
      .rst(rst),
      .pins_comparator_u_i(pins_comparator_u_i),
      .pins_comparator_v_i(pins_comparator_v_i),
      .pins_comparator_w_i(pins_comparator_w_i),
      .pins_limit_i(pins_limit_i),
      .pins_fault_i(pins_fault_i),
      .pins_hall_u_i(pins_hall_u_i),
      .pins_hall_v_i(pins_hall_v_i),
      .pins_hall_w_i(pins_hall_w_i),
      .command_configured_i(command_configured),
      .command_run_i(command_run),
      .command_reverse_i(command_reverse),
      .command_brake_to_stop_i(command_brake_to_stop),
      .command_clear_fault_i(command_clear_fault),
      .words_pwm_period_i(words_words_pwm_period),
      .words_pwm_minimum_i(words_words_pwm_minimum),
      .words_pwm_centred_i(words_words_pwm_centred),
      .words_pwm_complementary_i(words_words_pwm_complementary),
      .words_pwm_dead_time_i(words_words_pwm_dead_time),
      .words_pwm_tick_periods_i(words_words_pwm_tick_periods),
      .words_limit_blanking_i(words_words_limit_blanking),
      .words_limit_off_time_i(words_words_limit_off_time),
      .words_bemf_sampling_i(words_words_bemf_sampling),
      .words_bemf_blanking_i(words_words_bemf_blanking),
      .words_bemf_sample_every_i(words_words_bemf_sample_every),
      .words_bemf_samples_i(words_words_bemf_samples),
      .words_loop_detector_i(words_words_loop_detector),
      .words_loop_bandwidth_i(words_words_loop_bandwidth),
      .words_loop_divide_i(words_words_loop_divide),
      .words_loop_expected_i(words_words_loop_expected),
      .words_loop_lead_error_i(words_words_loop_lead_error),
      .words_loop_delay_i(words_words_loop_delay),
      .words_loop_ki_i(words_words_loop_ki),
      .words_loop_kp_i(words_words_loop_kp),
      .words_loop_pole_i(words_words_loop_pole),
      .words_loop_scale_i(words_words_loop_scale),
      .words_loop_minimum_i(words_words_loop_minimum),
      .words_loop_maximum_i(words_words_loop_maximum),
      .words_start_settle_i(words_words_start_settle),
      .words_start_reset_i(words_words_start_reset),
      .words_start_reset_duty_i(words_words_start_reset_duty),
      .words_start_start_duty_i(words_words_start_start_duty),
      .words_start_ramp_i(words_words_start_ramp),
      .words_start_hand_over_i(words_words_start_hand_over),
      .words_start_window_i(words_words_start_window),
      .words_start_good_crossings_i(words_words_start_good_crossings),
      .words_start_pull_in_i(words_words_start_pull_in),
      .words_start_observe_i(words_words_start_observe),
      .words_start_slow_down_i(words_words_start_slow_down),
      .words_start_brake_i(words_words_start_brake),
      .words_start_brake_duty_i(words_words_start_brake_duty),
      .words_start_rest_i(words_words_start_rest),
      .words_start_retries_i(words_words_start_retries),
      .words_speed_target_i(words_words_speed_target),
      .words_speed_slew_i(words_words_speed_slew),
      .words_speed_shift_i(words_words_speed_shift),
      .words_speed_kp_i(words_words_speed_kp),
      .words_speed_ki_i(words_words_speed_ki),
      .words_speed_bemf_i(words_words_speed_bemf),
      .words_speed_loaded_i(words_words_speed_loaded),
      .words_speed_minimum_i(words_words_speed_minimum),
      .words_speed_maximum_i(words_words_speed_maximum),
      .words_speed_duty_slew_i(words_words_speed_duty_slew),
      .words_protection_misses_i(words_words_protection_misses),
      .words_protection_stall_i(words_words_protection_stall),
      .words_protection_slip_i(words_words_protection_slip),
      .words_protection_freewheel_i(words_words_protection_freewheel),
      .words_protection_wrong_lock_i(words_words_protection_wrong_lock),
      .words_protection_over_current_i(words_words_protection_over_current),
      .words_source_i(words_words_source),
      .gates_uh_o(drive_gates_uh),
      .gates_ul_o(drive_gates_ul),
      .gates_vh_o(drive_gates_vh),
      .gates_vl_o(drive_gates_vl),
      .gates_wh_o(drive_gates_wh),
      .gates_wl_o(drive_gates_wl),
      .state_o(drive_state),
      .reason_o(drive_reason),
      .locked_o(drive_locked),
      .reverse_o(drive_reverse),
      .step_o(unused_drive_step),
      .chop_o(unused_drive_chop),
      .commutate_o(unused_drive_commutate),
      .turn_o(unused_drive_turn),
      .frequency_o(drive_frequency),
      .step_phase_o(unused_drive_step_phase),
      .phase_error_o(drive_phase_error),
      .update_o(unused_drive_update),
      .crossing_o(unused_drive_crossing),
      .missed_o(unused_drive_missed),
      .crossing_phase_o(unused_drive_crossing_phase),
      .freewheel_o(unused_drive_freewheel),
      .duty_o(drive_duty),
      .counts_crossings_o(drive_counts_crossings),
      .counts_missed_o(drive_counts_missed),
      .counts_freewheel_long_o(drive_counts_freewheel_long),
      .counts_limit_hits_o(drive_counts_limit_hits),
      .counts_retries_o(drive_counts_retries)
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
  drive_registers registers (
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
      .tick_i(pwm_tick),
      .drive_state_i(drive_state),
      .drive_reason_i(drive_reason),
      .drive_locked_i(drive_locked),
      .drive_reverse_i(drive_reverse),
      .drive_frequency_i(drive_frequency),
      .drive_duty_i(drive_duty),
      .drive_phase_error_i(drive_phase_error),
      .drive_counts_crossings_i(drive_counts_crossings),
      .drive_counts_missed_i(drive_counts_missed),
      .drive_counts_freewheel_long_i(drive_counts_freewheel_long),
      .drive_counts_limit_hits_i(drive_counts_limit_hits),
      .drive_counts_retries_i(drive_counts_retries),
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

  wire [4:0] absent = (!read_capability || WITH_HALL_DECODER) ? 5'd0 : 5'd16;  // line 67
  wire [6:0] absent_2 = (!read_capability || WITH_TELEMETRY) ? {2'd0, absent} : {2'd2, absent};
  wire [7:0] inverse_79 = ~{1'b0, absent_2};  // line 79

  always_ff @(posedge clk) begin
    command_configured <= registers_command_configured;
    command_run <= registers_command_run;
    command_reverse <= registers_command_reverse;
    command_brake_to_stop <= registers_command_brake_to_stop;
    command_clear_fault <= registers_command_clear_fault;
    stopped <= registers_stopped && !(command_run || registers_command_run);  // line 72
    boundary <= pwm_start;
    if (request_read_i) begin
      read_capability <= request_index_i == 10'd2;
    end
    if (rst) begin
      command_configured <= 1'b0;
      command_run <= 1'b0;
      command_reverse <= 1'b0;
      command_brake_to_stop <= 1'b0;
      command_clear_fault <= 1'b0;
      stopped <= 1'b1;
      boundary <= 1'b0;
      read_capability <= 1'b0;
    end
  end

  assign gates_uh_o = drive_gates_uh;
  assign gates_ul_o = drive_gates_ul;
  assign gates_vh_o = drive_gates_vh;
  assign gates_vl_o = drive_gates_vl;
  assign gates_wh_o = drive_gates_wh;
  assign gates_wl_o = drive_gates_wl;
  assign interrupt_o = registers_interrupt;
  assign locked_o = drive_locked;
  assign fault_o = drive_state == 4'd10;
  assign data_o = registers_data & {{24{inverse_79[7]}}, inverse_79};
  assign read_error_o = registers_read_error;
  assign write_error_o = registers_write_error;
endmodule
