// start_sequence: steplock::StartSequence, printed by hlsgen from hls/six_step/start_sequence.hpp:38.
// Do not edit: change the C++ and print again.

module start_sequence (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        tick_i,  // the slow time base
    input  logic        command_configured_i,  // the words are valid; until then all six gates are off
    input  logic        command_run_i,
    input  logic        command_reverse_i,
    input  logic        command_brake_to_stop_i,  // else coast
    input  logic        command_clear_fault_i,  // a rising edge re-arms, once `run` is low and the cause is gone
    input  logic        source_i,
    input  logic [11:0] words_settle_i,  // first pattern, so that a rotor opposite to the reset place moves
    input  logic [11:0] words_reset_i,  // reset pattern: t_r of Eq. (22)
    input  logic [15:0] words_reset_duty_i,  // twice that from the third try on, and so start_duty
    input  logic [15:0] words_start_duty_i,  // during acceleration and pull-in
    input  logic [19:0] words_ramp_i,  // u0.32 per tick: the VCO's acceleration; a quarter after each failed try
    input  logic [25:0] words_hand_over_i,  // f_a: the end of the ramp
    input  logic [15:0] words_window_i,  // u0.16: a crossing closer than this to its place is a good one
    input  logic [5:0]  words_good_crossings_i,  // in a row, for lock (and for catching)
    input  logic [11:0] words_pull_in_i,  // time limit from hand-over to lock
    input  logic [11:0] words_observe_i,  // time to look for a rotor that already spins; 0 skips it
    input  logic [11:0] words_slow_down_i,  // time limit for slowing to hand-over speed before a reversal
    input  logic [11:0] words_brake_i,  // one braking interval, between two looks
    input  logic [15:0] words_brake_duty_i,
    input  logic [11:0] words_rest_i,  // gates off between a failure and the next try
    input  logic [3:0]  words_retries_i,  // failed tries before the fault latches
    input  logic        fast_i,  // the VCO's frequency is hand_over or more
    input  logic        commutate_i,  // strobe: a new step began
    input  logic        update_i,  // strobe: the phase detector has a new error
    input  logic        good_i,  // with `update`: it is a small one
    input  logic        lags_i,  // the last error was negative: the rotor lags the VCO
    input  logic        turns_reverse_i,  // while observing: the code last moved downwards
    input  logic [2:0]  sector_i,  // while observing: 0 to 5
    input  logic        lost_i,  // protection: give up this try
    input  logic        fatal_i,  // protection: latch
    input  logic [3:0]  cause_i,  // protection: why
    output logic [3:0]  state_o,
    output logic [3:0]  reason_o,  // of the last failed try, or of the fault
    output logic        enable_o,  // the gate guard may turn gates on
    output logic [4:0]  pattern_bits_o,  // public, for a set to be a port
    output logic        reverse_o,  // direction of this try
    output logic        running_o,  // locked and under speed control
    output logic [1:0]  mode_o,
    output logic [15:0] duty_o,  // u1.15, for kFixed and kAboveBemf
    output logic        stop_o,  // speed control: towards standstill, not the set speed
    output logic [1:0]  watch_o,  // phase detector
    output logic [2:0]  loop_o,  // loop filter
    output logic        load_step_o,  // one clock: take `step`, in its middle
    output logic [2:0]  step_o,  // 0 to 5
    output logic        turn_vco_o,  // the VCO may count
    output logic [1:0]  gentle_o,  // loop filter: the ramp is quartered so often
    output logic        began_o,  // one clock: `run` was obeyed
    output logic        failed_o  // one clock: a try failed
);
  localparam logic [3:0] Reason_kNone = 4'd0;
  localparam logic [3:0] Reason_kNoLock = 4'd6;
  localparam logic [3:0] Reason_kCannotStop = 4'd7;
  localparam logic [1:0] SpeedMode_kFixed = 2'd0;
  localparam logic [1:0] SpeedMode_kAboveBemf = 2'd1;
  localparam logic [1:0] SpeedMode_kControl = 2'd2;
  localparam logic [1:0] Evidence_kNothing = 2'd0;
  localparam logic [1:0] Evidence_kCrossings = 2'd1;
  localparam logic [1:0] Evidence_kSectors = 2'd2;
  localparam logic [2:0] Loop_kStop = 3'd0;
  localparam logic [2:0] Loop_kRamp = 3'd1;
  localparam logic [2:0] Loop_kTrack = 3'd2;
  localparam logic [2:0] Loop_kCatch = 3'd3;
  localparam logic [2:0] Loop_kHall = 3'd4;

  logic [10:0] at_bits;  // public, for a set to be a port
  logic drives;  // one of the states in which the bridge commutates
  logic enables;  // or one of the others in which gates may be on
  logic boosts;  // one of those whose duty comes above the back-EMF's
  logic [15:0] duty;  // u1.15, of the state a clock ago; in kPullIn it fades
  logic entered;  // this is the first clock of the state
  logic late;  // there was a tick in it
  logic last;  // no ticks are left
  logic tried;  // no more tries are left
  logic braking;  // a braking interval begins
  logic braked;  // no more braking intervals are left
  logic [3:0] reason;
  logic [14:0] ticks;  // left in this state
  logic [5:0] good;  // good crossings in a row
  logic nearly;  // one more is enough
  logic enough;  // that one came in the last clock
  logic [3:0] retries;  // failed tries
  logic [7:0] brakes;  // braking intervals of this stop
  logic faded;  // the duty is below the start's
  logic load_step;
  logic began;
  logic failed;
  logic reverse;  // direction of this try
  logic turns_reverse;  // direction at the last update while observing
  logic clear_was;

  wire [2:0] either_279 = {1'b0, at_bits[3] ? 2'd3 : at_bits[2:1]} | {at_bits[4], 2'd0};
  wire [1:0] choice_279 = at_bits[6] ? 2'd2 : 2'd0;  // line 279
  wire [3:0] wide_279 =  // line 279
      {1'b0,
      either_279 | (at_bits[5] ? 3'd5 : 3'd0) | {choice_279[1], choice_279} | {3{at_bits[7]}}};
  wire [3:0] either_279_2 = wide_279 | {at_bits[8], 3'd0} | (at_bits[9] ? 4'd9 : 4'd0);  // line 279
  wire [4:0] either_295 = {3'd0, (drives ? 2'd2 : 2'd0) | {1'b0, !enables}} | {at_bits[2], 4'd0};
  wire both_300 = at_bits[8:7] != 2'd0 && source_i;  // line 300
  wire either = at_bits[6] || (at_bits[8:7] != 2'd0 && !source_i);
  wire inverse_319 = !reverse;  // line 319
  wire [2:0] choice_320 = (sector_i[2] ? sector_i[0] : !sector_i[1] && !sector_i[0]) ? 3'd4 : 3'd0;
  wire [1:0] choice_320_2 = (sector_i[0] ? sector_i[1] : sector_i[2]) ? 2'd2 : 2'd0;  // line 320
  wire [2:0] either_320 = choice_320 | {1'b0, choice_320_2} | {2'd0, !sector_i[0]};  // line 320
  wire [1:0] gentle = (retries[3:2] == 2'd0) ? retries[1:0] : 2'd3;  // line 315
  wire both = tick_i && last && !entered;
  wire either_143 = (at_bits[6] && both && !enough) || (at_bits[8:7] != 2'd0 && lost_i);
  wire either_80 = !(!at_bits[5] || fast_i || !both) || either_143;  // line 80
  wire choice_130 =  // line 130
      (!command_brake_to_stop_i || at_bits[8:7] != 2'd0) ? command_brake_to_stop_i :
      at_bits[2:1] != 2'd0;
  wire either_132 = command_run_i || choice_130;  // line 132
  wire both_135 = !fatal_i && either_132;  // line 135
  wire either_135 = at_bits[10] || !command_configured_i;  // line 135
  wire both_80 = !either_135 && both_135;  // line 80
  wire failed_next = both_80 && either_80;  // line 80
  wire [9:0] choice_171 = (failed_next && !tried) ? 10'd512 : 10'd0;  // line 171
  wire differ_80 = command_reverse_i ^ reverse;  // line 80
  wire either_159 = !command_run_i || differ_80;  // line 159
  wire either_141 = !at_bits[8] || lost_i;  // line 141
  wire both_80_2 = !either_141 && either_159 && (both || !fast_i);  // line 80
  wire differ_80_2 = turns_reverse ^ reverse;  // line 80
  wire both_140 = at_bits[1] && enough;  // line 140
  wire choice_80 = both_140 ? !command_run_i || differ_80_2 || both_80_2 : both_80_2;  // line 80
  wire braking_next = both_80 && choice_80;  // line 80
  wire both_133 = command_clear_fault_i && !clear_was && !(command_run_i || fatal_i);  // line 133
  wire both_134 = command_configured_i && fatal_i;  // line 134
  wire choice_137 = at_bits[10] ? !both_133 : both_134;  // line 137
  wire [10:0] choice =
      (choice_137 || (braking_next && braked) || (failed_next && tried)) ? 11'd1024 : 11'd0;
  wire either_114 = source_i || words_observe_i == 12'd0;  // line 114
  wire both_138 = at_bits[2] && both;  // line 138
  wire choice_80_2 = both_138 ? at_bits[9] || !(!command_run_i && either_114) : at_bits[9] && both;
  wire either_80_2 = at_bits[0] || choice_80_2;  // line 80
  wire both_80_3 = both_80 && either_80_2;  // line 80
  wire [3:0] choice_171_2 = (both_80_3 && (source_i ^ either_114)) ? 4'd8 : 4'd0;  // line 171
  wire [2:0] choice_171_3 = (braking_next && !braked) ? 3'd4 : 3'd0;  // line 171
  wire [1:0] choice_171_4 = (both_80_3 && !source_i && words_observe_i != 12'd0) ? 2'd2 : 2'd0;
  wire choice_136 = either_135 ? !at_bits[10] || both_133 : !(either_132 || fatal_i);  // line 136
  wire [7:0] choice_171_5 = (both_80_3 && source_i) ? 8'd128 : 8'd0;  // line 171
  wire [7:0] wide_187 = {6'd0, choice_171_4 | {1'b0, choice_136}};  // line 187
  wire inverse = !(enough || both);
  wire [1:0] choice_171_6 = (at_bits[1] && inverse) ? 2'd2 : 2'd0;  // line 171
  wire both_166 = at_bits[1] && !enough && both;  // line 166
  wire [1:0] wide_173 =  // line 173
      {1'b0,
      (both_166 && !command_run_i) ||
      (both_138 && !(command_run_i || (!source_i && words_observe_i != 12'd0)))};
  wire [2:0] choice_171_7 = (at_bits[2] && !both) ? 3'd4 : 3'd0;  // line 171
  wire [2:0] wide_174 = {1'b0, choice_171_6 | wide_173};  // line 174
  wire [3:0] choice_171_8 = ((both_166 && command_run_i) || (at_bits[3] && !both)) ? 4'd8 : 4'd0;
  wire [4:0] choice_171_9 = (both ? at_bits[3] : at_bits[4]) ? 5'd16 : 5'd0;  // line 171
  wire [4:0] wide_176 = {1'b0, {1'b0, wide_174 | choice_171_7} | choice_171_8};  // line 176
  wire [5:0] choice_171_10 =  // line 171
      ((at_bits[4] && both) || (at_bits[5] && !(fast_i || both))) ? 6'd32 : 6'd0;
  wire both_180 = at_bits[5] && fast_i;  // line 180
  wire [6:0] choice_171_11 = (both_180 || (at_bits[6] && inverse)) ? 7'd64 : 7'd0;  // line 171
  wire [6:0] wide_179 = {1'b0, {1'b0, wide_176 | choice_171_9} | choice_171_10};  // line 179
  wire either_182 = (both_140 && command_run_i && !differ_80_2) || (at_bits[6] && enough);
  wire both_182 = command_run_i && !differ_80;  // line 182
  wire both_169 = at_bits[8:7] != 2'd0 && !lost_i;  // line 169
  wire [7:0] choice_171_12 = ((either_182 || !both_169) ? either_182 : both_182) ? 8'd128 : 8'd0;
  wire [7:0] wide_181 = {1'b0, wide_179 | choice_171_11};  // line 181
  wire [8:0] choice_171_13 =  // line 171
      (both_169 && either_159 && (at_bits[7] || (!both && fast_i))) ? 9'd256 : 9'd0;
  wire [8:0] wide_182 = {1'b0, wide_181 | choice_171_12};  // line 182
  wire [9:0] choice_171_14 = (at_bits[9] && !both) ? 10'd512 : 10'd0;  // line 171
  wire [9:0] wanted = {1'b0, wide_182 | choice_171_13} | choice_171_14;  // line 183
  wire [9:0] choice_185 = (choice_136 || choice_137) ? 10'd0 : wanted;  // line 185
  wire [9:0] either_187 = {2'd0, wide_187 | choice_171_5} | choice_185;  // line 187
  wire [9:0] either_189 = {6'd0, choice_171_2 | {1'b0, choice_171_3}} | either_187;  // line 189
  wire [10:0] at_bits_next = {1'b0, choice_171} | choice | {1'b0, either_189};  // line 191
  wire either_102 = choice_185[6:5] != 2'd0 || either_187[7];  // line 102
  wire [12:0] change = {lags_i ? {1'b0, duty[15:5]} : ~{1'b0, duty[15:5]}, 1'b0} | {12'd0, !lags_i};
  wire [16:0] change_2 = {{4{change[12]}}, change};  // line 265
  wire [16:0] sum_266 = {duty, 1'b1} + change_2;  // line 266
  wire [15:0] choice_2 =
      (retries[3:1] == 3'd0) ? words_start_duty_i :
      words_start_duty_i[15] ? 16'd65535 :
      {words_start_duty_i[14:0], 1'b0};
  wire [6:0] sum_241 = {1'b0, good} + 7'd1;  // line 241

  always_ff @(posedge clk) begin
    at_bits <= at_bits_next;  // line 191
    drives <= either_102 || choice_185[8];
    enables <= either_102 || choice_185[8] || either_189[3:2] != 2'd0 || choice_185[4];
    boosts <= choice_185[6:5] != 2'd0;  // line 101
    if (at_bits[6]) begin
      if (commutate_i && !(lags_i && !faded)) begin
        duty <= sum_266[16:1];
      end
    end else if (at_bits[5]) begin
      duty <= choice_2;
    end else if (at_bits[4:3] == 2'd0) begin
      if (at_bits[2]) begin
        duty <= words_brake_duty_i;
      end else begin
        duty <= 16'd0;
      end
    end else if (retries[3:1] == 3'd0) begin
      duty <= words_reset_duty_i;
    end else if (words_reset_duty_i[15]) begin
      duty <= 16'd65535;
    end else begin
      duty <= {words_reset_duty_i[14:0], 1'b0};
    end
    if (both_80) begin
      logic choice_144;
      logic choice_144_2;
      logic either_144;
      logic inverse_152;
      choice_144 = either_141 ? at_bits[8] : both_182 || !fast_i;  // line 144
      choice_144_2 = at_bits[7] ? lost_i || !command_run_i || differ_80 || choice_144 : choice_144;
      either_144 = both_180 || choice_144_2;  // line 144
      inverse_152 = !(!at_bits[0] && (!both || (at_bits & 11'h481) != 11'd0));  // line 152
      entered <= inverse_152 || (enough && (at_bits[6:1] & 6'h21) != 6'd0) || either_144;
    end else begin
      entered <=
          (at_bits & 11'h401) == 11'd0 || (at_bits[0] && both_134) || (at_bits[10] && both_133);
    end
    late <= tick_i && entered;  // line 218
    last <= !entered && ticks == 15'd0;  // line 219
    tried <= (words_retries_i <= retries);  // line 225
    if (at_bits[10]) begin
      braking <= 1'b0;
      began <= 1'b0;
      failed <= 1'b0;
    end else begin
      logic both_80_4;
      logic both_80_5;
      logic both_80_6;
      logic both_83;
      logic both_80_7;
      both_80_4 = command_configured_i && both_135;  // line 80
      both_80_5 = both_80_4 && choice_80;  // line 80
      both_80_6 = both_80_4 && either_80_2;  // line 80
      both_83 = both_80_6 && at_bits[0];  // line 83
      both_80_7 = both_80_4 && either_80;  // line 80
      braking <= both_80_5;
      if (both_83) begin
        reason <= Reason_kNone;
        reverse <= command_reverse_i;
      end else begin
        if (both_80_7 || at_bits_next[10]) begin
          if (both_80_5) begin
            reason <= Reason_kCannotStop;
          end else if (fatal_i || lost_i) begin
            reason <= cause_i;
          end else begin
            reason <= Reason_kNoLock;
          end
        end
        if (both_80_6) begin
          reverse <= command_reverse_i;
        end
      end
      began <= both_83;
      failed <= both_80_7;
    end
    braked <= brakes == 8'd255;  // line 231
    if (entered) begin
      logic [14:0] wide_205;
      logic [14:0] once;
      logic [14:0] then;
      logic [14:0] once_2;
      logic [14:0] then_2;
      logic [14:0] either_206;
      logic [14:0] either_208;
      logic [14:0] either_209;
      logic [12:0] once_3;
      logic [14:0] then_3;
      wide_205 =  // line 205
          {3'd0, (at_bits[1] ? words_observe_i : 12'd0) | (at_bits[2] ? words_brake_i : 12'd0)};
      once = {3'd0, words_settle_i} << gentle[0];  // line 199
      then = gentle[1] ? {once[12:0], 2'd0} : once;  // line 200
      once_2 = {3'd0, words_reset_i} << gentle[0];  // line 199
      then_2 = gentle[1] ? {once_2[12:0], 2'd0} : once_2;  // line 200
      either_206 = wide_205 | (at_bits[3] ? then : 15'd0) | (at_bits[4] ? then_2 : 15'd0);
      either_208 =  // line 208
          either_206 | {3'd0, at_bits[6] ? words_pull_in_i : 12'd0} |
          {3'd0, at_bits[8] ? words_slow_down_i : 12'd0};
      either_209 =  // line 209
          either_208 | {3'd0, at_bits[9] ? words_rest_i : 12'd0} | {4'd0, at_bits[7], 10'd0};
      once_3 = gentle[0] ? 13'd8190 : 13'd4095;  // line 199
      then_3 = gentle[1] ? {once_3, 2'd0} : {2'd0, once_3};  // line 200
      ticks <= either_209 | (at_bits[5] ? then_3 : 15'd0);
      good <= 6'd0;
      enough <= 1'b0;
    end else begin
      if ((tick_i || late) && ticks != 15'd0) begin
        ticks <= ticks - 15'd1;
      end
      if (update_i) begin
        if (at_bits[1] && (turns_reverse_i ^ turns_reverse)) begin
          good <= 6'd0;
          enough <= 1'b0;
        end else begin
          if (good_i) begin
            good <= sum_241[5:0];
          end else begin
            good <= 6'd0;
          end
          enough <= good_i && nearly;
        end
        turns_reverse <= turns_reverse_i;
      end else begin
        enough <= 1'b0;
      end
    end
    nearly <= ({1'b0, words_good_crossings_i} <= sum_241);  // line 241
    if (at_bits[0] || (both && at_bits[7])) begin
      retries <= 4'd0;
    end else if (failed) begin
      retries <= retries + 4'd1;
    end
    if ((at_bits[7:0] & 8'h81) == 8'd0) begin
      if (braking) begin
        brakes <= brakes + 8'd1;
      end
    end else begin
      brakes <= 8'd0;
    end
    faded <= duty < choice_2;  // line 257
    if (at_bits[5]) begin
      load_step <= at_bits[1] && either_187[7];
    end else if (choice_185[5] || !at_bits[1]) begin
      load_step <= choice_185[5];
    end else begin
      load_step <= either_187[7];
    end
    clear_was <= command_clear_fault_i;
    if (rst) begin
      at_bits <= 11'd1;
      drives <= 1'b0;
      enables <= 1'b0;
      boosts <= 1'b0;
      duty <= 16'd0;
      entered <= 1'b0;
      late <= 1'b0;
      last <= 1'b0;
      tried <= 1'b0;
      braking <= 1'b0;
      braked <= 1'b0;
      reason <= Reason_kNone;
      ticks <= 15'd0;
      good <= 6'd0;
      nearly <= 1'b0;
      enough <= 1'b0;
      retries <= 4'd0;
      brakes <= 8'd0;
      faded <= 1'b0;
      load_step <= 1'b0;
      began <= 1'b0;
      failed <= 1'b0;
      reverse <= 1'b0;
      turns_reverse <= 1'b0;
      clear_was <= 1'b0;
    end
  end

  assign state_o = either_279_2 | (at_bits[10] ? 4'd10 : 4'd0);
  assign reason_o = reason;
  assign enable_o = enables;
  assign pattern_bits_o = either_295 | {2'd0, at_bits[3], 2'd0} | {1'b0, at_bits[4], 3'd0};
  assign reverse_o = reverse;
  assign running_o = at_bits[8:7] != 2'd0;
  assign mode_o =
      (at_bits[8:7] == 2'd0) ? ((at_bits[1] || boosts) ? SpeedMode_kAboveBemf : SpeedMode_kFixed) :
      SpeedMode_kControl;
  assign duty_o = duty;
  assign stop_o = at_bits[8];
  assign watch_o =
      (at_bits[1] || both_300) ? Evidence_kSectors :
      either ? Evidence_kCrossings :
      Evidence_kNothing;
  assign loop_o =
      at_bits[1] ? Loop_kCatch :
      both_300 ? Loop_kHall :
      either ? Loop_kTrack :
      at_bits[5] ? Loop_kRamp :
      Loop_kStop;
  assign load_step_o = load_step;
  assign step_o =
      at_bits[5] ? {1'b0, {2{inverse_319}}} :
      reverse ? sector_i :
      either_320;
  assign turn_vco_o = at_bits[1] || drives;
  assign gentle_o = gentle;
  assign began_o = began;
  assign failed_o = failed;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_ramp_i, words_hand_over_i, words_window_i, sum_266[0]};
endmodule
