// word_registers: steplock::WordRegisters<steplock::SixStep>, printed by hlsgen from hls/bus/word_registers.hpp:73.
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
    input  logic        boundary_i,  // strobe: shadowed words are taken over
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
    output logic [31:0] data_o,  // answer to the last read: 0 if it was of no register kept here
    output logic        hole_o,  // no register stands there
    output logic        refused_o,  // the map does not allow this write
    output logic        unlocked_o,  // the lock is open
    output logic        no_period_o  // with this PWM period the bridge has to stay off
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
  logic written_0;  // since the reset
  logic written_1;  // since the reset
  logic written_2;  // since the reset
  logic written_3;  // since the reset
  logic written_4;  // since the reset
  logic written_5;  // since the reset
  logic written_6;  // since the reset
  logic written_7;  // since the reset
  logic written_8;  // since the reset
  logic written_9;  // since the reset
  logic written_10;  // since the reset
  logic written_11;  // since the reset
  logic written_12;  // since the reset
  logic written_13;  // since the reset
  logic written_14;  // since the reset
  logic written_15;  // since the reset
  logic written_16;  // since the reset
  logic written_17;  // since the reset
  logic written_18;  // since the reset
  logic written_19;  // since the reset
  logic written_20;  // since the reset
  logic written_21;  // since the reset
  logic written_22;  // since the reset
  logic written_23;  // since the reset
  logic written_24;  // since the reset
  logic written_25;  // since the reset
  logic written_26;  // since the reset
  logic written_27;  // since the reset
  logic shows;  // the last read was of the map

  wire [5:0] part_195 = request_index_i[5:0];  // line 195
  wire [4:0] part_189 = request_index_i[4:0];  // line 189
  wire choice_189 =  // line 189
      request_index_i[2] ?
      (request_index_i[1] ? (request_index_i[0] ? written_15 : written_14) :
      request_index_i[0] ? written_13 :
      written_12) :
      request_index_i[1] ? (request_index_i[0] ? written_11 : written_10) :
      request_index_i[0] ? written_9 :
      written_8;
  wire choice_189_2 =  // line 189
      request_index_i[1] ? (request_index_i[0] ? written_27 : written_26) :
      request_index_i[0] ? written_25 :
      written_24;
  wire choice_189_3 =  // line 189
      request_index_i[3] ? !request_index_i[2] && choice_189_2 :
      request_index_i[2] ?
      (request_index_i[1] ? (request_index_i[0] ? written_23 : written_22) :
      request_index_i[0] ? written_21 :
      written_20) :
      request_index_i[1] ? (request_index_i[0] ? written_19 : written_18) :
      request_index_i[0] ? written_17 :
      written_16;
  wire choice_189_4 =  // line 189
      request_index_i[4] ? choice_189_3 :
      request_index_i[3] ? choice_189 :
      request_index_i[2] ?
      (request_index_i[1] ? (request_index_i[0] ? written_7 : written_6) :
      request_index_i[0] ? written_5 :
      written_4) :
      request_index_i[1] ? (request_index_i[0] ? written_3 : written_2) :
      request_index_i[0] ? written_1 :
      written_0;
  wire both_99 = request_index_i[5] && choice_189_4;  // line 99

  logic [2:0] entry_143;  // kRules
  always_comb begin
    case (part_195)
      6'd0, 6'd1, 6'd2, 6'd4, 6'd12, 6'd13, 6'd14, 6'd15, 6'd16: entry_143 = 3'd1;
      6'd3, 6'd5, 6'd6, 6'd7, 6'd8, 6'd10, 6'd11, 6'd37, 6'd38, 6'd39, 6'd40, 6'd41, 6'd42,
      6'd51, 6'd52, 6'd53, 6'd54, 6'd55, 6'd56: entry_143 =
          3'd2;
      6'd9, 6'd33, 6'd34, 6'd57, 6'd58, 6'd59: entry_143 = 3'd4;
      6'd32, 6'd35, 6'd36, 6'd43, 6'd44, 6'd45, 6'd46, 6'd47, 6'd48, 6'd49, 6'd50: entry_143 = 3'd3;
      default: entry_143 = 3'd0;
    endcase
  end

  wire both = request_index_i[9:6] == 4'd0 && entry_143 == 3'd4 && stopped_i && unlocked;
  wire choice = (request_index_i[9:6] == 4'd0 && entry_143 == 3'd3) ? stopped_i : both;
  wire either = (request_index_i[9:6] == 4'd0 && entry_143 == 3'd2) || choice;
  wire both_97 = request_write_i && either;  // line 97
  wire [3:0] lanes = both_99 ? request_strobes_i : 4'd15;  // line 192
  wire [8:0] either_190 =  // line 190
      {1'b0, {8{request_strobes_i[0]}}} | (request_strobes_i[1] ? 9'd256 : 9'd0);
  wire [16:0] either_190_2 =  // line 190
      {1'b0, {7{either_190[8]}}, either_190} | (request_strobes_i[2] ? 17'd65536 : 17'd0);
  wire [24:0] mask =  // line 190
      {1'b0, {7{either_190_2[16]}}, either_190_2} | (request_strobes_i[3] ? 25'd16777216 : 25'd0);
  wire [31:0] mask_2 = {{7{mask[24]}}, mask};  // line 190
  wire [31:0] key = request_data_i & mask_2;  // line 191

  logic [28:0] entry_191;
  logic [30:0] entry_198;
  always_comb begin
    case (part_189)
      5'd0: begin
        entry_191 = 29'd520306687;
        entry_198 = 31'd16777216;
      end
      5'd1: begin
        entry_191 = 29'd16728063;
        entry_198 = 31'd0;
      end
      5'd2: begin
        entry_191 = 29'd268370175;
        entry_198 = 31'd0;
      end
      5'd3: begin
        entry_191 = 29'd268386291;
        entry_198 = 31'd16842754;
      end
      5'd4: begin
        entry_191 = 29'd67047199;
        entry_198 = 31'd3;
      end
      5'd5: begin
        entry_191 = 29'd536870911;
        entry_198 = 31'd1073774592;
      end
      5'd6, 5'd12, 5'd21, 5'd22, 5'd23, 5'd26: begin
        entry_191 = 29'd536870911;
        entry_198 = 31'd0;
      end
      5'd7: begin
        entry_191 = 29'd65535;
        entry_198 = 31'd32768;
      end
      5'd8, 5'd9, 5'd10, 5'd14, 5'd19, 5'd25: begin
        entry_191 = 29'd67108863;
        entry_198 = 31'd0;
      end
      5'd11, 5'd16, 5'd17: begin
        entry_191 = 29'd268374015;
        entry_198 = 31'd0;
      end
      5'd13, 5'd20: begin
        entry_191 = 29'd1048575;
        entry_198 = 31'd0;
      end
      5'd15: begin
        entry_191 = 29'd255852543;
        entry_198 = 31'd0;
      end
      5'd18: begin
        entry_191 = 29'd536809471;
        entry_198 = 31'd0;
      end
      5'd24: begin
        entry_191 = 29'd4095;
        entry_198 = 31'd0;
      end
      5'd27: begin
        entry_191 = 29'd252706623;
        entry_198 = 31'd0;
      end
      default: begin
        entry_191 = 29'd0;
        entry_198 = 31'd0;
      end
    endcase
  end

  wire [31:0] data = key & {{3{entry_191[28]}}, entry_191};  // line 191
  wire [24:0] inverse_198 = ~mask;  // line 198

  wire [31:0] mirror_data;
  word_mirror mirror (
      .clk(clk),
      .rst(rst),
      .read_i(request_read_i),
      .address_i({1'b0, part_195} | (both_99 ? 7'd0 : 7'd64)),
      .write_i(both_97 ? lanes : 4'd0),
      .write_address_i({1'b0, part_195}),
      .write_data_i(data | {1'b0, entry_198 & {{6{inverse_198[24]}}, inverse_198}}),
      .data_o(mirror_data)
  );

  always_ff @(posedge clk) begin
    if (both_97) begin
      logic [11:0] wide_181;
      logic [3:0] wide_181_2;
      logic [15:0] wide_181_3;
      logic [25:0] wide_178;
      logic either_2;
      logic either_3;
      logic either_4;
      wide_181 = {{3{inverse_198[24]}}, inverse_198[24:16]};  // line 181
      wide_181_2 = {4{inverse_198[24]}};  // line 181
      wide_181_3 = {{7{inverse_198[24]}}, inverse_198[24:16]};  // line 181
      wide_178 = {inverse_198[24], inverse_198};  // line 178
      either_2 =
          request_index_i == 10'd47 || request_index_i == 10'd48 || request_index_i == 10'd49;
      either_3 =
          either_2 || request_index_i == 10'd50 || request_index_i == 10'd51 ||
          request_index_i == 10'd52;
      either_4 =
          either_3 || request_index_i == 10'd53 || request_index_i == 10'd54 ||
          request_index_i == 10'd55;
      if (request_index_i == 10'd32) begin
        words_pwm_period <= key[13:0] | (words_pwm_period & inverse_198[13:0]);
        words_pwm_centred <= key[16] || (words_pwm_centred && inverse_198[16]);
        words_pwm_complementary <= key[17] || (words_pwm_complementary && inverse_198[17]);
        words_pwm_tick_periods <= key[31:24] | (words_pwm_tick_periods & {8{inverse_198[24]}});
      end
      if (request_index_i == 10'd33) begin
        words_pwm_minimum <= key[13:0] | (words_pwm_minimum & inverse_198[13:0]);
        words_pwm_dead_time <= key[23:16] | (words_pwm_dead_time & inverse_198[23:16]);
      end
      if (request_index_i == 10'd34) begin
        words_limit_blanking <= key[7:0] | (words_limit_blanking & inverse_198[7:0]);
        words_limit_off_time <= key[27:16] | (words_limit_off_time & wide_181);
      end
      if (request_index_i == 10'd35) begin
        words_bemf_sampling <= key[1:0] | (words_bemf_sampling & inverse_198[1:0]);
        words_bemf_blanking <= key[13:4] | (words_bemf_blanking & inverse_198[13:4]);
        words_bemf_sample_every <= key[23:16] | (words_bemf_sample_every & inverse_198[23:16]);
        words_bemf_samples <= key[27:24] | (words_bemf_samples & wide_181_2);
      end
      if (request_index_i == 10'd36) begin
        words_loop_detector <= key[0] || (words_loop_detector && inverse_198[0]);
        words_loop_bandwidth <= key[1] || (words_loop_bandwidth && inverse_198[1]);
        words_loop_divide <= key[3:2] | (words_loop_divide & inverse_198[3:2]);
        words_loop_delay <= key[25:16] | (words_loop_delay & {inverse_198[24], inverse_198[24:16]});
        words_speed_shift <= key[11:8] | (words_speed_shift & inverse_198[11:8]);
        words_source <= key[4] || (words_source && inverse_198[4]);
      end
      if (request_index_i == 10'd37) begin
        words_loop_expected <= key[15:0] | (words_loop_expected & inverse_198[15:0]);
        words_loop_lead_error <= key[31:16] | (words_loop_lead_error & wide_181_3);
      end
      if (request_index_i == 10'd38) begin
        words_loop_ki <= key[15:0] | (words_loop_ki & inverse_198[15:0]);
        words_loop_kp <= key[31:16] | (words_loop_kp & wide_181_3);
      end
      if (request_index_i == 10'd39) begin
        words_loop_pole <= key[15:0] | (words_loop_pole & inverse_198[15:0]);
      end
      if (request_index_i == 10'd40) begin
        words_loop_scale <= key[25:0] | (words_loop_scale & wide_178);
      end
      if (request_index_i == 10'd41) begin
        words_loop_minimum <= key[25:0] | (words_loop_minimum & wide_178);
      end
      if (request_index_i == 10'd42) begin
        words_loop_maximum <= key[25:0] | (words_loop_maximum & wide_178);
      end
      if (request_index_i == 10'd43) begin
        words_start_settle <= key[11:0] | (words_start_settle & inverse_198[11:0]);
        words_start_reset <= key[27:16] | (words_start_reset & wide_181);
      end
      if (request_index_i == 10'd44) begin
        words_start_reset_duty <= key[15:0] | (words_start_reset_duty & inverse_198[15:0]);
        words_start_start_duty <= key[31:16] | (words_start_start_duty & wide_181_3);
      end
      if (request_index_i == 10'd45) begin
        words_start_ramp <= key[19:0] | (words_start_ramp & inverse_198[19:0]);
      end
      if (request_index_i == 10'd46) begin
        words_start_hand_over <= key[25:0] | (words_start_hand_over & wide_178);
      end
      if (either_4 || request_index_i == 10'd56) begin
        if (request_index_i == 10'd47) begin
          words_start_window <= key[15:0] | (words_start_window & inverse_198[15:0]);
          words_start_good_crossings <=
              key[21:16] | (words_start_good_crossings & inverse_198[21:16]);
          words_start_retries <= key[27:24] | (words_start_retries & wide_181_2);
        end
        if (request_index_i == 10'd48) begin
          words_start_pull_in <= key[11:0] | (words_start_pull_in & inverse_198[11:0]);
          words_start_rest <= key[27:16] | (words_start_rest & wide_181);
        end
        if (request_index_i == 10'd49) begin
          words_start_observe <= key[11:0] | (words_start_observe & inverse_198[11:0]);
          words_start_slow_down <= key[27:16] | (words_start_slow_down & wide_181);
        end
        if (request_index_i == 10'd50) begin
          words_start_brake <= key[11:0] | (words_start_brake & inverse_198[11:0]);
          words_start_brake_duty <= key[31:16] | (words_start_brake_duty & wide_181_3);
        end
        if (request_index_i == 10'd52) begin
          words_speed_slew <= key[19:0] | (words_speed_slew & inverse_198[19:0]);
        end
        if (request_index_i == 10'd53) begin
          words_speed_kp <= key[15:0] | (words_speed_kp & inverse_198[15:0]);
          words_speed_ki <= key[31:16] | (words_speed_ki & wide_181_3);
        end
        if (request_index_i == 10'd54) begin
          words_speed_bemf <= key[15:0] | (words_speed_bemf & inverse_198[15:0]);
          words_speed_loaded <= key[31:16] | (words_speed_loaded & wide_181_3);
        end
        if (request_index_i == 10'd55) begin
          words_speed_minimum <= key[15:0] | (words_speed_minimum & inverse_198[15:0]);
          words_speed_maximum <= key[31:16] | (words_speed_maximum & wide_181_3);
        end
        if (request_index_i == 10'd56) begin
          words_speed_duty_slew <= key[11:0] | (words_speed_duty_slew & inverse_198[11:0]);
        end
        if (request_index_i == 10'd51) begin
          staged_speed_target <= key[25:0] | (staged_speed_target & wide_178);
        end
      end else begin
        if (request_index_i == 10'd59) begin
          words_protection_misses <= key[5:0] | (words_protection_misses & inverse_198[5:0]);
          words_protection_wrong_lock <=
              key[19:8] | (words_protection_wrong_lock & inverse_198[19:8]);
          words_protection_over_current <=
              key[27:24] | (words_protection_over_current & wide_181_2);
        end
        if (request_index_i == 10'd57) begin
          words_protection_stall <= key[25:0] | (words_protection_stall & wide_178);
        end
        if (request_index_i == 10'd58) begin
          words_protection_slip <= key[15:0] | (words_protection_slip & inverse_198[15:0]);
          words_protection_freewheel <= key[31:16] | (words_protection_freewheel & wide_181_3);
        end
        if (request_index_i == 10'd8) begin
          unlocked <= key[15:0] == 16'd49374;
        end
        written_25 <= request_index_i == 10'd57 || written_25;
        written_26 <= request_index_i == 10'd58 || written_26;
        written_27 <= request_index_i == 10'd59 || written_27;
      end
      written_0 <= request_index_i == 10'd32 || written_0;
      written_1 <= request_index_i == 10'd33 || written_1;
      written_2 <= request_index_i == 10'd34 || written_2;
      written_3 <= request_index_i == 10'd35 || written_3;
      written_4 <= request_index_i == 10'd36 || written_4;
      written_5 <= request_index_i == 10'd37 || written_5;
      written_6 <= request_index_i == 10'd38 || written_6;
      written_7 <= request_index_i == 10'd39 || written_7;
      written_8 <= request_index_i == 10'd40 || written_8;
      written_9 <= request_index_i == 10'd41 || written_9;
      written_10 <= request_index_i == 10'd42 || written_10;
      written_11 <= request_index_i == 10'd43 || written_11;
      written_12 <= request_index_i == 10'd44 || written_12;
      written_13 <= request_index_i == 10'd45 || written_13;
      written_14 <= request_index_i == 10'd46 || written_14;
      written_15 <= request_index_i == 10'd47 || written_15;
      written_16 <= request_index_i == 10'd48 || written_16;
      written_17 <= request_index_i == 10'd49 || written_17;
      written_18 <= request_index_i == 10'd50 || written_18;
      written_19 <= request_index_i == 10'd51 || written_19;
      written_20 <= request_index_i == 10'd52 || written_20;
      written_21 <= request_index_i == 10'd53 || written_21;
      written_22 <= request_index_i == 10'd54 || written_22;
      written_23 <= request_index_i == 10'd55 || written_23;
      written_24 <= request_index_i == 10'd56 || written_24;
    end
    if (boundary_i || stopped_i) begin
      words_speed_target <= staged_speed_target;
    end
    if (request_read_i) begin
      shows <= request_index_i[9:6] == 4'd0;
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
      written_0 <= 1'b0;
      written_1 <= 1'b0;
      written_2 <= 1'b0;
      written_3 <= 1'b0;
      written_4 <= 1'b0;
      written_5 <= 1'b0;
      written_6 <= 1'b0;
      written_7 <= 1'b0;
      written_8 <= 1'b0;
      written_9 <= 1'b0;
      written_10 <= 1'b0;
      written_11 <= 1'b0;
      written_12 <= 1'b0;
      written_13 <= 1'b0;
      written_14 <= 1'b0;
      written_15 <= 1'b0;
      written_16 <= 1'b0;
      written_17 <= 1'b0;
      written_18 <= 1'b0;
      written_19 <= 1'b0;
      written_20 <= 1'b0;
      written_21 <= 1'b0;
      written_22 <= 1'b0;
      written_23 <= 1'b0;
      written_24 <= 1'b0;
      written_25 <= 1'b0;
      written_26 <= 1'b0;
      written_27 <= 1'b0;
      shows <= 1'b0;
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
  assign data_o = shows ? mirror_data : 32'd0;
  assign hole_o = request_index_i[9:6] != 4'd0 || entry_143 == 3'd0;
  assign refused_o = !either;
  assign unlocked_o = unlocked;
  assign no_period_o = words_pwm_period == 14'd0;
endmodule
