// six_step_bare: steplock::SixStepBare, printed by hlsgen from hls/six_step/six_step_bare.hpp:23.
// Do not edit: change the C++ and print again.

module six_step_bare #(
    parameter logic WITH_HALL_DECODER = 1'b1
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
    input  logic        controls_run_i,
    input  logic        controls_reverse_i,
    input  logic [1:0]  controls_speed_i,  // 0 to 3: a quarter to the whole of the set speed
    input  logic        brake_to_stop_i,  // else coast; fixed at synthesis, as are the words
    input  logic [13:0] words_pwm_period_i,  // clocks; 0 keeps the high sides off; taken at the period's start
    input  logic [13:0] words_pwm_minimum_i,  // clocks; shorter on or off times become 0 % or 100 %
    input  logic        words_pwm_centred_i,  // pulses centred in the period instead of at its start
    input  logic        words_pwm_complementary_i,  // the chopped leg's low side conducts in the off-time
    input  logic [7:0]  words_pwm_dead_time_i,  // clocks; the floor fixed at synthesis wins
    input  logic [7:0]  words_pwm_tick_periods_i,  // PWM periods per tick; 0 counts as 1
    input  logic [7:0]  words_limit_blanking_i,  // clocks after switch-on in which the comparator is not believed
    input  logic [11:0] words_limit_off_time_i,  // clocks; 0 disables the current limit
    input  logic [1:0]  words_bemf_sampling_i,
    input  logic [9:0]  words_bemf_blanking_i,  // clocks after each edge of the chopped gate
    input  logic [7:0]  words_bemf_sample_every_i,  // clocks between samples; 0 counts as 1
    input  logic [3:0]  words_bemf_samples_i,  // of the filter, 1 to 15; 0 counts as 1
    input  logic        words_loop_detector_i,
    input  logic        words_loop_bandwidth_i,
    input  logic [1:0]  words_loop_divide_i,  // N = 6 * 2^divide VCO turns per electrical turn
    input  logic [15:0] words_loop_expected_i,  // u0.16: the crossing's place in the step; 1/2 + advance / 60 deg
    input  logic [15:0] words_loop_lead_error_i,  // u0.16: error of a rotor that led and hides the level before
    input  logic [9:0]  words_loop_delay_i,  // clocks from the crossing at the motor to the sample, taken back
    input  logic [15:0] words_loop_ki_i,  // u2.14
    input  logic [15:0] words_loop_kp_i,  // u2.14
    input  logic [15:0] words_loop_pole_i,  // u1.15: 1 - exp(-omega_p T); 0x8000 is no pole; last bit unused
    input  logic [25:0] words_loop_scale_i,  // u0.32: for the frequency, per second; last four bits unused
    input  logic [25:0] words_loop_minimum_i,  // limits of the integrator and of the output
    input  logic [25:0] words_loop_maximum_i,
    input  logic [11:0] words_start_settle_i,  // first pattern, so that a rotor opposite to the reset place moves
    input  logic [11:0] words_start_reset_i,  // reset pattern: t_r of Eq. (22)
    input  logic [15:0] words_start_reset_duty_i,  // twice that from the third try on, and so start_duty
    input  logic [15:0] words_start_start_duty_i,  // during acceleration and pull-in
    input  logic [19:0] words_start_ramp_i,  // u0.32 per tick: the VCO's acceleration; a quarter after each failed try
    input  logic [25:0] words_start_hand_over_i,  // f_a: the end of the ramp
    input  logic [15:0] words_start_window_i,  // u0.16: a crossing closer than this to its place is a good one
    input  logic [5:0]  words_start_good_crossings_i,  // in a row, for lock (and for catching)
    input  logic [11:0] words_start_pull_in_i,  // time limit from hand-over to lock
    input  logic [11:0] words_start_observe_i,  // time to look for a rotor that already spins; 0 skips it
    input  logic [11:0] words_start_slow_down_i,  // time limit for slowing to hand-over speed before a reversal
    input  logic [11:0] words_start_brake_i,  // one braking interval, between two looks
    input  logic [15:0] words_start_brake_duty_i,
    input  logic [11:0] words_start_rest_i,  // gates off between a failure and the next try
    input  logic [3:0]  words_start_retries_i,  // failed tries before the fault latches
    input  logic [25:0] words_speed_target_i,  // u0.32
    input  logic [19:0] words_speed_slew_i,  // u0.32 per tick
    input  logic [3:0]  words_speed_shift_i,  // speeds are normalised: frequency >> shift fits 15 bits
    input  logic [15:0] words_speed_kp_i,  // u4.12: duty per normalised speed error (s1.15 against u1.15)
    input  logic [15:0] words_speed_ki_i,  // u0.16 per tick
    input  logic [15:0] words_speed_bemf_i,  // u4.12: duty of mean voltage equal to the back-EMF, per speed
    input  logic [15:0] words_speed_loaded_i,  // u4.12: the same, and of commutating the largest current
    input  logic [15:0] words_speed_minimum_i,
    input  logic [15:0] words_speed_maximum_i,
    input  logic [11:0] words_speed_duty_slew_i,  // u1.15 per tick
    input  logic [5:0]  words_protection_misses_i,  // lost lock: score of missed (4), hidden or far (1), good (-1) crossings; 0: off
    input  logic [25:0] words_protection_stall_i,  // u0.32: slower than this in speed control is a stall
    input  logic [15:0] words_protection_slip_i,  // duty above the back-EMF's that no right lock shows
    input  logic [15:0] words_protection_freewheel_i,  // u0.16: freewheeling for longer than this part of a step is wrong
    input  logic [11:0] words_protection_wrong_lock_i,  // a wrong tick takes two of them; 0 disables the test
    input  logic [3:0]  words_protection_over_current_i,  // limit hits with the comparator never released; 0 disables
    input  logic        words_source_i,
    output logic        gates_uh_o,  // phase U, high side
    output logic        gates_ul_o,  // phase U, low side
    output logic        gates_vh_o,  // phase V, high side
    output logic        gates_vl_o,  // phase V, low side
    output logic        gates_wh_o,  // phase W, high side
    output logic        gates_wl_o,  // phase W, low side
    output logic        locked_o,  // running under speed control
    output logic        fault_o,  // latched
    output logic        turn_o  // the divided VCO signal: a tachometer, one period per electrical turn
);
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic
      first_run,
      first_reverse;
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic [1:0] first_speed;  // 0 to 3: a quarter to the whole of the set speed
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic
      second_run,
      second_reverse;
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic [1:0] second_speed;  // 0 to 3: a quarter to the whole of the set speed
  logic taken_run;
  logic taken_reverse;
  logic [1:0] taken_speed;  // 0 to 3: a quarter to the whole of the set speed
  logic run;  // and whether to run
  logic takes;  // the pins are taken in this clock
  logic [16:0] bounce;

  wire [25:0] choice_87 =  // line 87
      ({2'd0, words_speed_target_i[25:2]} < words_start_hand_over_i) ? words_start_hand_over_i :
      {2'd0, words_speed_target_i[25:2]};
  wire [25:0] choice_87_2 =  // line 87
      ({1'b0, words_speed_target_i[25:1]} < words_start_hand_over_i) ? words_start_hand_over_i :
      {1'b0, words_speed_target_i[25:1]};
  wire [25:0] part = {1'b0, words_speed_target_i[25:1]} + {2'd0, words_speed_target_i[25:2]};

  logic [25:0] words_speed_target;  // line 48
  always_comb begin
    case (taken_speed)
      2'd0: words_speed_target = choice_87;
      2'd1: words_speed_target = choice_87_2;
      2'd2: words_speed_target = (part < words_start_hand_over_i) ? words_start_hand_over_i : part;
      default: words_speed_target =
          (words_speed_target_i < words_start_hand_over_i) ? words_start_hand_over_i :
          words_speed_target_i;
    endcase
  end

  wire drive_gates_uh;
  wire drive_gates_ul;
  wire drive_gates_vh;
  wire drive_gates_vl;
  wire drive_gates_wh;
  wire drive_gates_wl;
  wire [3:0] drive_state;
  wire [3:0] unused_drive_reason;
  wire drive_locked;
  wire unused_drive_reverse;
  wire [2:0] unused_drive_step;
  wire unused_drive_chop;
  wire unused_drive_commutate;
  wire drive_turn;
  wire [25:0] unused_drive_frequency;
  wire [15:0] unused_drive_step_phase;
  wire [15:0] unused_drive_phase_error;
  wire unused_drive_update;
  wire unused_drive_crossing;
  wire unused_drive_missed;
  wire [15:0] unused_drive_crossing_phase;
  wire [15:0] unused_drive_freewheel;
  wire [15:0] unused_drive_duty;
  wire [15:0] unused_drive_counts_crossings;
  wire [15:0] unused_drive_counts_missed;
  wire [15:0] unused_drive_counts_freewheel_long;
  wire [15:0] unused_drive_counts_limit_hits;
  wire [15:0] unused_drive_counts_retries;
  six_step_top #(.WITH_HALL_DECODER(WITH_HALL_DECODER), .WITH_TELEMETRY(1'b0)) drive (
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
      .command_configured_i(1'b1),
      .command_run_i(run),
      .command_reverse_i(taken_reverse),
      .command_brake_to_stop_i(brake_to_stop_i),
      .command_clear_fault_i(takes && !run),
      .words_pwm_period_i(words_pwm_period_i),
      .words_pwm_minimum_i(words_pwm_minimum_i),
      .words_pwm_centred_i(words_pwm_centred_i),
      .words_pwm_complementary_i(words_pwm_complementary_i),
      .words_pwm_dead_time_i(words_pwm_dead_time_i),
      .words_pwm_tick_periods_i(words_pwm_tick_periods_i),
      .words_limit_blanking_i(words_limit_blanking_i),
      .words_limit_off_time_i(words_limit_off_time_i),
      .words_bemf_sampling_i(words_bemf_sampling_i),
      .words_bemf_blanking_i(words_bemf_blanking_i),
      .words_bemf_sample_every_i(words_bemf_sample_every_i),
      .words_bemf_samples_i(words_bemf_samples_i),
      .words_loop_detector_i(words_loop_detector_i),
      .words_loop_bandwidth_i(words_loop_bandwidth_i),
      .words_loop_divide_i(words_loop_divide_i),
      .words_loop_expected_i(words_loop_expected_i),
      .words_loop_lead_error_i(words_loop_lead_error_i),
      .words_loop_delay_i(words_loop_delay_i),
      .words_loop_ki_i(words_loop_ki_i),
      .words_loop_kp_i(words_loop_kp_i),
      .words_loop_pole_i(words_loop_pole_i),
      .words_loop_scale_i(words_loop_scale_i),
      .words_loop_minimum_i(words_loop_minimum_i),
      .words_loop_maximum_i(words_loop_maximum_i),
      .words_start_settle_i(words_start_settle_i),
      .words_start_reset_i(words_start_reset_i),
      .words_start_reset_duty_i(words_start_reset_duty_i),
      .words_start_start_duty_i(words_start_start_duty_i),
      .words_start_ramp_i(words_start_ramp_i),
      .words_start_hand_over_i(words_start_hand_over_i),
      .words_start_window_i(words_start_window_i),
      .words_start_good_crossings_i(words_start_good_crossings_i),
      .words_start_pull_in_i(words_start_pull_in_i),
      .words_start_observe_i(words_start_observe_i),
      .words_start_slow_down_i(words_start_slow_down_i),
      .words_start_brake_i(words_start_brake_i),
      .words_start_brake_duty_i(words_start_brake_duty_i),
      .words_start_rest_i(words_start_rest_i),
      .words_start_retries_i(words_start_retries_i),
      .words_speed_target_i(words_speed_target),
      .words_speed_slew_i(words_speed_slew_i),
      .words_speed_shift_i(words_speed_shift_i),
      .words_speed_kp_i(words_speed_kp_i),
      .words_speed_ki_i(words_speed_ki_i),
      .words_speed_bemf_i(words_speed_bemf_i),
      .words_speed_loaded_i(words_speed_loaded_i),
      .words_speed_minimum_i(words_speed_minimum_i),
      .words_speed_maximum_i(words_speed_maximum_i),
      .words_speed_duty_slew_i(words_speed_duty_slew_i),
      .words_protection_misses_i(words_protection_misses_i),
      .words_protection_stall_i(words_protection_stall_i),
      .words_protection_slip_i(words_protection_slip_i),
      .words_protection_freewheel_i(words_protection_freewheel_i),
      .words_protection_wrong_lock_i(words_protection_wrong_lock_i),
      .words_protection_over_current_i(words_protection_over_current_i),
      .words_source_i(words_source_i),
      .gates_uh_o(drive_gates_uh),
      .gates_ul_o(drive_gates_ul),
      .gates_vh_o(drive_gates_vh),
      .gates_vl_o(drive_gates_vl),
      .gates_wh_o(drive_gates_wh),
      .gates_wl_o(drive_gates_wl),
      .state_o(drive_state),
      .reason_o(unused_drive_reason),
      .locked_o(drive_locked),
      .reverse_o(unused_drive_reverse),
      .step_o(unused_drive_step),
      .chop_o(unused_drive_chop),
      .commutate_o(unused_drive_commutate),
      .turn_o(drive_turn),
      .frequency_o(unused_drive_frequency),
      .step_phase_o(unused_drive_step_phase),
      .phase_error_o(unused_drive_phase_error),
      .update_o(unused_drive_update),
      .crossing_o(unused_drive_crossing),
      .missed_o(unused_drive_missed),
      .crossing_phase_o(unused_drive_crossing_phase),
      .freewheel_o(unused_drive_freewheel),
      .duty_o(unused_drive_duty),
      .counts_crossings_o(unused_drive_counts_crossings),
      .counts_missed_o(unused_drive_counts_missed),
      .counts_freewheel_long_o(unused_drive_counts_freewheel_long),
      .counts_limit_hits_o(unused_drive_counts_limit_hits),
      .counts_retries_o(unused_drive_counts_retries)
  );

  always_ff @(posedge clk) begin
    first_run <= controls_run_i;
    first_reverse <= controls_reverse_i;
    first_speed <= controls_speed_i;
    second_run <= first_run;
    second_reverse <= first_reverse;
    second_speed <= first_speed;
    taken_run <= (takes ? second_run : taken_run) && second_run;  // line 59
    if (takes) begin
      taken_reverse <= second_reverse;
      taken_speed <= second_speed;
    end
    run <= taken_run && second_run;  // line 57
    takes <= bounce == 17'd0;  // line 60
    bounce <= bounce + 17'd1;  // line 61
    if (rst) begin
      first_run <= 1'b0;
      first_reverse <= 1'b0;
      first_speed <= 2'd0;
      second_run <= 1'b0;
      second_reverse <= 1'b0;
      second_speed <= 2'd0;
      taken_run <= 1'b0;
      taken_reverse <= 1'b0;
      taken_speed <= 2'd0;
      run <= 1'b0;
      takes <= 1'b0;
      bounce <= 17'd0;
    end
  end

  assign gates_uh_o = drive_gates_uh;
  assign gates_ul_o = drive_gates_ul;
  assign gates_vh_o = drive_gates_vh;
  assign gates_vl_o = drive_gates_vl;
  assign gates_wh_o = drive_gates_wh;
  assign gates_wl_o = drive_gates_wl;
  assign locked_o = drive_locked;
  assign fault_o = drive_state == 4'd10;
  assign turn_o = drive_turn;
endmodule
