// word_registers: steplock::WordRegisters, printed by hlsgen from hls/bus/word_registers.hpp:22.
// Do not edit: change the C++ and print again.

module word_registers (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        request_write_i,
    input  logic        request_read_i,
    input  logic [9:0]  request_index_i,
    input  logic [31:0] request_data_i,
    input  logic [3:0]  request_strobes_i,  // bytes of `data` that count
    input  logic        stopped_i,  // stopped and keyed words may change
    input  logic        boundary_i,  // strobe: a PWM period begins
    output logic [13:0] words_pwm_period_o,  // clocks; 0 keeps the high sides off; taken at the period's start
    output logic [13:0] words_pwm_minimum_o,  // clocks; shorter on or off times become 0 % or 100 %
    output logic        words_pwm_centred_o,  // pulses centred in the period instead of at its start
    output logic        words_pwm_complementary_o,  // the chopped leg's low side conducts in the off-time
    output logic [7:0]  words_pwm_dead_time_o,  // clocks; the floor fixed at synthesis wins
    output logic [7:0]  words_pwm_tick_periods_o,  // PWM periods per tick; 0 counts as 1
    output logic [7:0]  words_limit_blanking_o,  // clocks after switch-on in which the comparator is not believed
    output logic [11:0] words_limit_off_time_o,  // clocks; 0 disables the current limit
    output logic [1:0]  words_bemf_sampling_o,
    output logic [9:0]  words_bemf_blanking_o,  // clocks after each edge of the chopped gate
    output logic [7:0]  words_bemf_sample_every_o,  // clocks between samples; 0 counts as 1
    output logic [3:0]  words_bemf_samples_o,  // of the filter, 1 to 15; 0 counts as 1
    output logic        words_loop_detector_o,
    output logic        words_loop_bandwidth_o,
    output logic [1:0]  words_loop_divide_o,  // N = 6 * 2^divide VCO turns per electrical turn
    output logic [15:0] words_loop_expected_o,  // u0.16: the crossing's place in the step; 1/2 + advance / 60 deg
    output logic [15:0] words_loop_lead_error_o,  // u0.16: error of a rotor that led and hides the level before
    output logic [9:0]  words_loop_delay_o,  // clocks from the crossing at the motor to the sample, taken back
    output logic [15:0] words_loop_ki_o,  // u2.14
    output logic [15:0] words_loop_kp_o,  // u2.14
    output logic [15:0] words_loop_pole_o,  // u1.15: 1 - exp(-omega_p T); 0x8000 is no pole; last bit unused
    output logic [25:0] words_loop_scale_o,  // u0.32: for the frequency, per second; last four bits unused
    output logic [25:0] words_loop_minimum_o,  // limits of the integrator and of the output
    output logic [25:0] words_loop_maximum_o,
    output logic [11:0] words_start_settle_o,  // first pattern, so that a rotor opposite to the reset place moves
    output logic [11:0] words_start_reset_o,  // reset pattern: t_r of Eq. (22)
    output logic [15:0] words_start_reset_duty_o,  // twice that from the third try on, and so start_duty
    output logic [15:0] words_start_start_duty_o,  // during acceleration and pull-in
    output logic [19:0] words_start_ramp_o,  // u0.32 per tick: the VCO's acceleration; a quarter after each failed try
    output logic [25:0] words_start_hand_over_o,  // f_a: the end of the ramp
    output logic [15:0] words_start_window_o,  // u0.16: a crossing closer than this to its place is a good one
    output logic [5:0]  words_start_good_crossings_o,  // in a row, for lock (and for catching)
    output logic [11:0] words_start_pull_in_o,  // time limit from hand-over to lock
    output logic [11:0] words_start_observe_o,  // time to look for a rotor that already spins; 0 skips it
    output logic [11:0] words_start_slow_down_o,  // time limit for slowing to hand-over speed before a reversal
    output logic [11:0] words_start_brake_o,  // one braking interval, between two looks
    output logic [15:0] words_start_brake_duty_o,
    output logic [11:0] words_start_rest_o,  // gates off between a failure and the next try
    output logic [3:0]  words_start_retries_o,  // failed tries before the fault latches
    output logic [25:0] words_speed_target_o,  // u0.32
    output logic [19:0] words_speed_slew_o,  // u0.32 per tick
    output logic [3:0]  words_speed_shift_o,  // speeds are normalised: frequency >> shift fits 15 bits
    output logic [15:0] words_speed_kp_o,  // u4.12: duty per normalised speed error (s1.15 against u1.15)
    output logic [15:0] words_speed_ki_o,  // u0.16 per tick
    output logic [15:0] words_speed_bemf_o,  // u4.12: duty of mean voltage equal to the back-EMF, per speed
    output logic [15:0] words_speed_loaded_o,  // u4.12: the same, and of commutating the largest current
    output logic [15:0] words_speed_minimum_o,
    output logic [15:0] words_speed_maximum_o,
    output logic [11:0] words_speed_duty_slew_o,  // u1.15 per tick
    output logic [5:0]  words_protection_misses_o,  // lost lock: score of missed (4), hidden or far (1), good (-1) crossings; 0: off
    output logic [25:0] words_protection_stall_o,  // u0.32: slower than this in speed control is a stall
    output logic [15:0] words_protection_slip_o,  // duty above the back-EMF's that no right lock shows
    output logic [15:0] words_protection_freewheel_o,  // u0.16: freewheeling for longer than this part of a step is wrong
    output logic [11:0] words_protection_wrong_lock_o,  // a wrong tick takes two of them; 0 disables the test
    output logic [3:0]  words_protection_over_current_o,  // limit hits with the comparator never released; 0 disables
    output logic        words_source_o,
    output logic [31:0] data_o,  // the word register at `request.index`; 0 for all others
    output logic        hole_o,  // no register stands there
    output logic        refused_o,  // the map does not allow this write
    output logic        unlocked_o  // the lock is open
);
  localparam logic [1:0] Sampling_kBoth = 2'd2;
  localparam logic Detector_kEveryStep = 1'b1;
  localparam logic Bandwidth_kPerStep = 1'b1;
  localparam logic Source_kBemf = 1'b0;

  logic [13:0] words_pwm_period;  // clocks; 0 keeps the high sides off; taken at the period's start
  logic [13:0] words_pwm_minimum;  // clocks; shorter on or off times become 0 % or 100 %
  logic words_pwm_centred;  // pulses centred in the period instead of at its start
  logic words_pwm_complementary;  // the chopped leg's low side conducts in the off-time
  logic [7:0] words_pwm_dead_time;  // clocks; the floor fixed at synthesis wins
  logic [7:0] words_pwm_tick_periods;  // PWM periods per tick; 0 counts as 1
  logic [7:0] words_limit_blanking;  // clocks after switch-on in which the comparator is not believed
  logic [11:0] words_limit_off_time;  // clocks; 0 disables the current limit
  logic [1:0] words_bemf_sampling;
  logic [9:0] words_bemf_blanking;  // clocks after each edge of the chopped gate
  logic [7:0] words_bemf_sample_every;  // clocks between samples; 0 counts as 1
  logic [3:0] words_bemf_samples;  // of the filter, 1 to 15; 0 counts as 1
  logic words_loop_detector;
  logic words_loop_bandwidth;
  logic [1:0] words_loop_divide;  // N = 6 * 2^divide VCO turns per electrical turn
  logic [15:0] words_loop_expected;  // u0.16: the crossing's place in the step; 1/2 + advance / 60 deg
  logic [15:0] words_loop_lead_error;  // u0.16: error of a rotor that led and hides the level before
  logic [9:0] words_loop_delay;  // clocks from the crossing at the motor to the sample, taken back
  logic [15:0] words_loop_ki;  // u2.14
  logic [15:0] words_loop_kp;  // u2.14
  logic [15:0] words_loop_pole;  // u1.15: 1 - exp(-omega_p T); 0x8000 is no pole; last bit unused
  logic [25:0] words_loop_scale;  // u0.32: for the frequency, per second; last four bits unused
  logic [25:0] words_loop_minimum;  // limits of the integrator and of the output
  logic [25:0] words_loop_maximum;
  logic [11:0] words_start_settle;  // first pattern, so that a rotor opposite to the reset place moves
  logic [11:0] words_start_reset;  // reset pattern: t_r of Eq. (22)
  logic [15:0] words_start_reset_duty;  // twice that from the third try on, and so start_duty
  logic [15:0] words_start_start_duty;  // during acceleration and pull-in
  logic [19:0] words_start_ramp;  // u0.32 per tick: the VCO's acceleration; a quarter after each failed try
  logic [25:0] words_start_hand_over;  // f_a: the end of the ramp
  logic [15:0] words_start_window;  // u0.16: a crossing closer than this to its place is a good one
  logic [5:0] words_start_good_crossings;  // in a row, for lock (and for catching)
  logic [11:0] words_start_pull_in;  // time limit from hand-over to lock
  logic [11:0] words_start_observe;  // time to look for a rotor that already spins; 0 skips it
  logic [11:0] words_start_slow_down;  // time limit for slowing to hand-over speed before a reversal
  logic [11:0] words_start_brake;  // one braking interval, between two looks
  logic [15:0] words_start_brake_duty;
  logic [11:0] words_start_rest;  // gates off between a failure and the next try
  logic [3:0] words_start_retries;  // failed tries before the fault latches
  logic [25:0] words_speed_target;  // u0.32
  logic [19:0] words_speed_slew;  // u0.32 per tick
  logic [3:0] words_speed_shift;  // speeds are normalised: frequency >> shift fits 15 bits
  logic [15:0] words_speed_kp;  // u4.12: duty per normalised speed error (s1.15 against u1.15)
  logic [15:0] words_speed_ki;  // u0.16 per tick
  logic [15:0] words_speed_bemf;  // u4.12: duty of mean voltage equal to the back-EMF, per speed
  logic [15:0] words_speed_loaded;  // u4.12: the same, and of commutating the largest current
  logic [15:0] words_speed_minimum;
  logic [15:0] words_speed_maximum;
  logic [11:0] words_speed_duty_slew;  // u1.15 per tick
  logic [5:0] words_protection_misses;  // lost lock: score of missed (4), hidden or far (1), good (-1) crossings; 0: off
  logic [25:0] words_protection_stall;  // u0.32: slower than this in speed control is a stall
  logic [15:0] words_protection_slip;  // duty above the back-EMF's that no right lock shows
  logic [15:0] words_protection_freewheel;  // u0.16: freewheeling for longer than this part of a step is wrong
  logic [11:0] words_protection_wrong_lock;  // a wrong tick takes two of them; 0 disables the test
  logic [3:0] words_protection_over_current;  // limit hits with the comparator never released; 0 disables
  logic words_source;
  logic [25:0] staged_speed_target;  // u0.32
  logic unlocked;

  wire [5:0] index = request_index_i[5:0];  // line 84
  wire [31:0] rest = {words_pwm_tick_periods, 24'd0};  // line 110
  wire [17:0] choice_110 = words_pwm_complementary ? 18'd131072 : 18'd0;  // line 110
  wire [31:0] rest_2 = rest | {14'd0, choice_110};  // line 127
  wire [16:0] choice_110_2 = words_pwm_centred ? 17'd65536 : 17'd0;  // line 110
  wire [31:0] rest_3 = rest_2 | {15'd0, choice_110_2};  // line 127
  wire [31:0] low = rest_3 | {18'd0, words_pwm_period};  // line 127
  wire [23:0] rest_4 = {words_pwm_dead_time, 16'd0} | {10'd0, words_pwm_minimum};  // line 127
  wire [31:0] low_2 = request_index_i[0] ? {8'd0, rest_4} : low;  // line 139
  wire [27:0] rest_5 = {words_limit_off_time, 16'd0} | {20'd0, words_limit_blanking};  // line 127
  wire [27:0] rest_6 = {words_bemf_samples, 24'd0} | {4'd0, words_bemf_sample_every, 16'd0};
  wire [27:0] rest_7 = rest_6 | {14'd0, words_bemf_blanking, 4'd0};  // line 127
  wire [27:0] rest_8 = rest_7 | {26'd0, words_bemf_sampling};  // line 127
  wire [27:0] high = request_index_i[0] ? rest_8 : rest_5;  // line 139
  wire [31:0] low_3 = request_index_i[1] ? {4'd0, high} : low_2;  // line 139
  wire [25:0] rest_9 = {words_loop_delay, 16'd0} | {14'd0, words_speed_shift, 8'd0};  // line 127
  wire [4:0] choice_110_3 = words_source ? 5'd16 : 5'd0;  // line 110
  wire [25:0] rest_10 = rest_9 | {21'd0, choice_110_3};  // line 127
  wire [25:0] rest_11 = rest_10 | {22'd0, words_loop_divide, 2'd0};  // line 127
  wire [1:0] choice_110_4 = words_loop_bandwidth ? 2'd2 : 2'd0;  // line 110
  wire [25:0] rest_12 = rest_11 | {24'd0, choice_110_4};  // line 127
  wire [25:0] rest_13 = rest_12 | {25'd0, words_loop_detector};  // line 127
  wire [31:0] rest_14 = {words_loop_lead_error, 16'd0};  // line 110
  wire [31:0] rest_15 = rest_14 | {16'd0, words_loop_expected};  // line 127
  wire [31:0] low_4 = request_index_i[0] ? rest_15 : {6'd0, rest_13};  // line 139
  wire [31:0] rest_16 = {words_loop_kp, 16'd0};  // line 110
  wire [31:0] rest_17 = rest_16 | {16'd0, words_loop_ki};  // line 127
  wire [31:0] high_2 = request_index_i[0] ? {16'd0, words_loop_pole} : rest_17;  // line 139
  wire [31:0] high_3 = request_index_i[1] ? high_2 : low_4;  // line 139
  wire [31:0] low_5 = request_index_i[2] ? high_3 : low_3;  // line 139
  wire [25:0] low_6 = request_index_i[0] ? words_loop_minimum : words_loop_scale;  // line 139
  wire [27:0] rest_18 = {words_start_reset, 16'd0} | {16'd0, words_start_settle};  // line 127
  wire [27:0] high_4 = request_index_i[0] ? rest_18 : {2'd0, words_loop_maximum};  // line 139
  wire [27:0] low_7 = request_index_i[1] ? high_4 : {2'd0, low_6};  // line 139
  wire [31:0] rest_19 = {words_start_start_duty, 16'd0};  // line 110
  wire [31:0] rest_20 = rest_19 | {16'd0, words_start_reset_duty};  // line 127
  wire [31:0] low_8 = request_index_i[0] ? {12'd0, words_start_ramp} : rest_20;  // line 139
  wire [27:0] rest_21 = {words_start_retries, 24'd0} | {6'd0, words_start_good_crossings, 16'd0};
  wire [27:0] rest_22 = rest_21 | {12'd0, words_start_window};  // line 127
  wire [27:0] high_5 = request_index_i[0] ? rest_22 : {2'd0, words_start_hand_over};  // line 139
  wire [31:0] high_6 = request_index_i[1] ? {4'd0, high_5} : low_8;  // line 139
  wire [31:0] high_7 = request_index_i[2] ? high_6 : {4'd0, low_7};  // line 139
  wire [31:0] low_9 = request_index_i[3] ? high_7 : low_5;  // line 139
  wire [27:0] rest_23 = {words_start_rest, 16'd0} | {16'd0, words_start_pull_in};  // line 127
  wire [27:0] rest_24 = {words_start_slow_down, 16'd0} | {16'd0, words_start_observe};  // line 127
  wire [27:0] low_10 = request_index_i[0] ? rest_24 : rest_23;  // line 139
  wire [31:0] rest_25 = {words_start_brake_duty, 16'd0};  // line 110
  wire [31:0] rest_26 = rest_25 | {20'd0, words_start_brake};  // line 127
  wire [31:0] high_8 = request_index_i[0] ? {6'd0, staged_speed_target} : rest_26;  // line 139
  wire [31:0] low_11 = request_index_i[1] ? high_8 : {4'd0, low_10};  // line 139
  wire [31:0] rest_27 = {words_speed_ki, 16'd0};  // line 110
  wire [31:0] rest_28 = rest_27 | {16'd0, words_speed_kp};  // line 127
  wire [31:0] low_12 = request_index_i[0] ? rest_28 : {12'd0, words_speed_slew};  // line 139
  wire [31:0] rest_29 = {words_speed_loaded, 16'd0};  // line 110
  wire [31:0] rest_30 = rest_29 | {16'd0, words_speed_bemf};  // line 127
  wire [31:0] rest_31 = {words_speed_maximum, 16'd0};  // line 110
  wire [31:0] rest_32 = rest_31 | {16'd0, words_speed_minimum};  // line 127
  wire [31:0] high_9 = request_index_i[0] ? rest_32 : rest_30;  // line 139
  wire [31:0] high_10 = request_index_i[1] ? high_9 : low_12;  // line 139
  wire [31:0] low_13 = request_index_i[2] ? high_10 : low_11;  // line 139
  wire [25:0] low_14 = request_index_i[0] ? words_protection_stall : {14'd0, words_speed_duty_slew};
  wire [31:0] rest_33 = {words_protection_freewheel, 16'd0};  // line 110
  wire [31:0] rest_34 = rest_33 | {16'd0, words_protection_slip};  // line 127
  wire [27:0] rest_35 =  // line 127
      {words_protection_over_current, 24'd0} | {8'd0, words_protection_wrong_lock, 8'd0};
  wire [27:0] rest_36 = rest_35 | {22'd0, words_protection_misses};  // line 127
  wire [31:0] high_11 = request_index_i[0] ? {4'd0, rest_36} : rest_34;  // line 139
  wire [31:0] low_15 = request_index_i[1] ? high_11 : {6'd0, low_14};  // line 139
  wire [31:0] high_12 = request_index_i[2] ? 32'd0 : low_15;  // line 139
  wire [31:0] high_13 = request_index_i[3] ? high_12 : low_13;  // line 139
  wire [31:0] high_14 = request_index_i[4] ? high_13 : low_9;  // line 139

  logic [2:0] entry_84;  // kRules
  always_comb begin
    case (index)
      6'd0, 6'd1, 6'd2, 6'd4, 6'd12, 6'd13, 6'd14, 6'd15, 6'd16: entry_84 = 3'd1;
      6'd3, 6'd5, 6'd6, 6'd7, 6'd8, 6'd10, 6'd11, 6'd37, 6'd38, 6'd39, 6'd40, 6'd41, 6'd42,
      6'd51, 6'd52, 6'd53, 6'd54, 6'd55, 6'd56: entry_84 =
          3'd2;
      6'd9, 6'd33, 6'd34, 6'd57, 6'd58, 6'd59: entry_84 = 3'd4;
      6'd32, 6'd35, 6'd36, 6'd43, 6'd44, 6'd45, 6'd46, 6'd47, 6'd48, 6'd49, 6'd50: entry_84 = 3'd3;
      default: entry_84 = 3'd0;
    endcase
  end

  wire both = request_index_i[9:6] == 4'd0 && entry_84 == 3'd4 && stopped_i && unlocked;
  wire choice = (request_index_i[9:6] == 4'd0 && entry_84 == 3'd3) ? stopped_i : both;
  wire either = (request_index_i[9:6] == 4'd0 && entry_84 == 3'd2) || choice;
  wire [16:0] choice_50_2 = request_strobes_i[2] ? 17'd65536 : 17'd0;  // line 50
  wire [23:0] both_116_2 = request_data_i[23:0] & {{7{choice_50_2[16]}}, choice_50_2};  // line 116

  always_ff @(posedge clk) begin
    if (request_write_i && either) begin
      logic [7:0] wide_50;
      logic [8:0] choice_50;
      logic [8:0] either_50;
      logic [15:0] wide_50_2;
      logic [15:0] both_116;
      logic [8:0] inverse_116;
      logic [15:0] wide_116;
      logic [13:0] wide_116_2;
      logic [16:0] either_50_2;
      logic [16:0] inverse_116_2;
      logic [19:0] wide_116_3;
      logic [24:0] either_50_3;
      logic [24:0] inverse_116_3;
      logic [31:0] both_116_3;
      logic [7:0] both_116_4;
      logic inverse_116_4;
      logic [11:0] wide_119;
      logic [3:0] wide_119_2;
      logic [15:0] wide_119_3;
      logic [25:0] wide_116_4;
      logic [11:0] wide_116_5;
      logic [19:0] both_116_5;
      wide_50 = {8{request_strobes_i[0]}};  // line 50
      choice_50 = request_strobes_i[1] ? 9'd256 : 9'd0;  // line 50
      either_50 = {1'b0, wide_50} | choice_50;  // line 50
      wide_50_2 = {{7{either_50[8]}}, either_50};  // line 50
      both_116 = request_data_i[15:0] & wide_50_2;  // line 116
      inverse_116 = ~either_50;  // line 116
      wide_116 = {{7{inverse_116[8]}}, inverse_116};  // line 116
      wide_116_2 = {{5{inverse_116[8]}}, inverse_116};  // line 116
      either_50_2 = {1'b0, wide_50_2} | choice_50_2;  // line 50
      inverse_116_2 = ~either_50_2;  // line 116
      wide_116_3 = {{3{inverse_116_2[16]}}, inverse_116_2};  // line 116
      either_50_3 =  // line 50
          {1'b0, {7{either_50_2[16]}}, either_50_2} | (request_strobes_i[3] ? 25'd16777216 : 25'd0);
      inverse_116_3 = ~either_50_3;  // line 116
      both_116_3 = request_data_i & {{7{either_50_3[24]}}, either_50_3};  // line 116
      both_116_4 = request_data_i[7:0] & wide_50;  // line 116
      inverse_116_4 = !request_strobes_i[0];  // line 116
      wide_119 = {{3{inverse_116_3[24]}}, inverse_116_3[24:16]};  // line 119
      wide_119_2 = {4{inverse_116_3[24]}};  // line 119
      wide_119_3 = {{7{inverse_116_3[24]}}, inverse_116_3[24:16]};  // line 119
      wide_116_4 = {inverse_116_3[24], inverse_116_3};  // line 116
      wide_116_5 = {{3{inverse_116[8]}}, inverse_116};  // line 116
      both_116_5 = request_data_i[19:0] & {{3{either_50_2[16]}}, either_50_2};  // line 116
      if (request_index_i == 10'd32) begin
        words_pwm_period <= both_116[13:0] | (words_pwm_period & wide_116_2);
        words_pwm_centred <= both_116_2[16] || (choice_110_2[16] && inverse_116_2[16]);
        words_pwm_complementary <= both_116_2[17] || (choice_110[17] && inverse_116_2[16]);
        words_pwm_tick_periods <=
            both_116_3[31:24] | (words_pwm_tick_periods & {8{inverse_116_3[24]}});
      end
      if (request_index_i == 10'd33) begin
        words_pwm_minimum <= both_116[13:0] | (words_pwm_minimum & wide_116_2);
        words_pwm_dead_time <= both_116_2[23:16] | (words_pwm_dead_time & inverse_116_3[23:16]);
      end
      if (request_index_i == 10'd34) begin
        words_limit_blanking <= both_116_4 | (words_limit_blanking & {8{inverse_116_4}});
        words_limit_off_time <= both_116_3[27:16] | (words_limit_off_time & wide_119);
      end
      if (request_index_i == 10'd35) begin
        words_bemf_sampling <= both_116_4[1:0] | (words_bemf_sampling & {2{inverse_116_4}});
        words_bemf_blanking <= both_116[13:4] | (words_bemf_blanking & inverse_116_3[13:4]);
        words_bemf_sample_every <=
            both_116_2[23:16] | (words_bemf_sample_every & inverse_116_3[23:16]);
        words_bemf_samples <= both_116_3[27:24] | (words_bemf_samples & wide_119_2);
      end
      if (request_index_i == 10'd36) begin
        words_loop_detector <= both_116_4[0] || (words_loop_detector && inverse_116_4);
        words_loop_bandwidth <= both_116_4[1] || (choice_110_4[1] && inverse_116_4);
        words_loop_divide <= both_116_4[3:2] | (words_loop_divide & inverse_116_3[3:2]);
        words_loop_delay <=
            both_116_3[25:16] | (words_loop_delay & {inverse_116_3[24], inverse_116_3[24:16]});
        words_speed_shift <=
            (request_data_i[11:8] & {4{choice_50[8]}}) | (words_speed_shift & inverse_116_3[11:8]);
        words_source <= both_116_4[4] || (choice_110_3[4] && inverse_116_4);
      end
      if (request_index_i == 10'd37) begin
        words_loop_expected <= both_116 | (words_loop_expected & wide_116);
        words_loop_lead_error <= both_116_3[31:16] | (words_loop_lead_error & wide_119_3);
      end
      if (request_index_i == 10'd38) begin
        words_loop_ki <= both_116 | (words_loop_ki & wide_116);
        words_loop_kp <= both_116_3[31:16] | (words_loop_kp & wide_119_3);
      end
      if (request_index_i == 10'd39) begin
        words_loop_pole <= both_116 | (words_loop_pole & wide_116);
      end
      if (request_index_i == 10'd40) begin
        words_loop_scale <= both_116_3[25:0] | (words_loop_scale & wide_116_4);
      end
      if (request_index_i == 10'd41) begin
        words_loop_minimum <= both_116_3[25:0] | (words_loop_minimum & wide_116_4);
      end
      if (request_index_i == 10'd42) begin
        words_loop_maximum <= both_116_3[25:0] | (words_loop_maximum & wide_116_4);
      end
      if (request_index_i == 10'd43) begin
        words_start_settle <= both_116[11:0] | (words_start_settle & wide_116_5);
        words_start_reset <= both_116_3[27:16] | (words_start_reset & wide_119);
      end
      if (request_index_i == 10'd44) begin
        words_start_reset_duty <= both_116 | (words_start_reset_duty & wide_116);
        words_start_start_duty <= both_116_3[31:16] | (words_start_start_duty & wide_119_3);
      end
      if (request_index_i == 10'd45) begin
        words_start_ramp <= both_116_5 | (words_start_ramp & wide_116_3);
      end
      if (request_index_i == 10'd46) begin
        words_start_hand_over <= both_116_3[25:0] | (words_start_hand_over & wide_116_4);
      end
      if (request_index_i == 10'd47) begin
        words_start_window <= both_116 | (words_start_window & wide_116);
        words_start_good_crossings <=
            both_116_2[21:16] | (words_start_good_crossings & inverse_116_3[21:16]);
        words_start_retries <= both_116_3[27:24] | (words_start_retries & wide_119_2);
      end
      if (request_index_i == 10'd48) begin
        words_start_pull_in <= both_116[11:0] | (words_start_pull_in & wide_116_5);
        words_start_rest <= both_116_3[27:16] | (words_start_rest & wide_119);
      end
      if (request_index_i == 10'd49) begin
        words_start_observe <= both_116[11:0] | (words_start_observe & wide_116_5);
        words_start_slow_down <= both_116_3[27:16] | (words_start_slow_down & wide_119);
      end
      if (request_index_i == 10'd50) begin
        words_start_brake <= both_116[11:0] | (words_start_brake & wide_116_5);
        words_start_brake_duty <= both_116_3[31:16] | (words_start_brake_duty & wide_119_3);
      end
      if (request_index_i == 10'd52) begin
        words_speed_slew <= both_116_5 | (words_speed_slew & wide_116_3);
      end
      if (request_index_i == 10'd53) begin
        words_speed_kp <= both_116 | (words_speed_kp & wide_116);
        words_speed_ki <= both_116_3[31:16] | (words_speed_ki & wide_119_3);
      end
      if (request_index_i == 10'd54) begin
        words_speed_bemf <= both_116 | (words_speed_bemf & wide_116);
        words_speed_loaded <= both_116_3[31:16] | (words_speed_loaded & wide_119_3);
      end
      if (request_index_i == 10'd55) begin
        words_speed_minimum <= both_116 | (words_speed_minimum & wide_116);
        words_speed_maximum <= both_116_3[31:16] | (words_speed_maximum & wide_119_3);
      end
      if (request_index_i == 10'd56) begin
        words_speed_duty_slew <= both_116[11:0] | (words_speed_duty_slew & wide_116_5);
      end
      if (request_index_i == 10'd59) begin
        words_protection_misses <= both_116_4[5:0] | (words_protection_misses & {6{inverse_116_4}});
        words_protection_wrong_lock <=
            both_116_5[19:8] | (words_protection_wrong_lock & inverse_116_3[19:8]);
        words_protection_over_current <=
            both_116_3[27:24] | (words_protection_over_current & wide_119_2);
      end
      if (request_index_i == 10'd57) begin
        words_protection_stall <= both_116_3[25:0] | (words_protection_stall & wide_116_4);
      end
      if (request_index_i == 10'd58) begin
        words_protection_slip <= both_116 | (words_protection_slip & wide_116);
        words_protection_freewheel <= both_116_3[31:16] | (words_protection_freewheel & wide_119_3);
      end
      if (request_index_i == 10'd51) begin
        staged_speed_target <= both_116_3[25:0] | (staged_speed_target & wide_116_4);
      end
      if (request_index_i == 10'd8) begin
        unlocked <= both_116 == 16'd49374;
      end
    end
    if (boundary_i || stopped_i) begin
      words_speed_target <= staged_speed_target;
    end
    if (rst) begin
      words_pwm_period <= 14'd0;
      words_pwm_minimum <= 14'd0;
      words_pwm_centred <= 1'b0;
      words_pwm_complementary <= 1'b0;
      words_pwm_dead_time <= 8'd0;
      words_pwm_tick_periods <= 8'd1;
      words_limit_blanking <= 8'd0;
      words_limit_off_time <= 12'd0;
      words_bemf_sampling <= Sampling_kBoth;
      words_bemf_blanking <= 10'd0;
      words_bemf_sample_every <= 8'd1;
      words_bemf_samples <= 4'd1;
      words_loop_detector <= Detector_kEveryStep;
      words_loop_bandwidth <= Bandwidth_kPerStep;
      words_loop_divide <= 2'd0;
      words_loop_expected <= 16'd32768;
      words_loop_lead_error <= 16'd16384;
      words_loop_delay <= 10'd0;
      words_loop_ki <= 16'd0;
      words_loop_kp <= 16'd0;
      words_loop_pole <= 16'd32768;
      words_loop_scale <= 26'd0;
      words_loop_minimum <= 26'd0;
      words_loop_maximum <= 26'd0;
      words_start_settle <= 12'd0;
      words_start_reset <= 12'd0;
      words_start_reset_duty <= 16'd0;
      words_start_start_duty <= 16'd0;
      words_start_ramp <= 20'd0;
      words_start_hand_over <= 26'd0;
      words_start_window <= 16'd0;
      words_start_good_crossings <= 6'd0;
      words_start_pull_in <= 12'd0;
      words_start_observe <= 12'd0;
      words_start_slow_down <= 12'd0;
      words_start_brake <= 12'd0;
      words_start_brake_duty <= 16'd0;
      words_start_rest <= 12'd0;
      words_start_retries <= 4'd0;
      words_speed_target <= 26'd0;
      words_speed_slew <= 20'd0;
      words_speed_shift <= 4'd0;
      words_speed_kp <= 16'd0;
      words_speed_ki <= 16'd0;
      words_speed_bemf <= 16'd0;
      words_speed_loaded <= 16'd0;
      words_speed_minimum <= 16'd0;
      words_speed_maximum <= 16'd0;
      words_speed_duty_slew <= 12'd0;
      words_protection_misses <= 6'd0;
      words_protection_stall <= 26'd0;
      words_protection_slip <= 16'd0;
      words_protection_freewheel <= 16'd0;
      words_protection_wrong_lock <= 12'd0;
      words_protection_over_current <= 4'd0;
      words_source <= Source_kBemf;
      staged_speed_target <= 26'd0;
      unlocked <= 1'b0;
    end
  end

  assign words_pwm_period_o = words_pwm_period;
  assign words_pwm_minimum_o = words_pwm_minimum;
  assign words_pwm_centred_o = words_pwm_centred;
  assign words_pwm_complementary_o = words_pwm_complementary;
  assign words_pwm_dead_time_o = words_pwm_dead_time;
  assign words_pwm_tick_periods_o = words_pwm_tick_periods;
  assign words_limit_blanking_o = words_limit_blanking;
  assign words_limit_off_time_o = words_limit_off_time;
  assign words_bemf_sampling_o = words_bemf_sampling;
  assign words_bemf_blanking_o = words_bemf_blanking;
  assign words_bemf_sample_every_o = words_bemf_sample_every;
  assign words_bemf_samples_o = words_bemf_samples;
  assign words_loop_detector_o = words_loop_detector;
  assign words_loop_bandwidth_o = words_loop_bandwidth;
  assign words_loop_divide_o = words_loop_divide;
  assign words_loop_expected_o = words_loop_expected;
  assign words_loop_lead_error_o = words_loop_lead_error;
  assign words_loop_delay_o = words_loop_delay;
  assign words_loop_ki_o = words_loop_ki;
  assign words_loop_kp_o = words_loop_kp;
  assign words_loop_pole_o = words_loop_pole;
  assign words_loop_scale_o = words_loop_scale;
  assign words_loop_minimum_o = words_loop_minimum;
  assign words_loop_maximum_o = words_loop_maximum;
  assign words_start_settle_o = words_start_settle;
  assign words_start_reset_o = words_start_reset;
  assign words_start_reset_duty_o = words_start_reset_duty;
  assign words_start_start_duty_o = words_start_start_duty;
  assign words_start_ramp_o = words_start_ramp;
  assign words_start_hand_over_o = words_start_hand_over;
  assign words_start_window_o = words_start_window;
  assign words_start_good_crossings_o = words_start_good_crossings;
  assign words_start_pull_in_o = words_start_pull_in;
  assign words_start_observe_o = words_start_observe;
  assign words_start_slow_down_o = words_start_slow_down;
  assign words_start_brake_o = words_start_brake;
  assign words_start_brake_duty_o = words_start_brake_duty;
  assign words_start_rest_o = words_start_rest;
  assign words_start_retries_o = words_start_retries;
  assign words_speed_target_o = words_speed_target;
  assign words_speed_slew_o = words_speed_slew;
  assign words_speed_shift_o = words_speed_shift;
  assign words_speed_kp_o = words_speed_kp;
  assign words_speed_ki_o = words_speed_ki;
  assign words_speed_bemf_o = words_speed_bemf;
  assign words_speed_loaded_o = words_speed_loaded;
  assign words_speed_minimum_o = words_speed_minimum;
  assign words_speed_maximum_o = words_speed_maximum;
  assign words_speed_duty_slew_o = words_speed_duty_slew;
  assign words_protection_misses_o = words_protection_misses;
  assign words_protection_stall_o = words_protection_stall;
  assign words_protection_slip_o = words_protection_slip;
  assign words_protection_freewheel_o = words_protection_freewheel;
  assign words_protection_wrong_lock_o = words_protection_wrong_lock;
  assign words_protection_over_current_o = words_protection_over_current;
  assign words_source_o = words_source;
  assign data_o = request_index_i[5] ? high_14 : 32'd0;
  assign hole_o = request_index_i[9:6] != 4'd0 || entry_84 == 3'd0;
  assign refused_o = !either;
  assign unlocked_o = unlocked;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, request_read_i, both_116_2[15:0]};
endmodule
