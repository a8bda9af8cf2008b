// six_step_top: steplock::SixStepTop, printed by hlsgen from hls/six_step/six_step_top.hpp:42.
// Do not edit: change the C++ and print again.

module six_step_top #(
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
    input  logic        command_configured_i,  // the words are valid; until then all six gates are off
    input  logic        command_run_i,
    input  logic        command_reverse_i,
    input  logic        command_brake_to_stop_i,  // else coast
    input  logic        command_clear_fault_i,  // a rising edge re-arms, once `run` is low and the cause is gone
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
    output logic [3:0]  state_o,
    output logic [3:0]  reason_o,
    output logic        locked_o,  // running under speed control
    output logic        reverse_o,  // direction of rotation
    output logic [2:0]  step_o,  // 0 to 5
    output logic        chop_o,  // PWM and current limit: on
    output logic        commutate_o,  // one clock, the first of a new step
    output logic        turn_o,  // the divided VCO signal
    output logic [25:0] frequency_o,  // u0.32, VCO turns per clock
    output logic [15:0] step_phase_o,  // u0.16, turns of this step
    output logic [15:0] phase_error_o,  // s0.16, turns of one step
    output logic        update_o,  // strobe: the phase error is new
    output logic        crossing_o,  // strobe: the back-EMF crossed zero
    output logic        missed_o,  // strobe: a step ended without a crossing
    output logic [15:0] crossing_phase_o,  // u0.16, where in the step
    output logic [15:0] freewheel_o,  // u0.16, where in the step freewheeling ended
    output logic [15:0] duty_o,  // u1.15
    output logic [15:0] counts_crossings_o,  // events, stops at 65535
    output logic [15:0] counts_missed_o,  // events, stops at 65535
    output logic [15:0] counts_freewheel_long_o,  // events, stops at 65535
    output logic [15:0] counts_limit_hits_o,  // events, stops at 65535
    output logic [15:0] counts_retries_o  // events, stops at 65535
);
  localparam logic [3:0] Reason_kNone = 4'd0;

  logic tick;
  logic chop;
  logic limited;
  logic [2:0] divided_step;  // 0 to 5
  logic [15:0] divided_phase;  // u0.16, turns of one step
  logic divided_commutate;  // one clock, the first of a new step
  logic divided_elapsed;  // one clock: a step's worth of VCO turns is over, even if held
  logic legs_uh;  // phase U, high side
  logic legs_ul;  // phase U, low side
  logic legs_vh;  // phase V, high side
  logic legs_vl;  // phase V, low side
  logic legs_wh;  // phase W, high side
  logic legs_wl;  // phase W, low side
  logic fast;
  logic update;
  logic good;
  logic lags;
  logic hurries;
  logic lost;
  logic fatal;
  logic [3:0] cause;

  wire both_77 = WITH_HALL_DECODER && words_source_i;  // line 77

  wire synchroniser_comparator_u;
  wire synchroniser_comparator_v;
  wire synchroniser_comparator_w;
  wire synchroniser_limit;
  wire synchroniser_fault;
  wire synchroniser_hall_u;
  wire synchroniser_hall_v;
  wire synchroniser_hall_w;
  synchroniser synchroniser (
      .clk(clk),
      .rst(rst),
      .comparator_u_i(pins_comparator_u_i),
      .comparator_v_i(pins_comparator_v_i),
      .comparator_w_i(pins_comparator_w_i),
      .limit_i(pins_limit_i),
      .fault_i(pins_fault_i),
      .hall_u_i(pins_hall_u_i),
      .hall_v_i(pins_hall_v_i),
      .hall_w_i(pins_hall_w_i),
      .comparator_u_o(synchroniser_comparator_u),
      .comparator_v_o(synchroniser_comparator_v),
      .comparator_w_o(synchroniser_comparator_w),
      .limit_o(synchroniser_limit),
      .fault_o(synchroniser_fault),
      .hall_u_o(synchroniser_hall_u),
      .hall_v_o(synchroniser_hall_v),
      .hall_w_o(synchroniser_hall_w)
  );

  wire both = command_configured_i && (WITH_HALL_DECODER || !words_source_i);

  wire [2:0] hall_sector;
  wire hall_legal;
  wire hall_moved;
  wire hall_reverse;
  wire hall_jumped;
  hall_decoder #(.DECODES(WITH_HALL_DECODER)) hall (
      .clk(clk),
      .rst(rst),
      .u_i(both_77 ? synchroniser_hall_u : synchroniser_comparator_u),
      .v_i(both_77 ? synchroniser_hall_v : synchroniser_comparator_v),
      .w_i(both_77 ? synchroniser_hall_w : synchroniser_comparator_w),
      .hold_i(words_bemf_blanking_i),
      .sector_o(hall_sector),
      .legal_o(hall_legal),
      .moved_o(hall_moved),
      .reverse_o(hall_reverse),
      .jumped_o(hall_jumped)
  );

  wire [2:0] choice = (hall_sector < 3'd3) ? 3'd3 : 3'd5;

  wire [3:0] start_state;
  wire [3:0] start_reason;
  wire start_enable;
  wire [4:0] start_pattern_bits;
  wire start_reverse;
  wire start_running;
  wire [1:0] start_mode;
  wire [15:0] start_duty;
  wire start_stop;
  wire [1:0] start_watch;
  wire [2:0] start_loop;
  wire start_load_step;
  wire [2:0] start_step;
  wire start_turn_vco;
  wire [1:0] start_gentle;
  wire start_began;
  wire start_failed;
  start_sequence #(.OBSERVES(WITH_HALL_DECODER)) start (
      .clk(clk),
      .rst(rst),
      .tick_i(tick),
      .command_configured_i(both),
      .command_run_i(command_run_i),
      .command_reverse_i(command_reverse_i),
      .command_brake_to_stop_i(command_brake_to_stop_i),
      .command_clear_fault_i(command_clear_fault_i),
      .source_i(words_source_i),
      .words_settle_i(words_start_settle_i),
      .words_reset_i(words_start_reset_i),
      .words_reset_duty_i(words_start_reset_duty_i),
      .words_start_duty_i(words_start_start_duty_i),
      .words_ramp_i(words_start_ramp_i),
      .words_hand_over_i(words_start_hand_over_i),
      .words_window_i(words_start_window_i),
      .words_good_crossings_i(words_start_good_crossings_i),
      .words_pull_in_i(words_start_pull_in_i),
      .words_observe_i(words_start_observe_i),
      .words_slow_down_i(words_start_slow_down_i),
      .words_brake_i(words_start_brake_i),
      .words_brake_duty_i(words_start_brake_duty_i),
      .words_rest_i(words_start_rest_i),
      .words_retries_i(words_start_retries_i),
      .fast_i(fast),
      .commutate_i(divided_commutate),
      .update_i(update),
      .good_i(good),
      .lags_i(lags),
      .turns_reverse_i(hall_reverse),
      .sector_i(hall_sector),
      .lost_i(lost),
      .fatal_i(fatal),
      .cause_i(cause),
      .state_o(start_state),
      .reason_o(start_reason),
      .enable_o(start_enable),
      .pattern_bits_o(start_pattern_bits),
      .reverse_o(start_reverse),
      .running_o(start_running),
      .mode_o(start_mode),
      .duty_o(start_duty),
      .stop_o(start_stop),
      .watch_o(start_watch),
      .loop_o(start_loop),
      .load_step_o(start_load_step),
      .step_o(start_step),
      .turn_vco_o(start_turn_vco),
      .gentle_o(start_gentle),
      .began_o(start_began),
      .failed_o(start_failed)
  );

  wire [2:0] hall_step = start_reverse ? hall_sector + choice : hall_sector;
  wire [2:0] step = both_77 ? hall_step : divided_step;  // line 109

  wire bemf_crossing;
  wire [15:0] bemf_crossing_phase;
  wire bemf_before_seen;
  wire [15:0] bemf_freewheel;
  bemf_comparator bemf (
      .clk(clk),
      .rst(rst),
      .u_i(synchroniser_comparator_u),
      .v_i(synchroniser_comparator_v),
      .w_i(synchroniser_comparator_w),
      .step_i(step),
      .reverse_i(start_reverse),
      .commutate_i(divided_commutate),
      .chop_i(chop),
      .phase_i(divided_phase),
      .words_sampling_i(words_bemf_sampling_i),
      .words_blanking_i(words_bemf_blanking_i),
      .words_sample_every_i(words_bemf_sample_every_i),
      .words_samples_i(words_bemf_samples_i),
      .crossing_o(bemf_crossing),
      .crossing_phase_o(bemf_crossing_phase),
      .before_seen_o(bemf_before_seen),
      .freewheel_o(bemf_freewheel)
  );

  wire [15:0] detector_error;
  wire detector_update;
  wire detector_good;
  wire detector_missed;
  wire detector_hurries;
  phase_detector detector (
      .clk(clk),
      .rst(rst),
      .watch_i(start_watch),
      .crossing_i(bemf_crossing),
      .crossing_phase_i(bemf_crossing_phase),
      .before_seen_i(bemf_before_seen),
      .commutate_i(divided_commutate),
      .step_i(step),
      .reverse_i(start_reverse),
      .changed_i(hall_moved),
      .elapsed_i(divided_elapsed),
      .phase_i(divided_phase),
      .detector_i(words_loop_detector_i),
      .expected_i(words_loop_expected_i),
      .lead_error_i(words_loop_lead_error_i),
      .window_i(words_start_window_i),
      .error_o(detector_error),
      .update_o(detector_update),
      .good_o(detector_good),
      .missed_o(detector_missed),
      .hurries_o(detector_hurries)
  );

  wire both_103 = WITH_HALL_DECODER && start_watch == 2'd2;  // line 103
  wire either_150 = start_load_step || (both_103 && (hall_moved || hall_jumped));  // line 150

  wire [25:0] filter_frequency;
  wire filter_fast;
  wire filter_slow;
  wire unused_filter_busy;
  loop_filter filter (
      .clk(clk),
      .rst(rst),
      .loop_i(start_loop),
      .error_i(detector_error),
      .update_i(detector_update),
      .tick_i(tick),
      .ramp_i(words_start_ramp_i),
      .gentle_i(start_gentle),
      .bandwidth_i(words_loop_bandwidth_i),
      .delay_i(words_loop_delay_i >> words_loop_divide_i),
      .ki_i(words_loop_ki_i),
      .kp_i(words_loop_kp_i),
      .pole_i(words_loop_pole_i),
      .scale_i(words_loop_scale_i),
      .minimum_i(words_loop_minimum_i),
      .maximum_i(words_loop_maximum_i),
      .hand_over_i(words_start_hand_over_i),
      .stall_i(words_protection_stall_i),
      .frequency_o(filter_frequency),
      .fast_o(filter_fast),
      .slow_o(filter_slow),
      .busy_o(unused_filter_busy)
  );

  wire [15:0] vco_phase;
  wire vco_pulse;
  vco_counter vco (
      .clk(clk),
      .rst(rst),
      .enable_i(start_turn_vco),
      .load_i(either_150),
      .half_i(start_load_step && words_loop_divide_i == 2'd0),
      .frequency_i(filter_frequency),
      .phase_o(vco_phase),
      .pulse_o(vco_pulse)
  );

  wire [15:0] speed_duty;
  wire [13:0] speed_on_clocks;
  wire speed_slips;
  speed_control speed (
      .clk(clk),
      .rst(rst),
      .tick_i(tick),
      .mode_i(start_mode),
      .fixed_duty_i(start_duty),
      .frequency_i(filter_frequency),
      .target_i(start_stop ? 26'd0 : words_speed_target_i),
      .limited_i(limited),
      .hurries_i(hurries),
      .period_i(words_pwm_period_i),
      .slip_i(words_protection_slip_i),
      .words_target_i(words_speed_target_i),
      .words_slew_i(words_speed_slew_i),
      .words_shift_i(words_speed_shift_i),
      .words_kp_i(words_speed_kp_i),
      .words_ki_i(words_speed_ki_i),
      .words_bemf_i(words_speed_bemf_i),
      .words_loaded_i(words_speed_loaded_i),
      .words_minimum_i(words_speed_minimum_i),
      .words_maximum_i(words_speed_maximum_i),
      .words_duty_slew_i(words_speed_duty_slew_i),
      .duty_o(speed_duty),
      .on_clocks_o(speed_on_clocks),
      .slips_o(speed_slips)
  );

  wire pwm_on;
  wire unused_pwm_start;
  wire pwm_tick;
  pwm_generator pwm (
      .clk(clk),
      .rst(rst),
      .on_clocks_i(speed_on_clocks),
      .period_i(words_pwm_period_i),
      .minimum_i(words_pwm_minimum_i),
      .centred_i(words_pwm_centred_i),
      .tick_periods_i(words_pwm_tick_periods_i),
      .on_o(pwm_on),
      .start_o(unused_pwm_start),
      .tick_o(pwm_tick)
  );

  wire [2:0] sum_185 = hall_step - 3'd3;  // line 185
  wire [2:0] sum_185_2 = hall_step - 3'd1;  // line 185

  wire limit_on;
  wire limit_hit;
  wire [3:0] limit_stuck;
  current_limit limit (
      .clk(clk),
      .rst(rst),
      .on_i(pwm_on),
      .comparator_i(synchroniser_limit),
      .words_blanking_i(words_limit_blanking_i),
      .words_off_time_i(words_limit_off_time_i),
      .on_o(limit_on),
      .hit_o(limit_hit),
      .stuck_o(limit_stuck)
  );

  wire commutation_uh;
  wire commutation_ul;
  wire commutation_vh;
  wire commutation_vl;
  wire commutation_wh;
  wire commutation_wl;
  commutation commutation (
      .pattern_bits_i(start_pattern_bits),
      .legs_uh_i(both_77 ? hall_step[2:1] == 2'd0 : legs_uh),
      .legs_ul_i(both_77 ? sum_185[2:1] == 2'd0 : legs_ul),
      .legs_vh_i(both_77 ? $signed(hall_step) > 3'sd1 : legs_vh),
      .legs_vl_i(both_77 ? hall_step == 3'd0 || hall_step == 3'd5 : legs_vl),
      .legs_wh_i(both_77 ? hall_step[2] && !hall_step[1] : legs_wh),
      .legs_wl_i(both_77 ? sum_185_2[2:1] == 2'd0 : legs_wl),
      .chop_i(limit_on),
      .complementary_i(words_pwm_complementary_i),
      .uh_o(commutation_uh),
      .ul_o(commutation_ul),
      .vh_o(commutation_vh),
      .vl_o(commutation_vl),
      .wh_o(commutation_wh),
      .wl_o(commutation_wl)
  );

  wire protection_lost;
  wire protection_fatal;
  wire [3:0] protection_reason;
  wire protection_freewheel_long;
  protection protection (
      .clk(clk),
      .rst(rst),
      .running_i(start_running),
      .tick_i(tick),
      .commutate_i(divided_commutate || divided_elapsed),
      .update_i(detector_update),
      .good_i(detector_good),
      .missed_i(detector_missed),
      .lags_i(detector_error[15]),
      .slow_i(filter_slow),
      .slips_i(speed_slips),
      .freewheel_i(both_77 ? 16'd0 : bemf_freewheel),
      .stuck_i(limit_stuck),
      .fault_pin_i(synchroniser_fault),
      .hall_i(both_77),
      .hall_illegal_i(!hall_legal),
      .words_misses_i(words_protection_misses_i),
      .words_stall_i(words_protection_stall_i),
      .words_slip_i(words_protection_slip_i),
      .words_freewheel_i(words_protection_freewheel_i),
      .words_wrong_lock_i(words_protection_wrong_lock_i),
      .words_over_current_i(words_protection_over_current_i),
      .lost_o(protection_lost),
      .fatal_o(protection_fatal),
      .reason_o(protection_reason),
      .freewheel_long_o(protection_freewheel_long)
  );

  wire guard_uh;
  wire guard_ul;
  wire guard_vh;
  wire guard_vl;
  wire guard_wh;
  wire guard_wl;
  gate_guard guard (
      .clk(clk),
      .rst(rst),
      .request_uh_i(commutation_uh),
      .request_ul_i(commutation_ul),
      .request_vh_i(commutation_vh),
      .request_vl_i(commutation_vl),
      .request_wh_i(commutation_wh),
      .request_wl_i(commutation_wl),
      .enable_i(start_enable && both),
      .fault_i(synchroniser_fault),
      .dead_time_i(words_pwm_dead_time_i),
      .minimum_i((words_pwm_minimum_i[13:8] == 6'd0) ? words_pwm_minimum_i[7:0] : 8'd255),
      .uh_o(guard_uh),
      .ul_o(guard_ul),
      .vh_o(guard_vh),
      .vl_o(guard_vl),
      .wh_o(guard_wh),
      .wl_o(guard_wl)
  );

  wire [15:0] telemetry_crossings;
  wire [15:0] telemetry_missed;
  wire [15:0] telemetry_freewheel_long;
  wire [15:0] telemetry_limit_hits;
  wire [15:0] telemetry_retries;
  telemetry #(.COUNTS(WITH_TELEMETRY)) telemetry (
      .clk(clk),
      .rst(rst),
      .clear_i(start_began),
      .crossing_i(bemf_crossing),
      .missed_i(detector_missed),
      .freewheel_long_i(protection_freewheel_long),
      .limit_hit_i(limit_hit),
      .retry_i(start_failed),
      .crossings_o(telemetry_crossings),
      .missed_o(telemetry_missed),
      .freewheel_long_o(telemetry_freewheel_long),
      .limit_hits_o(telemetry_limit_hits),
      .retries_o(telemetry_retries)
  );

  wire [2:0] divide_step;
  wire [15:0] divide_phase;
  wire divide_commutate;
  wire divide_elapsed;
  wire [2:0] divide_turned;
  divide_by_n divide (
      .clk(clk),
      .rst(rst),
      .pulse_i(vco_pulse),
      .phase_i(vco_phase),
      .divide_i(words_loop_divide_i),
      .reverse_i(start_reverse),
      .hold_i(both_103),
      .load_i(either_150),
      .step_i(start_load_step ? start_step : hall_step),
      .half_i(start_load_step),
      .step_o(divide_step),
      .phase_o(divide_phase),
      .commutate_o(divide_commutate),
      .elapsed_o(divide_elapsed),
      .turned_o(divide_turned)
  );

  wire [2:0] choice_165 = start_load_step ? start_step : divide_turned;  // line 165
  wire [2:0] sum_165 = choice_165 - 3'd3;  // line 165
  wire [2:0] sum_165_2 = choice_165 - 3'd1;  // line 165

  always_ff @(posedge clk) begin
    tick <= pwm_tick;
    chop <= limit_on;
    limited <= limit_hit;
    divided_step <= divide_step;
    divided_phase <= divide_phase;
    divided_commutate <= divide_commutate;
    divided_elapsed <= divide_elapsed;
    legs_uh <= choice_165[2:1] == 2'd0;  // line 165
    legs_ul <= sum_165[2:1] == 2'd0;  // line 165
    legs_vh <= $signed(choice_165) > 3'sd1;  // line 165
    legs_vl <= choice_165 == 3'd0 || choice_165 == 3'd5;  // line 165
    legs_wh <= choice_165[2] && !choice_165[1];  // line 165
    legs_wl <= sum_165_2[2:1] == 2'd0;  // line 165
    fast <= filter_fast;
    update <= detector_update;
    good <= detector_good;
    lags <= detector_error[15];  // line 200
    hurries <= detector_hurries;
    lost <= protection_lost;
    fatal <= protection_fatal;
    cause <= protection_reason;
    if (rst) begin
      tick <= 1'b0;
      chop <= 1'b0;
      limited <= 1'b0;
      divided_step <= 3'd0;
      divided_phase <= 16'd0;
      divided_commutate <= 1'b0;
      divided_elapsed <= 1'b0;
      legs_uh <= 1'b0;
      legs_ul <= 1'b0;
      legs_vh <= 1'b0;
      legs_vl <= 1'b0;
      legs_wh <= 1'b0;
      legs_wl <= 1'b0;
      fast <= 1'b0;
      update <= 1'b0;
      good <= 1'b0;
      lags <= 1'b0;
      hurries <= 1'b0;
      lost <= 1'b0;
      fatal <= 1'b0;
      cause <= Reason_kNone;
    end
  end

  assign gates_uh_o = guard_uh;
  assign gates_ul_o = guard_ul;
  assign gates_vh_o = guard_vh;
  assign gates_vl_o = guard_vl;
  assign gates_wh_o = guard_wh;
  assign gates_wl_o = guard_wl;
  assign state_o = start_state;
  assign reason_o = start_reason;
  assign locked_o = start_running;
  assign reverse_o = start_reverse;
  assign step_o = step;
  assign chop_o = limit_on;
  assign commutate_o = divided_commutate;
  assign turn_o = divided_step < 3'd3;
  assign frequency_o = filter_frequency;
  assign step_phase_o = divided_phase;
  assign phase_error_o = detector_error;
  assign update_o = detector_update;
  assign crossing_o = bemf_crossing;
  assign missed_o = detector_missed;
  assign crossing_phase_o = bemf_crossing_phase;
  assign freewheel_o = bemf_freewheel;
  assign duty_o = speed_duty;
  assign counts_crossings_o = telemetry_crossings;
  assign counts_missed_o = telemetry_missed;
  assign counts_freewheel_long_o = telemetry_freewheel_long;
  assign counts_limit_hits_o = telemetry_limit_hits;
  assign counts_retries_o = telemetry_retries;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, sum_185[0], sum_185_2[0], sum_165[0], sum_165_2[0]};
endmodule
